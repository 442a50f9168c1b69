#include "backdrop.hpp"

#include <array>
#include <cmath>

#include "dice.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

Backdrop::Backdrop(const Level& level) : theme_(level.theme) {
    anchor_ = Vec2((level.boundsMin + level.boundsMax) * 0.5);
    width_ = static_cast<float>(level.boundsMax.x() - level.boundsMin.x());
    Dice dice(theme_.seed);
    for (int i = 0; i < 260; ++i) {
        const float rare = dice.unit();
        stars_.push_back({{dice.unit(), dice.unit() * 0.9f},
                          0.5f + 1.4f * rare * rare * rare,
                          dice.between(0, 6.28f),
                          dice.between(0.25f, 1)});
    }
    const Color sky = Color::hex(theme_.skyBottom);
    const Color night = Color::hex(theme_.skyTop);
    makeRidge(0.10f, -0.35f, 1.15f, 0.16f, mix(sky, palette::ice, 0.16f), sky, 11);
    makeRidge(0.22f, -0.75f, 1.05f, 0.13f, mix(sky, palette::ice, 0.02f), mix(sky, night, 0.4f),
              23);
    makeRidge(0.42f, -1.25f, 1.0f, 0.11f, mix(sky, night, 0.35f), mix(sky, night, 0.8f), 37);
}

/// Crests by summed waves of falling size whose signs are folded, which gives peaks, not dunes.
void Backdrop::makeRidge(float parallax, float base, float height, float step, Color top,
                         Color foot, std::uint32_t seed) {
    Ridge ridge;
    ridge.parallax = parallax;
    ridge.rim = mix(top, palette::frost, 0.35f);
    Dice dice(theme_.seed * 101 + seed);
    std::array<float, 5> phase{};
    for (float& p : phase) p = dice.between(0, 6.28f);
    const float reach = width_ * parallax / 2 + 8;
    for (float x = -reach; x <= reach; x += step * dice.between(0.6f, 1.4f)) {
        float y = 0, size = 0.5f, rate = 0.55f;
        for (const float p : phase) {
            y += size * (1 - 2 * std::abs(std::sin(x * rate + p)));
            size *= 0.52f;
            rate *= 2.13f;
        }
        ridge.crest.push_back(anchor_ + Vec2{x, base + height * (0.45f + 0.62f * y)});
    }
    for (std::size_t i = 0; i < ridge.crest.size(); ++i) {
        const Vec2 p = ridge.crest[i];
        const Vec2 slope = normalized(ridge.crest[std::min(i + 1, ridge.crest.size() - 1)] - p);
        const Color lit = slope.y > 0 ? mix(top, palette::frost, 0.16f * slope.y)
                                      : mix(top, foot, -0.55f * slope.y);
        const auto first = static_cast<std::uint32_t>(ridge.vertices.size());
        const float below = anchor_.y + base - 0.6f;
        ridge.vertices.push_back({p, {}, lit});
        ridge.vertices.push_back({{p.x, std::min(below, p.y - 0.1f)}, {}, foot});
        ridge.vertices.push_back({{p.x, anchor_.y - 8}, {}, foot});
        if (first == 0) continue;
        for (const std::uint32_t k : {0u, 1u}) {
            const std::uint32_t a = first - 3 + k, b = first + k;
            ridge.indices.insert(ridge.indices.end(), {a, a + 1, b, b, a + 1, b + 1});
        }
    }
    ridges_.push_back(std::move(ridge));
}

void Backdrop::drawBehind(atlax::Canvas& canvas, Art& art, const atlax::Camera& camera,
                          double seconds) {
    drawSky(canvas, art, seconds);
    const atlax::PixelSize size = canvas.size();
    const Vec2 screen = size.toVec();
    canvas.setBlend(atlax::Blend::Additive);
    canvas.sprite(art.light(), {screen.x * 0.5f, screen.y * 0.86f}, {screen.x * 1.5f, screen.y},
                  {.tint = palette::ice.withAlpha(0.20f)});
    canvas.setBlend(atlax::Blend::Alpha);
    for (const Ridge& ridge : ridges_) {
        canvas.setCamera(camera.parallax(ridge.parallax, anchor_));
        canvas.mesh({}, ridge.vertices, ridge.indices);
        canvas.polyline(ridge.crest, 2 * canvas.pixel(), ridge.rim.withAlpha(0.55f));
        canvas.setScreenSpace();
        canvas.setBlend(atlax::Blend::Additive);
        const float drift = static_cast<float>(std::fmod(seconds * 4, 1e4)) * ridge.parallax;
        canvas.sprite(art.light(),
                      {screen.x * (0.3f + 0.4f * std::sin(drift * 0.05f)), screen.y * 0.78f},
                      {screen.x * 1.6f, screen.y * 0.5f}, {.tint = palette::ice.withAlpha(0.07f)});
        canvas.setBlend(atlax::Blend::Alpha);
    }
}

void Backdrop::drawSky(atlax::Canvas& canvas, Art& art, double seconds) const {
    canvas.setScreenSpace();
    const Vec2 screen = canvas.size().toVec();
    canvas.gradientRect({{0, 0}, screen}, Color::hex(theme_.skyTop), Color::hex(theme_.skyBottom));
    canvas.setBlend(atlax::Blend::Additive);
    const float unit = screen.y / 720;
    for (const Star& star : stars_) {
        const float twinkle =
            0.75f +
            0.25f * static_cast<float>(std::sin(seconds * 1.7 + static_cast<double>(star.phase)));
        canvas.circle({star.place.x * screen.x, star.place.y * screen.y}, star.size * unit,
                      palette::frost.withAlpha(0.8f * star.brightness * twinkle));
    }
    // The Sun: from here only the brightest of the stars.
    const Vec2 sun{screen.x * 0.17f, screen.y * 0.16f};
    canvas.sprite(art.light(), sun, Vec2{170, 170} * unit, {.tint = palette::glow.withAlpha(0.5f)});
    canvas.sprite(art.light(), sun, Vec2{26, 26} * unit, {.tint = palette::frost});
    canvas.setBlend(atlax::Blend::Alpha);
    drawRing(canvas);
    const Vec2 moon{screen.x * 0.79f, screen.y * 0.2f};
    canvas.setBlend(atlax::Blend::Additive);
    canvas.sprite(art.light(), moon, Vec2{330, 330} * unit, {.tint = palette::ice.withAlpha(0.3f)});
    canvas.setBlend(atlax::Blend::Alpha);
    canvas.sprite(art.picture("moon.svg"), moon, Vec2{104, 104} * unit);
}

/// Quaoar has rings; from its surface they stand in the sky as thin bright arcs.
void Backdrop::drawRing(atlax::Canvas& canvas) const {
    const Vec2 screen = canvas.size().toVec();
    const float unit = screen.y / 720;
    for (int band = 0; band < 5; ++band) {
        std::vector<Vec2> arc;
        const float lift = static_cast<float>(band) * 9 + (band > 2 ? 22.0f : 0.0f);
        for (int i = 0; i <= 48; ++i) {
            const float t = static_cast<float>(i) / 48;
            arc.push_back({screen.x * (-0.05f + 1.1f * t),
                           screen.y * 0.5f - unit * (lift + 250 * 4 * t * (1 - t) + 70 * t)});
        }
        const float width = (band == 1 ? 5.0f : band == 4 ? 3.0f : 1.6f) * unit;
        canvas.polyline(arc, width, palette::frost.withAlpha(band == 1 ? 0.13f : 0.08f));
    }
}

void Backdrop::drawSnow(atlax::Canvas& canvas, const atlax::Camera& camera, double seconds,
                        bool before) const {
    const atlax::Rect view = camera.view(canvas.size());
    Dice dice(theme_.seed + (before ? 5 : 6));
    canvas.setCamera(camera);
    canvas.setBlend(atlax::Blend::Additive);
    for (int i = 0; i < (before ? 14 : 130); ++i) {
        const float depth = before ? dice.between(1.4f, 2.2f) : dice.between(0.5f, 1.4f);
        const float width = view.size.x + 1, height = view.size.y + 1;
        const double x = static_cast<double>(dice.between(0, 100)) -
                         seconds * 0.16 * static_cast<double>(depth) +
                         0.12 * std::sin(seconds * 0.7 + i);
        const double y =
            static_cast<double>(dice.between(0, 100)) - seconds * 0.11 * static_cast<double>(depth);
        // Flakes belong to the world but come back on the other side of the screen.
        const auto wrap = [](double value, float low, float span) {
            const double part =
                std::fmod(value - static_cast<double>(low), static_cast<double>(span));
            return low + static_cast<float>(part < 0 ? part + static_cast<double>(span) : part);
        };
        const Vec2 at{wrap(x, view.min.x - 0.5f, width), wrap(y, view.min.y - 0.5f, height)};
        canvas.circle(at, 0.007f * depth, palette::frost.withAlpha(before ? 0.2f : 0.24f * depth));
    }
    canvas.setBlend(atlax::Blend::Alpha);
}

}  // namespace quaoar
