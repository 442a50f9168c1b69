// What moves only in the picture: camera, scarf, antenna, sparks.
#include <algorithm>
#include <cmath>
#include <quaoar/view/game_view.hpp>

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

namespace {
constexpr float tickSeconds = 1.0f / Session::tickRate;
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
    if (events.restarted) {
        cut();
        return;
    }
    const Vec2 hero(session_.heroPosition());
    const Vec2 head(session_.rope().head(session_.world()));
    if (events.stuck) burst(head, 12, 1.3f, palette::amber);
    if (events.slipped) burst(head, 10, 1.6f, palette::frost);
    if (events.impact > 2.2f) {
        burst(hero - Vec2{0, 0.1f}, static_cast<int>(events.impact * 2.5f), 0.25f * events.impact,
              palette::frost);
        follow_.shake((events.impact - 3) * 0.16f);
    }
    if (events.finished) burst(Vec2(session_.level().exit.position), 90, 3.2f, palette::glow);
    follow_.tick();
    moveTrails();
    moveSparks();
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
        now += moved + pull * (tickSeconds * tickSeconds);
    }
    for (std::size_t i = 1; i < scarf_.now.size(); ++i) {
        const Vec2 way = scarf_.now[i] - scarf_.now[i - 1];
        const float apart = atlax::length(way);
        if (apart > segment) scarf_.now[i] = scarf_.now[i - 1] + way * (segment / apart);
    }
    const Vec2 rest = hero + Vec2{0.02f, 0.205f};
    antennaVelocity_ += ((rest - antenna_) * 900 - antennaVelocity_ * 14) * tickSeconds;
    antenna_ += antennaVelocity_ * tickSeconds;
    const Vec2 root = hero + Vec2{0, 0.1f};
    const Vec2 way = antenna_ - root;
    const float apart = atlax::length(way);
    if (apart > 0.14f) antenna_ = root + way * (0.14f / apart);
}

void GameView::moveSparks() {
    for (Spark& spark : sparks_) {
        spark.life -= tickSeconds;
        spark.velocity.y -= 4.0f * tickSeconds;
        spark.velocity *= 0.996f;
        spark.position += spark.velocity * tickSeconds;
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
        canvas.circle(spark.position, spark.size * (0.4f + 0.6f * fade),
                      spark.color.withAlpha(fade));
    }
    canvas.setBlend(atlax::Blend::Alpha);
}

}  // namespace quaoar
