// What moves only in the picture: camera, scarf, antenna, sparks.
#include <algorithm>
#include <cmath>
#include <quaoar/view/game_view.hpp>

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

namespace {
constexpr float viewTick = 1.0f / Session::tickRate;
}

float GameView::random() {
    dice_ ^= dice_ << 13;
    dice_ ^= dice_ >> 17;
    dice_ ^= dice_ << 5;
    return static_cast<float>(dice_ >> 8) * (1.0f / 16777216.0f);
}

void GameView::tick() {
    ++time_;
    const TickEvents& events = session_.events();
    if (events.restarted || events.died) {
        cut();
        if (events.died) burst(Vec2(events.diedAt), 60, 2.6f, palette::amber);
        return;
    }
    notice();
    follow_.tick();
    moveTrails();
    moveSparks();
    moveMood();
    moveRopes();
    breathe();
}

/// Sparks, chips and dust of what has happened.
void GameView::notice() {
    const TickEvents& events = session_.events();
    const Vec2 hero(session_.heroPosition());
    const Vec2 head(session_.rope().head(session_.world()));
    if (events.stuck) burst(head, 12, 1.3f, palette::amber);
    if (events.slipped)
        burst(lastRope_.empty() ? head : lastRope_.front(), 10, 1.6f, palette::frost);
    if (events.impact > 2.2f) {
        burst(hero - Vec2{0, 0.1f}, static_cast<int>(events.impact * 2.5f), 0.25f * events.impact,
              palette::frost);
        follow_.shake((events.impact - 3) * 0.16f);
    }
    if (events.pickedUp) burst(hero, 40, 2.2f, palette::glow);
    if (events.checkpoint) burst(hero + Vec2{0, 0.4f}, 46, 1.8f, palette::amber);
    if (events.cut && !lastRope_.empty())
        burst(lastRope_[lastRope_.size() / 2], 24, 2, palette::danger);
    if (events.finished) burst(Vec2(session_.level().exit.position), 90, 3.2f, palette::glow);
    int chips = 0;
    for (const sulfur::JointBroken& broken : session_.world().events().jointsBroken)
        if (++chips <= 12) burst(Vec2(broken.point), 5, 1.2f, palette::frost);
    if (events.missed || events.slipped || events.cut) dropRope(lastRope_, false);
    if (events.released) dropRope(lastRope_, true);
    if (events.missed) reachFlash_ = 1;
}

/// Fear when falling or flying fast, effort while the rope strains, joy over what was reached.
void GameView::moveMood() {
    const TickEvents& events = session_.events();
    const Vec2 velocity(session_.heroVelocity());
    const bool held = session_.rope().state() == Rope::State::attached;
    const float falls = held ? 0.0f : std::max(0.0f, -velocity.y - 2.5f) / 3.5f;
    const float rushes = std::max(0.0f, length(velocity) - 5.5f) / 3.5f;
    const float fear = std::clamp(std::max(falls, rushes), 0.0f, 1.0f);
    mood_.fear += (fear > mood_.fear ? 0.02f : 0.006f) * (fear - mood_.fear);
    const float effort = std::clamp((strain_ - 0.22f) * 2.2f, 0.0f, 1.0f);
    mood_.effort += 0.02f * (effort - mood_.effort);
    if (events.pickedUp || events.checkpoint) mood_.joy = 1;
    const bool finished = session_.phase() == Session::Phase::finished;
    mood_.joy = finished ? 1 : std::max(0.0f, mood_.joy - viewTick * 0.8f);
}

/// A small cloud now and then; more when he is out of breath.
void GameView::breathe() {
    const std::uint64_t every = mood_.effort > 0.4f || mood_.fear > 0.4f ? 450 : 1150;
    if (time_ % every > 70 || time_ % 14 != 0) return;
    const Vec2 way = normalized(Vec2(session_.aim()) + Vec2{0, 0.35f});
    Spark puff;
    puff.mist = true;
    puff.position = Vec2(session_.heroPosition()) + Vec2{0, -0.02f} + way * 0.09f;
    puff.velocity = way * (0.25f + 0.2f * random()) + Vec2(session_.heroVelocity()) * 0.3f;
    puff.lasts = puff.life = 0.9f + 0.4f * random();
    puff.size = 0.05f + 0.03f * random();
    puff.color = palette::frost.withAlpha(0.20f);
    sparks_.push_back(puff);
}

void GameView::moveTrails() {
    const Vec2 hero(session_.heroPosition());
    // It streams behind the hero's back, slack enough to flutter.
    const float back = session_.aim().x() > 0 ? -1.0f : 1.0f;
    const float gust = std::sin(static_cast<float>(time_ % 100000) * 0.009f);
    const Vec2 pull{back * (2.2f + gust), -0.9f + 0.9f * gust};
    scarf_.now[0] = hero + Vec2{back * 0.09f, -0.055f};
    constexpr float segment = 0.027f;
    for (std::size_t i = 1; i < scarf_.now.size(); ++i) {
        Vec2& now = scarf_.now[i];
        const Vec2 moved = (now - scarf_.before[i]) * 0.985f;
        scarf_.before[i] = now;
        now += moved + pull * (viewTick * viewTick);
    }
    for (std::size_t i = 1; i < scarf_.now.size(); ++i) {
        const Vec2 way = scarf_.now[i] - scarf_.now[i - 1];
        const float apart = atlax::length(way);
        if (apart > segment) scarf_.now[i] = scarf_.now[i - 1] + way * (segment / apart);
    }
    const Vec2 rest = hero + Vec2{0.02f, 0.205f};
    antennaVelocity_ += ((rest - antenna_) * 900 - antennaVelocity_ * 14) * viewTick;
    antenna_ += antennaVelocity_ * viewTick;
    const Vec2 root = hero + Vec2{0, 0.1f};
    const Vec2 way = antenna_ - root;
    const float apart = atlax::length(way);
    if (apart > 0.14f) antenna_ = root + way * (0.14f / apart);
}

void GameView::moveSparks() {
    for (Spark& spark : sparks_) {
        spark.life -= viewTick;
        if (spark.mist) {
            spark.velocity *= 0.994f;
            spark.velocity.y += 0.25f * viewTick;
        } else {
            spark.velocity.y -= 4.0f * viewTick;
            spark.velocity *= 0.996f;
        }
        spark.position += spark.velocity * viewTick;
    }
    std::erase_if(sparks_, [](const Spark& spark) { return spark.life <= 0; });
}

void GameView::burst(Vec2 at, int count, float speed, Color color) {
    for (int i = 0; i < count && sparks_.size() < 400; ++i) {
        const float angle = random() * 6.2832f;
        Spark spark;
        spark.position = at;
        spark.velocity = Vec2{std::cos(angle), std::sin(angle) + 0.3f} * (speed * random());
        spark.lasts = 0.3f + 0.5f * random();
        spark.life = spark.lasts;
        spark.size = 0.008f + 0.014f * random();
        spark.color = color;
        sparks_.push_back(spark);
    }
}

void GameView::drawSparks(atlax::Canvas& canvas) {
    canvas.setBlend(atlax::Blend::Additive);
    for (const Spark& spark : sparks_) {
        const float fade = spark.life / spark.lasts;
        if (spark.mist) {
            const float age = 1 - fade;
            canvas.glow(spark.position, spark.size * (1 + 3 * age),
                        spark.color.faded(std::min(1.0f, age * 6) * fade));
            continue;
        }
        canvas.circle(spark.position, spark.size * (0.4f + 0.6f * fade),
                      spark.color.withAlpha(fade));
    }
    canvas.setBlend(atlax::Blend::Alpha);
}

}  // namespace quaoar
