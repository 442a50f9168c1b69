#include "ice.hpp"

#include <algorithm>
#include <cmath>
#include <quaoar/view/art.hpp>

#include "dice.hpp"
#include "outline.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

namespace {

/// By the parity of borders to the right.
bool inside(const std::vector<Vec2>& loop, Vec2 p) {
    bool odd = false;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const Vec2 a = loop[i], b = loop[j];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) odd = !odd;
    }
    return odd;
}

}  // namespace

IceView::IceView(Art& art, const std::vector<Vec2>& loop, float radius, const Surface& surface,
                 const Theme& theme)
    : loop_(grown(loop, radius)), normals_(cornerNormals(loop_)) {
    ice_ = Color::hex(theme.ice);
    rim_ = Color::hex(theme.rim);
    core_ = mix(Color::hex(theme.skyTop), ice_, 0.22f);
    if (surface.look == Surface::Look::rock) ice_ = mix(ice_, Color::hex(0x5A4A42), 0.7f);
    if (surface.look == Surface::Look::mirror) ice_ = mix(ice_, palette::frost, 0.35f);
    Vec2 low = loop_.front(), high = low;
    for (const Vec2 p : loop_) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    box_ = {low, high - low};
    depth_ = art.make(depthImage());
    addFacets(theme.seed + 3);
    addBand(0.22f, palette::ice.withAlpha(0.62f));
    addBand(0.07f, rim_.withAlpha(0.55f));
    addIcicles(theme.seed + 1);
    addSnow(theme.seed + 2);
    addCracks(theme.seed + 4);
}

float IceView::light(Vec2 normal) {
    return std::max(0.0f, dot(normal, normalized(Vec2{-0.35f, 0.94f})));
}

atlax::Image IceView::depthImage() const {
    constexpr float seep = 1.25f;  // metres until the light is gone
    constexpr float wanted = 14;   // pixels a metre; it has no edges that would need more
    const float side = std::max(box_.size.x, box_.size.y);
    const float scale = std::min(wanted, 900 / side);
    const int width = std::max(2, static_cast<int>(box_.size.x * scale));
    const int height = std::max(2, static_cast<int>(box_.size.y * scale));
    const Color glow = mix(ice_, palette::ice, 0.3f);
    atlax::Image image({width, height});
    const std::size_t n = loop_.size();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Vec2 p = box_.min + Vec2{(static_cast<float>(x) + 0.5f) / scale,
                                           box_.size.y - (static_cast<float>(y) + 0.5f) / scale};
            if (!inside(loop_, p)) continue;
            float nearest = seep, shine = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const Vec2 a = loop_[i], along = loop_[(i + 1) % n] - a;
                const float t = std::clamp(dot(p - a, along) / dot(along, along), 0.0f, 1.0f);
                const float away = length(p - a - along * t);
                if (away >= nearest) continue;
                nearest = away;
                shine = light(-perpendicular(normalized(along)));
            }
            const float depth = 1 - nearest / seep;
            // Nothing within a pixel of the border: smoothing would carry it outside.
            const float clear = std::clamp(nearest * scale - 0.7f, 0.0f, 1.0f);
            const float alpha = clear * depth * depth * (0.75f + 0.25f * shine);
            const auto byte = [](float part) {
                return static_cast<std::uint8_t>(std::clamp(part, 0.0f, 1.0f) * 255);
            };
            image.setPixel(x, y, {byte(glow.r), byte(glow.g), byte(glow.b), byte(alpha)});
        }
    }
    return image;
}

/// A strip along the border that fades inwards, brighter where the border faces the light. Its
/// quads share their corners, so that nothing is painted twice along the border.
void IceView::addBand(float depth, Color outer) {
    const std::vector<Vec2> inner = grown(loop_, -depth);
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    const auto count = static_cast<std::uint32_t>(loop_.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        const float share = 0.22f + 0.78f * light(normals_[i]);
        vertices_.push_back({loop_[i], {}, outer.faded(share)});
        vertices_.push_back({inner[i], {}, outer.withAlpha(0)});
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % count);
        indices_.insert(indices_.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
}

/// Flat planes in the ice, each catching the light a little differently.
void IceView::addFacets(std::uint32_t seed) {
    Dice dice(seed);
    const std::size_t n = loop_.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = loop_[i], b = loop_[(i + 1) % n];
        const Vec2 along = normalized(b - a);
        const Vec2 inward = perpendicular(along);
        const float edge = length(b - a);
        for (float t = 0; t < edge; t += dice.between(0.35f, 0.8f)) {
            const float width = std::min(dice.between(0.3f, 0.9f), edge - t);
            const float depth = dice.between(0.25f, 0.95f);
            const Vec2 left = a + along * t, right = a + along * (t + width);
            const Vec2 tip = a + along * (t + width * dice.between(0.1f, 0.9f)) + inward * depth;
            const bool bright = dice.unit() < 0.5f;
            const Color tint = bright ? palette::ice : palette::night;
            const auto first = static_cast<std::uint32_t>(vertices_.size());
            vertices_.push_back({left, {}, tint.withAlpha(bright ? 0.20f : 0.16f)});
            vertices_.push_back({right, {}, tint.withAlpha(bright ? 0.11f : 0.2f)});
            vertices_.push_back({tip, {}, tint.withAlpha(0)});
            indices_.insert(indices_.end(), {first, first + 1, first + 2});
        }
    }
}

/// Below overhangs. They are only drawn: too thin to be mistaken for ground.
void IceView::addIcicles(std::uint32_t seed) {
    Dice dice(seed);
    const std::size_t n = loop_.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = loop_[i], b = loop_[(i + 1) % n];
        const Vec2 along = normalized(b - a);
        if (perpendicular(along).y < 0.72f) continue;  // inward is up: the border looks down
        const float edge = length(b - a);
        for (float t = dice.between(0.05f, 0.3f); t < edge - 0.05f;
             t += dice.between(0.06f, 0.4f)) {
            const float size = dice.between(0.03f, 0.17f) * dice.between(0.6f, 1.3f);
            const float half = 0.012f + size * 0.11f;
            const Vec2 root = a + along * t + Vec2{0, 0.02f};
            const auto first = static_cast<std::uint32_t>(icicles_.size());
            icicles_.push_back({root + along * half, {}, palette::ice.withAlpha(0.75f)});
            icicles_.push_back({root - along * half, {}, rim_.withAlpha(0.8f)});
            icicles_.push_back({root - Vec2{0, size}, {}, rim_.withAlpha(0.25f)});
            icicleIndices_.insert(icicleIndices_.end(), {first, first + 1, first + 2});
        }
    }
}

/// Snow lies where the border looks up.
void IceView::addSnow(std::uint32_t seed) {
    Dice dice(seed);
    const std::size_t n = loop_.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = loop_[i], b = loop_[(i + 1) % n];
        const Vec2 along = normalized(b - a);
        const float up = -perpendicular(along).y;
        if (up < 0.8f || length(b - a) > 8) continue;
        const float edge = length(b - a);
        for (float t = 0; t < edge; t += 0.16f) {
            const float width = dice.between(0.028f, 0.062f) * (up - 0.35f) * 1.5f;
            const Vec2 sink = Vec2{0, -0.35f * width};
            snow_.push_back(
                {a + along * t + sink, a + along * std::min(edge, t + 0.2f) + sink, width});
        }
    }
}

void IceView::addCracks(std::uint32_t seed) {
    Dice dice(seed);
    const std::size_t n = loop_.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = loop_[i], b = loop_[(i + 1) % n];
        if (dice.unit() < 0.45f || length(b - a) > 8) continue;
        const Vec2 inward = perpendicular(normalized(b - a));
        Vec2 at = lerp(a, b, dice.between(0.2f, 0.8f)) + inward * 0.05f;
        Vec2 way = normalized(inward + (b - a) * dice.between(-0.9f, 0.9f));
        Crack crack;
        crack.alpha = dice.between(0.08f, 0.24f);
        const int steps = 2 + static_cast<int>(dice.between(0, 4));
        for (int s = 0; s < steps; ++s) {
            crack.points.push_back(at);
            at += way * dice.between(0.08f, 0.22f);
            way = normalized(way + perpendicular(way) * dice.between(-0.8f, 0.8f));
        }
        crack.points.push_back(at);
        cracks_.push_back(std::move(crack));
    }
}

void IceView::draw(atlax::Canvas& canvas) const {
    canvas.mesh({}, icicles_, icicleIndices_);
    canvas.polygon(loop_, core_);
    canvas.sprite(depth_, box_.centre(), box_.size);
    canvas.mesh({}, vertices_, indices_);
    for (const Crack& crack : cracks_) {
        canvas.polyline(crack.points, 0.008f, rim_.withAlpha(crack.alpha));
    }
    const std::size_t n = loop_.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = loop_[i], b = loop_[(i + 1) % n];
        const float bright = light(-perpendicular(normalized(b - a)));
        canvas.line(a, b, 0.014f + 0.014f * bright, rim_.withAlpha(0.3f + 0.6f * bright));
    }
    for (const Flake& flake : snow_) {
        canvas.line(flake.from, flake.to, flake.width, mix(rim_, palette::ice, 0.06f));
    }
}

}  // namespace quaoar
