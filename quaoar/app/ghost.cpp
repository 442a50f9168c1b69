#include "ghost.hpp"

namespace quaoar {

using atlax::Vec2;

namespace {

/// Requires before anything is made.
std::shared_ptr<const Recording> matching(const Level& level,
                                          std::shared_ptr<const Recording> recording) {
    requireMatch(level, *recording);
    return recording;
}

}  // namespace

Ghost::Ghost(std::shared_ptr<const Level> level, std::shared_ptr<const Recording> recording)
    : recording_(matching(*level, std::move(recording))),
      session_(std::move(level)),
      playback_(recording_),
      playbackAtStart_(recording_) {
    while (session_.timerTicks() == 0 && !playback_.done()) session_.tick(playback_.next());
    start_ = session_.snapshot();
    playbackAtStart_ = playback_;
}

void Ghost::restart() {
    session_.restore(*start_);
    playback_ = playbackAtStart_;
}

void Ghost::tick() {
    if (!playback_.done() && session_.phase() == Session::Phase::playing)
        session_.tick(playback_.next());
}

void Ghost::draw(atlax::Canvas& canvas, double alpha, atlax::Color color) const {
    if (playback_.done() || session_.phase() != Session::Phase::playing) return;
    const sulfur::World& world = session_.world();
    const Vec2 middle(world.interpolated(session_.hand(), alpha));
    std::vector<Vec2> rope;
    for (const sulfur::ParticleId bead : session_.rope().particles())
        rope.emplace_back(world.interpolated(bead, alpha));
    if (!rope.empty()) {
        rope.push_back(middle);
        canvas.polyline(rope, 0.02f, color.withAlpha(0.35f));
    }
    std::vector<Vec2> outline;
    for (const sulfur::ParticleId particle : world.particles(session_.hero()))
        if (particle != session_.hand()) outline.emplace_back(world.interpolated(particle, alpha));
    if (outline.size() < 3) return;
    canvas.polygon(outline, color.withAlpha(0.3f));
    canvas.polyline(outline, 0.018f, color.withAlpha(0.7f), true);
    for (const float side : {-0.035f, 0.035f})
        canvas.circle(middle + Vec2{side, 0.03f}, 0.016f, color.withAlpha(0.8f));
}

}  // namespace quaoar
