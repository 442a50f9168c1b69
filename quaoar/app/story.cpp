#include "story.hpp"

#include <algorithm>
#include <string>

namespace quaoar {
namespace {

constexpr float fadeSeconds = 0.6f;
constexpr float barShare = 0.1f;  // of the height, above and below

/// What is seen of a picture, and what the hero does in it.
struct Scene {
    double seconds;      ///< for which it is shown
    atlax::Vec2 centre;  ///< m, of the view
    atlax::Vec2 aim;     ///< where the arm points
    double fire;         ///< s at which the rope is shot and held; negative: never
    double reel;         ///< s at which he begins to reel in
};

constexpr std::array<Scene, Story::pictures> scenes{
    {{4.5, {0.2f, 1.1f}, {0.7f, 0.7f}, -1, -1},        // at home, looking at the moon
     {3.4, {0.1f, 0.5f}, {0.1f, 1}, -1, -1},           // the ice breaks
     {4.5, {0.5f, 1.9f}, {0.6f, 0.8f}, -1, -1},        // far below, a light
     {5.0, {0.5f, 1.9f}, {0.38f, 0.92f}, 0.8, 1.5}}};  // the rope

}  // namespace

Story::Story(Art& art, Levels levels) : art_(&art), levels_(std::move(levels)) {
    open();
}

Story::Levels Story::levels() {
    const atlax::Assets assets = levelAssets();
    Levels found;
    for (std::size_t i = 0; i < found.size(); ++i)
        found[i] = std::make_shared<const Level>(
            readLevel(assets.find("story/" + std::to_string(i + 1) + ".json")));
    return found;
}

void Story::open() {
    ticks_ = 0;
    view_.reset();
    session_.reset();
    if (over()) return;
    session_ = std::make_unique<Session>(levels_[picture_]);
    remake(*art_);
}

void Story::remake(Art& art) {
    art_ = &art;
    if (over()) return;
    view_.reset();
    view_ = std::make_unique<GameView>(art, *session_);
    view_->lookAt(scenes[picture_].centre);
}

void Story::tick() {
    if (over()) return;
    const Scene& scene = scenes[picture_];
    const double now = static_cast<double>(ticks_) / Session::tickRate;
    TickInput input;
    setAim(input, static_cast<double>(scene.aim.x), static_cast<double>(scene.aim.y));
    input.fire = scene.fire >= 0 && now >= scene.fire;
    input.reelIn = input.fire && now >= scene.reel;
    input.push = input.reelIn ? 127 : 0;
    session_->tick(input);
    view_->tick();
    view_->lookAt(scene.centre);
    if (++ticks_ >= static_cast<int>(scene.seconds * Session::tickRate)) next();
}

void Story::next() {
    if (over()) return;
    ++picture_;
    open();
}

/// 0 in the dark between two pictures, 1 in the light.
float Story::light() const {
    const float now = static_cast<float>(ticks_) / Session::tickRate;
    const auto all = static_cast<float>(scenes[picture_].seconds);
    return std::clamp(std::min(now, all - now) / fadeSeconds, 0.0f, 1.0f);
}

void Story::draw(atlax::Canvas& canvas, double alpha, const ViewOptions& options) {
    const atlax::Vec2 size = canvas.size().toVec();
    if (over()) return canvas.clear(atlax::colors::black);
    ViewOptions seen = options;
    seen.aim = false;
    view_->draw(canvas, alpha, seen);
    canvas.setScreenSpace();
    canvas.rect({{0, 0}, size}, atlax::colors::black.withAlpha(1 - light()));
    canvas.rect({{0, 0}, {size.x, size.y * barShare}}, atlax::colors::black);
    canvas.rect({{0, size.y * (1 - barShare)}, {size.x, size.y * barShare}}, atlax::colors::black);
}

}  // namespace quaoar
