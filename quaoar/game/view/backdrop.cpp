#include "backdrop.hpp"

#include <algorithm>
#include <cmath>

#include "dice.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

Backdrop::Backdrop(const Level& level) : theme_(level.theme), look_(lookOf(level.theme.world)) {
    anchor_ = Vec2((level.boundsMin + level.boundsMax) * 0.5);
    const auto width = static_cast<float>(level.boundsMax.x() - level.boundsMin.x());
    Dice dice(theme_.seed);
    for (int i = 0; i < 260; ++i) {
        const float rare = dice.unit();
        stars_.push_back({{dice.unit(), dice.unit() * 0.8f},
                          0.5f + 1.4f * rare * rare * rare,
                          dice.between(0, 6.28f),
                          dice.between(0.25f, 1)});
    }
    layers_ = makeLayers(theme_, anchor_, width);
}

void Backdrop::drawBehind(atlax::Canvas& canvas, Art& art, const atlax::Camera& camera,
                          double seconds, const Quality& quality) {
    if (quality.backdrop >= 1) {
        small_ = {};
        drawAll(canvas, art, camera, seconds);
        return;
    }
    const atlax::PixelSize full = canvas.size();
    const auto part = [&](int pixels) {
        return std::max(1, static_cast<int>(static_cast<float>(pixels) * quality.backdrop));
    };
    const atlax::PixelSize size{part(full.width), part(full.height)};
    if (!small_.valid() || small_.size() != size) small_ = canvas.createTarget(size);
    canvas.pushTarget(small_);
    const float scale = static_cast<float>(size.height) / static_cast<float>(full.height);
    drawAll(canvas, art, {camera.centre, camera.pixelsPerMetre * scale}, seconds);
    canvas.popTarget();
    canvas.setScreenSpace();
    canvas.setShader(art.plain());
    canvas.sprite(small_.texture(), full.toVec() * 0.5f, full.toVec());
    canvas.setShader({});
}

void Backdrop::drawAll(atlax::Canvas& canvas, Art& art, const atlax::Camera& camera,
                       double seconds) {
    drawSky(canvas, art, seconds);
    const Vec2 screen = canvas.size().toVec();
    for (const BackdropLayer& layer : layers_) {
        canvas.setCamera(camera.parallax(layer.parallax, anchor_));
        drawLayer(canvas, art, layer, seconds);
        // Mist in front of every layer.
        canvas.setScreenSpace();
        canvas.setBlend(atlax::Blend::Additive);
        const float drift = static_cast<float>(std::fmod(seconds * 4, 1e4)) * layer.parallax;
        canvas.setShader(art.plain());
        canvas.sprite(art.light(),
                      {screen.x * (0.3f + 0.4f * std::sin(drift * 0.05f)), screen.y * 0.8f},
                      {screen.x * 1.6f, screen.y * 0.6f}, {.tint = look_.haze.withAlpha(0.16f)});
        canvas.setShader({});
        canvas.setBlend(atlax::Blend::Alpha);
    }
    if (theme_.world == Theme::World::bog || theme_.world == Theme::World::deep)
        drawShafts(canvas, seconds);
}

void Backdrop::drawLayer(atlax::Canvas& canvas, Art& art, const BackdropLayer& layer,
                         double seconds) const {
    for (const BackdropLayer::Wheel& wheel : layer.wheels) {
        const auto turned =
            static_cast<float>(std::fmod(seconds * static_cast<double>(wheel.speed), 6.2831853));
        const Color light = mix(wheel.color, look_.horizon, 0.25f);
        canvas.circleOutline(wheel.at, wheel.radius * 0.92f, wheel.radius * 0.2f, wheel.color);
        for (int i = 0; i < wheel.teeth; ++i) {
            const float a =
                turned + 6.2831853f * static_cast<float>(i) / static_cast<float>(wheel.teeth);
            const Vec2 way{std::cos(a), std::sin(a)};
            canvas.line(wheel.at + way * (wheel.radius * 0.88f), wheel.at + way * wheel.radius,
                        0.09f, wheel.color);
            if (i % 3 == 0)
                canvas.line(wheel.at, wheel.at + way * (wheel.radius * 0.8f), 0.06f, wheel.color);
        }
        canvas.circle(wheel.at, wheel.radius * 0.2f, light);
        canvas.circle(wheel.at, wheel.radius * 0.1f, wheel.color);
    }
    canvas.mesh({}, layer.vertices, layer.indices);
    for (const auto& edge : layer.edges)
        canvas.polyline(edge, 1.6f * canvas.pixel(), layer.edgeColor.withAlpha(0.5f));
    canvas.setBlend(atlax::Blend::Additive);
    for (const BackdropLayer::Lamp& lamp : layer.lamps) {
        const auto t = static_cast<float>(std::fmod(seconds * 1.4, 6.2831853));
        canvas.glow(lamp.at, lamp.size * 0.5f,
                    lamp.color.faded(0.75f + 0.25f * std::sin(t + lamp.phase)));
    }
    canvas.setBlend(atlax::Blend::Alpha);
    (void)art;
}

void Backdrop::drawSky(atlax::Canvas& canvas, Art& art, double seconds) const {
    canvas.setScreenSpace();
    const Vec2 screen = canvas.size().toVec();
    const float unit = screen.y / 720;
    const Color top = Color::hex(theme_.skyTop), low = Color::hex(theme_.skyBottom);
    const float dusk = screen.y * 0.5f, ground = screen.y * 0.84f;
    canvas.gradientRect({{0, 0}, {screen.x, dusk}}, top, low);
    canvas.gradientRect({{0, dusk}, {screen.x, ground - dusk}}, low, mix(low, look_.horizon, 0.6f));
    canvas.rect({{0, ground}, {screen.x, screen.y - ground}}, mix(low, look_.horizon, 0.6f));
    if (look_.stars) drawStars(canvas, art, seconds);
    canvas.setBlend(atlax::Blend::Additive);
    // Light along the horizon, strongest below the Sun.
    canvas.setShader(art.plain());
    canvas.sprite(art.light(), {screen.x * 0.24f, ground}, {screen.x * 1.3f, screen.y * 0.75f},
                  {.tint = look_.horizon.withAlpha(0.5f)});
    canvas.setShader({});
    if (look_.sun) {
        const Vec2 sun{screen.x * 0.2f, screen.y * 0.27f};
        canvas.glow(sun, 210 * unit, look_.horizon.withAlpha(0.55f));
        canvas.glow(sun, 60 * unit, mix(look_.horizon, palette::glow, 0.7f));
        canvas.circle(sun, 9 * unit, palette::frost);
    }
    canvas.setBlend(atlax::Blend::Alpha);
}

void Backdrop::drawStars(atlax::Canvas& canvas, Art& art, double seconds) const {
    const Vec2 screen = canvas.size().toVec();
    const float unit = screen.y / 720;
    canvas.setBlend(atlax::Blend::Additive);
    for (const Star& star : stars_) {
        const float twinkle =
            0.75f +
            0.25f * static_cast<float>(std::sin(seconds * 1.7 + static_cast<double>(star.phase)));
        canvas.circle({star.place.x * screen.x, star.place.y * screen.y}, star.size * unit,
                      palette::frost.withAlpha(0.8f * star.brightness * twinkle));
    }
    canvas.setBlend(atlax::Blend::Alpha);
    drawRing(canvas);
    const Vec2 moon{screen.x * 0.79f, screen.y * 0.2f};
    canvas.setBlend(atlax::Blend::Additive);
    canvas.glow(moon, 150 * unit, look_.haze.withAlpha(0.3f));
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
        canvas.polyline(arc, width, palette::frost.withAlpha(band == 1 ? 0.17f : 0.1f));
    }
}

/// Light that falls in from above and sways.
void Backdrop::drawShafts(atlax::Canvas& canvas, double seconds) const {
    const Vec2 screen = canvas.size().toVec();
    canvas.setScreenSpace();
    canvas.setBlend(atlax::Blend::Additive);
    std::vector<atlax::MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < 5; ++i) {
        const float sway = static_cast<float>(std::sin(seconds * 0.11 + 1.7 * i));
        const float x = screen.x * (0.08f + 0.21f * static_cast<float>(i) + 0.03f * sway);
        const float wide = screen.x * (0.03f + 0.012f * static_cast<float>(i % 3));
        const float lean = screen.y * 0.34f;
        const Color light = look_.horizon.withAlpha(0.10f + 0.04f * sway),
                    none = light.withAlpha(0);
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back({{x, 0}, {}, light});
        vertices.push_back({{x + wide, 0}, {}, light});
        vertices.push_back({{x + wide * 2.6f - lean, screen.y * 0.9f}, {}, none});
        vertices.push_back({{x - wide - lean, screen.y * 0.9f}, {}, none});
        indices.insert(indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
    canvas.mesh({}, vertices, indices);
    canvas.setBlend(atlax::Blend::Alpha);
}

void Backdrop::drawForeground(atlax::Canvas& canvas, const atlax::Camera& camera) const {
    constexpr float parallax = 1.5f, gap = 1.15f;
    const atlax::Camera close = camera.parallax(parallax, anchor_);
    const atlax::Rect view = close.view(canvas.size());
    canvas.setCamera(close);
    const Color dark = mix(mix(Color::hex(theme_.skyTop), look_.near, 0.4f), palette::night, 0.55f);
    const float unit = view.size.y;
    const auto low = static_cast<int>(std::floor(view.min.x / gap)) - 1;
    const auto high = static_cast<int>(std::ceil(view.max().x / gap)) + 1;
    for (int cell = low; cell <= high; ++cell) {
        Dice dice(theme_.seed * 31 + static_cast<std::uint32_t>(cell + 100000));
        if (dice.unit() < 0.55f) continue;
        const float x = (static_cast<float>(cell) + dice.unit()) * gap;
        const bool above = theme_.world == Theme::World::bog && dice.unit() < 0.4f;
        const float up = above ? -1.0f : 1.0f, edge = above ? view.max().y : view.min.y;
        const float tall = unit * dice.between(0.07f, 0.13f);
        const int blades = 5 + static_cast<int>(dice.between(0, 5));
        for (int k = 0; k < blades; ++k) {
            // Highest in the middle of the clump.
            const float part = (static_cast<float>(k) + 0.5f) / static_cast<float>(blades) * 2 - 1;
            const float size = tall * (1.05f - part * part) * dice.between(0.6f, 1);
            const float at = x + part * tall * 1.5f;
            drawBlade(canvas, {at, edge}, up * size, above ? 0 : part * 0.4f * size, dark);
        }
    }
}

/// One spike of ice, stalk, pipe or crystal of the foreground.
void Backdrop::drawBlade(atlax::Canvas& canvas, Vec2 root, float size, float lean,
                         Color dark) const {
    const Vec2 tip = root + Vec2{lean, size};
    const float wide = std::abs(size) * 0.2f;
    switch (theme_.world) {
        // Nothing pointed: what is pointed kills.
        case Theme::World::dawn:
            canvas.circle(root, std::abs(size) * 0.62f, dark);
            break;
        case Theme::World::deep:
            canvas.capsule(root, lerp(root, tip, 0.75f), wide * 0.75f, dark);
            canvas.circle(lerp(root, tip, 0.75f), wide * 1.1f, dark);
            break;
        case Theme::World::bog:
            canvas.line(root, lerp(root, tip, 0.6f) + Vec2{lean * 0.1f, 0}, wide * 0.4f, dark);
            canvas.line(lerp(root, tip, 0.6f) + Vec2{lean * 0.1f, 0}, tip + Vec2{lean * 0.5f, 0},
                        wide * 0.25f, dark);
            break;
        case Theme::World::machine:
            canvas.rect({{root.x - wide, root.y}, {2 * wide, std::abs(size) * 0.7f}}, dark);
            canvas.rect({{root.x - wide * 1.25f, root.y + std::abs(size) * 0.6f},
                         {2.5f * wide, std::abs(size) * 0.12f}},
                        dark);
            break;
    }
}

void Backdrop::drawWeather(atlax::Canvas& canvas, const atlax::Camera& camera, double seconds,
                           bool before, const Quality& quality) const {
    const atlax::Rect view = camera.view(canvas.size());
    Dice dice(theme_.seed + (before ? 5 : 6));
    canvas.setCamera(camera);
    canvas.setBlend(atlax::Blend::Additive);
    const bool rises = look_.weather != Weather::snow;
    const double fall = look_.weather == Weather::embers ? -0.42 : rises ? -0.13 : 0.16;
    const double wind = look_.weather == Weather::snow ? 0.2 : 0.05;
    const int count = static_cast<int>((before ? 14.0f : 120.0f) * quality.weather);
    for (int i = 0; i < count; ++i) {
        const float depth = before ? dice.between(1.4f, 2.2f) : dice.between(0.5f, 1.4f);
        const auto far = static_cast<double>(depth);
        const float width = view.size.x + 1, height = view.size.y + 1;
        const double x = static_cast<double>(dice.between(0, 100)) - seconds * wind * far +
                         0.14 * std::sin(seconds * (rises ? 1.1 : 0.7) + i);
        const double y = static_cast<double>(dice.between(0, 100)) - seconds * fall * far;
        // They belong to the world but come back on the other side of the screen.
        const auto wrap = [](double value, float low, float span) {
            const double part =
                std::fmod(value - static_cast<double>(low), static_cast<double>(span));
            return low + static_cast<float>(part < 0 ? part + static_cast<double>(span) : part);
        };
        const Vec2 at{wrap(x, view.min.x - 0.5f, width), wrap(y, view.min.y - 0.5f, height)};
        const auto beat = static_cast<float>(0.6 + 0.4 * std::sin(seconds * 2.3 + 1.9 * i));
        switch (look_.weather) {
            case Weather::snow:
                canvas.circle(at, 0.008f * depth,
                              palette::frost.withAlpha(before ? 0.22f : 0.3f * depth));
                break;
            case Weather::spores:
                canvas.glow(at, 0.035f * depth,
                            look_.accent.withAlpha((before ? 0.25f : 0.5f) * beat));
                canvas.circle(at, 0.006f * depth, look_.accent.withAlpha(0.7f * beat));
                break;
            case Weather::embers:
                if (i % 2 == 0) break;
                canvas.line(at, at + Vec2{0.01f, 0.035f} * depth, 0.009f * depth,
                            Color::hex(0xFF8A3C).withAlpha((before ? 0.3f : 0.65f) * beat));
                break;
            case Weather::bubbles:
                if (i % 3 == 0) {
                    canvas.circleOutline(at, 0.02f * depth, 0.004f, look_.accent.withAlpha(0.3f));
                } else {
                    canvas.circle(at, 0.006f * depth, look_.accent.withAlpha(0.4f * beat));
                }
                break;
        }
    }
    canvas.setBlend(atlax::Blend::Alpha);
}

}  // namespace quaoar
