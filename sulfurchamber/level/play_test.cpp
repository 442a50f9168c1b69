#include "play_test.hpp"

#include <array>
#include <atlax/backend.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <atlax/settings.hpp>
#include <cstdio>

#include "../model/words.hpp"

namespace sulfurchamber {

std::shared_ptr<const quaoar::Level> startingAt(const quaoar::Level& level,
                                                const sulfur::Point& place) {
    auto made = std::make_shared<quaoar::Level>(level);
    made->spawn = place;
    return made;
}

PlayTest::PlayTest(std::shared_ptr<const quaoar::Level> level, quaoar::Art& art,
                   const quaoar::GameView* like)
    : art_(art),
      session_(std::move(level)),
      view_(art, session_, like),
      recording_(session_.level()) {}

void PlayTest::start(atlax::Platform& platform) {
    platform_ = &platform;
    const auto file = atlax::configFolder("quaoar") / "settings.json";
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) {
        atlax::Settings settings({.file = file});
        settings.load();
        for (const std::string& problem : actions_.all.load(settings))
            atlax::log(atlax::LogLevel::Warning, problem);
        actions_.mend();
    }
    actions_.all.setContext("play");
    controls_.reset();
}

atlax::Vec2 PlayTest::pixelsOf(const sulfur::Point& place) const {
    return view_.camera(platform_->size()).toScreen(atlax::Vec2(place), platform_->size());
}

quaoar::TickInput PlayTest::input(const atlax::ActionState& state) {
    const quaoar::PlayerSight sight{view_.camera(platform_->size()), platform_->size(),
                                    atlax::Vec2(session_.heroPosition()),
                                    session_.rope().state() != quaoar::Rope::State::idle};
    return controls_.read(state, platform_->input(), sight);
}

void PlayTest::remember(const quaoar::TickInput& input) {
    if (session_.events().restarted) {
        recording_.clear();
        told_ = false;
        view_.cut();
        return;
    }
    if (told_) return;
    recording_.append(input);
    if (!session_.events().finished) return;
    told_ = true;
    recording_.finalHash = session_.hash();
    if (onFinish) onFinish(recording_);
}

void PlayTest::tick() {
    // Not before the first picture, which shall come at once.
    if (!sounds_) sounds_ = std::make_unique<quaoar::Sounds>(platform_->audio());
    const atlax::ActionState& state = actions_.all.sample(platform_->input());
    // After the finish the restart key begins anew, as on the game's own screen.
    if (session_.phase() == quaoar::Session::Phase::finished &&
        state.wasPressed(actions_.restart)) {
        session_.restart();
        recording_.clear();
        told_ = false;
        view_.cut();
        return;
    }
    const quaoar::TickInput now = input(state);
    session_.tick(now);
    view_.tick();
    sounds_->tick(session_);
    remember(now);
}

void PlayTest::draw(atlax::Canvas& canvas, double alpha) {
    const std::int64_t now = atlax::monotonicNs();
    if (lastFrameNs_ != 0) governor_.frame(static_cast<double>(now - lastFrameNs_) * 1e-9);
    lastFrameNs_ = now;
    ++frames_;
    quaoar::ViewOptions options;
    options.quality = governor_.quality();
    if (controls_.mouseAims()) options.crosshair = platform_->input().mouse;
    view_.draw(canvas, alpha, options);
    drawStatus(canvas);
}

// The time, and how one comes back.
void PlayTest::drawStatus(atlax::Canvas& canvas) const {
    const float scale = canvas.scaleFactor();
    canvas.setScreenSpace(scale);
    const float middle = canvas.size().toVec().x / scale / 2;
    canvas.text(art_.bold(), fixed(session_.seconds(), 1) + " s", {middle, 34},
                {24, quaoar::palette::frost, atlax::AlignX::Centre});
    const bool finished = session_.phase() == quaoar::Session::Phase::finished;
    const std::string medal = finished ? quaoar::name(session_.medal()) : "";
    const std::string below = finished ? tr("Finished: {}. Esc goes back to editing",
                                            {tr(medal == "none" ? "no medal" : medal)})
                                       : tr("Play-test: Esc goes back to editing");
    canvas.text(
        art_.regular(), below, {middle, 54},
        {14, finished ? quaoar::palette::amber : quaoar::palette::ice, atlax::AlignX::Centre});
}

void PlayTest::stop() {
    if (sounds_) sounds_->hush();
    sounds_.reset();
    platform_ = nullptr;
}

}  // namespace sulfurchamber
