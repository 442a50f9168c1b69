#include "level_picture.hpp"

namespace sulfurchamber {
namespace {

// Without weather and foreground, which would stand still, and without the light of the lamp.
constexpr quaoar::Quality still{1, 0.5f, 0, false, true};

bool same(const atlax::Camera& a, const atlax::Camera& b) {
    return a.centre == b.centre && a.pixelsPerMetre == b.pixelsPerMetre;
}

}  // namespace

void LevelPicture::show(std::unique_ptr<quaoar::Session> session) {
    if (!fresh_) before_ = std::move(session_);
    session_ = std::move(session);
    fresh_ = true;
}

void LevelPicture::hide() {
    view_.reset();
    session_.reset();
    before_.reset();
    keptThrough_.reset();
    fresh_ = false;
}

void LevelPicture::forgetGraphics() {
    view_.reset();
    art_.reset();
    kept_ = {};
    keptThrough_.reset();
    fresh_ = session_ != nullptr;
}

quaoar::Art& LevelPicture::art(atlax::Canvas& canvas) {
    if (!art_) art_ = std::make_unique<quaoar::Art>(canvas);
    return *art_;
}

void LevelPicture::draw(atlax::Canvas& canvas, const atlax::Camera& camera) {
    if (!session_) return;
    if (fresh_ || !view_) {
        auto view = std::make_unique<quaoar::GameView>(art(canvas), *session_, view_.get());
        view_ = std::move(view);
        before_.reset();
        fresh_ = false;
        keptThrough_.reset();
    }
    const bool fits = kept_.valid() && kept_.size() == canvas.size();
    if (!fits) kept_ = canvas.createTarget(canvas.size());
    if (!fits || !keptThrough_ || !same(*keptThrough_, camera)) {
        view_->lookThrough(camera);
        canvas.pushTarget(kept_);
        canvas.clear(atlax::Color::hex(0));
        quaoar::ViewOptions options;
        options.aim = false;
        options.quality = still;
        view_->draw(canvas, 1, options);
        canvas.popTarget();
        keptThrough_ = camera;
    }
    canvas.setScreenSpace();
    canvas.drawTarget(kept_);
}

}  // namespace sulfurchamber
