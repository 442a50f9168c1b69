#include "ice.hpp"

#include <algorithm>
#include <cmath>
#include <quaoar/skin/outline.hpp>
#include <quaoar/view/art.hpp>

#include "body_painter.hpp"
#include "dice.hpp"
#include "ice_image.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

IceView::IceView(Art& art, const IceMould& mould)
    : mould_(mould),
      loop_(grown(mould.loop, mould.radius)),
      normals_(cornerNormals(loop_)),
      look_(lookOf(mould.theme.world)),
      world_(mould.theme.world),
      surface_(mould.surface) {
    const Surface& surface = mould.surface;
    const Theme& theme = mould.theme;
    const atlax::Rect shown = mould.shown;
    chooseColours(surface, theme);
    Vec2 low = loop_.front(), high = low;
    for (const Vec2 p : loop_) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    low = {std::max(low.x, shown.min.x), std::max(low.y, shown.min.y)};
    high = {std::min(high.x, shown.max().x), std::min(high.y, shown.max().y)};
    box_ = {low, {std::max(high.x - low.x, 0.1f), std::max(high.y - low.y, 0.1f)}};
    const bool metal = surface.look == Surface::Look::metal || world_ == Theme::World::machine;
    InsideLook inside;
    inside.core = core_;
    inside.seep = mix(ice_, look_.seep, 0.55f);
    inside.panels = metal;
    inside.seed = theme.seed + 9;
    inside_ = art.make(insideImage(loop_, box_, inside));
    // The border itself is drawn in triangles, because the picture inside is too coarse for it.
    addBand(0, 0.1f, mix(inside.seep, core_, 0.25f), true);
    addBand(0.1f, 0.24f, mix(inside.seep, core_, 0.25f), true);
    if (!metal) addFacets(theme.seed + 3);
    addBand(0, 0.30f, look_.seep.withAlpha(0.5f), false);
    addBand(0, 0.08f, rim_.withAlpha(0.5f), false);
    if (world_ != Theme::World::machine) addIcicles(theme.seed + 1);
    if (metal)
        addPlates(theme.seed + 2);
    else if (surface.look != Surface::Look::mirror)
        addCaps(theme.seed + 2);
    addCracks(theme.seed + 4);
    addPieces(theme.seed + 6);
}

void IceView::chooseColours(const Surface& surface, const Theme& theme) {
    ice_ = Color::hex(theme.ice);
    rim_ = Color::hex(theme.rim);
    if (surface.look == Surface::Look::rock) ice_ = mix(ice_, Color::hex(0x6A5448), 0.7f);
    if (surface.look == Surface::Look::metal) ice_ = mix(ice_, Color::hex(0x59606E), 0.75f);
    if (surface.look == Surface::Look::mirror) {
        ice_ = mix(ice_, Color::hex(0x9FE6F2), 0.62f);
        rim_ = Color::hex(0xF4FFFF);
    }
    if (surface.deadly) {
        ice_ = mix(ice_, Color::hex(0x7A1440), 0.75f);
        rim_ = palette::danger;
        look_.seep = palette::danger;
    }
    core_ = mix(Color::hex(theme.skyTop), ice_, 0.42f);
}

/// A strip along the border between two depths, fading inwards; brighter where the border faces the
/// light unless `evenly`. Its quads share their corners, so that nothing is painted twice.
void IceView::addBand(float from, float depth, Color outer, bool evenly) {
    const std::vector<Vec2> near = grown(loop_, -from), inner = grown(loop_, -depth);
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    const auto count = static_cast<std::uint32_t>(loop_.size());
    const bool solid = evenly && from == 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float share = evenly ? 1 : 0.2f + 0.8f * lightOn(normals_[i]);
        vertices_.push_back({near[i], {}, outer.faded(share)});
        vertices_.push_back({inner[i], {}, solid ? outer : outer.withAlpha(0)});
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
        if (edge > 12) continue;
        for (float t = 0; t < edge; t += dice.between(0.35f, 0.8f)) {
            const float width = std::min(dice.between(0.3f, 0.9f), edge - t);
            const float depth = dice.between(0.25f, 0.8f);
            const Vec2 left = a + along * t, right = a + along * (t + width);
            const Vec2 tip = a + along * (t + width * dice.between(0.1f, 0.9f)) + inward * depth;
            const bool bright = dice.unit() < 0.5f;
            const Color tint = bright ? look_.seep : palette::night;
            const auto first = static_cast<std::uint32_t>(vertices_.size());
            vertices_.push_back({left, {}, tint.withAlpha(bright ? 0.26f : 0.16f)});
            vertices_.push_back({right, {}, tint.withAlpha(bright ? 0.12f : 0.2f)});
            vertices_.push_back({tip, {}, tint.withAlpha(0)});
            indices_.insert(indices_.end(), {first, first + 1, first + 2});
        }
    }
}

/// Below overhangs. They are only drawn: too thin to be mistaken for ground.
void IceView::addIcicles(std::uint32_t seed) {
    Dice dice(seed);
    const std::size_t n = loop_.size();
    const bool roots = world_ == Theme::World::bog;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = loop_[i], b = loop_[(i + 1) % n];
        const Vec2 along = normalized(b - a);
        const float edge = length(b - a);
        if (perpendicular(along).y < 0.72f || edge > 12) continue;  // the border looks down
        for (float t = dice.between(0.05f, 0.3f); t < edge - 0.05f;
             t += dice.between(0.06f, 0.4f)) {
            const float size = dice.between(0.03f, 0.17f) * dice.between(0.6f, roots ? 1.9f : 1.3f);
            const float half = roots ? 0.011f : 0.012f + size * 0.11f;
            const float sway = roots ? dice.between(-0.3f, 0.3f) * size : 0;
            const Vec2 root = a + along * t + Vec2{0, 0.02f};
            const Color left = roots ? mix(ice_, look_.cap, 0.3f) : look_.seep.withAlpha(0.8f);
            const Color right = roots ? mix(ice_, look_.cap, 0.6f) : rim_.withAlpha(0.85f);
            const auto first = static_cast<std::uint32_t>(icicles_.size());
            icicles_.push_back({root + along * half, {}, left});
            icicles_.push_back({root - along * half, {}, right});
            icicles_.push_back({root - Vec2{sway, size}, {}, rim_.withAlpha(0.25f)});
            icicleIndices_.insert(icicleIndices_.end(), {first, first + 1, first + 2});
        }
    }
}

/// Snow, moss or crystals lie where the border looks up.
void IceView::addCaps(std::uint32_t seed) {
    Dice dice(seed);
    const std::size_t n = loop_.size();
    const bool moss = world_ == Theme::World::bog, shards = world_ == Theme::World::deep;
    const Color bright = surface_.deadly ? palette::danger : mix(look_.cap, rim_, 0.5f);
    const Color below = mix(bright, ice_, 0.42f);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = loop_[i], b = loop_[(i + 1) % n];
        const Vec2 along = normalized(b - a);
        const float up = -perpendicular(along).y, edge = length(b - a);
        if (up < 0.72f || edge > 12) continue;
        for (float t = 0; t < edge; t += 0.11f) {
            const float width = dice.between(0.030f, 0.066f) * (up - 0.35f) * 1.5f;
            const Vec2 sink = Vec2{0, -0.40f * width};
            const Vec2 from = a + along * t + sink,
                       to = a + along * std::min(edge, t + 0.16f) + sink;
            if (!shards || dice.unit() < 0.7f) caps_.push_back({from, to, width, bright});
            // Drips and blades beneath and above.
            if (dice.unit() < 0.34f) {
                const float drop = dice.between(0.02f, 0.075f);
                drips_.push_back({from, from - Vec2{0, drop}, width * 0.55f, below});
            }
            if (moss && dice.unit() < 0.55f) {
                const Vec2 tip =
                    from + Vec2{dice.between(-0.025f, 0.025f), dice.between(0.02f, 0.055f)};
                caps_.push_back({from, tip, 0.009f, mix(bright, look_.accent, 0.3f)});
            }
            if (shards && dice.unit() < 0.16f) {
                const Vec2 tip =
                    from + Vec2{dice.between(-0.05f, 0.05f), dice.between(0.05f, 0.13f)};
                caps_.push_back({from, tip, 0.018f, look_.accent});
            }
        }
    }
}

/// Riveted plates along every border, striped where it kills.
void IceView::addPlates(std::uint32_t seed) {
    Dice dice(seed);
    const std::size_t n = loop_.size();
    const std::vector<Vec2> inner = grown(loop_, -0.05f);
    const Color plate = mix(ice_, look_.cap, 0.5f), dark = mix(core_, palette::night, 0.4f);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = inner[i], b = inner[(i + 1) % n];
        const float edge = length(b - a);
        if (edge > 12 || edge < 0.05f) continue;
        const Vec2 along = (b - a) / edge;
        const float lit = lightOn(-perpendicular(along));
        caps_.push_back({a, b, 0.085f, mix(dark, plate, 0.45f + 0.55f * lit)});
        for (float t = 0.1f; t < edge - 0.05f; t += 0.22f) {
            const Vec2 at = a + along * t;
            caps_.push_back({at, at + Vec2{0.001f, 0}, 0.03f, dark});
            caps_.push_back({at + Vec2{-0.004f, 0.005f}, at + Vec2{-0.003f, 0.005f}, 0.014f,
                             mix(plate, look_.accent, 0.3f * lit + 0.1f)});
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

void IceView::addPieces(std::uint32_t seed) {
    Dice dice(seed);
    const std::size_t n = loop_.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = loop_[i], b = loop_[(i + 1) % n];
        const float edge = length(b - a);
        if (edge > 40 || edge <= 0) continue;
        const Vec2 along = (b - a) / edge, normal = -perpendicular(along);
        for (float t = 0; t < edge; t += 0.12f) {
            pieces_.push_back({a + along * t, a + along * std::min(edge, t + 0.12f), normal});
            if (dice.unit() < 0.4f) {
                const float depth = dice.between(0.06f, 0.7f);
                glints_.push_back({a + along * t - normal * depth, dice.between(0.006f, 0.02f)});
            }
        }
    }
}

void IceView::draw(atlax::Canvas& canvas, Art& art, atlax::Rect view) const {
    const atlax::Rect seen{view.min - Vec2{0.3f, 0.3f}, view.size + Vec2{0.6f, 0.6f}};
    const auto visible = [&](Vec2 a, Vec2 b) {
        return std::max(a.x, b.x) > seen.min.x && std::min(a.x, b.x) < seen.max().x &&
               std::max(a.y, b.y) > seen.min.y && std::min(a.y, b.y) < seen.max().y;
    };
    if (!visible(box_.min, box_.max())) return;
    canvas.mesh({}, icicles_, icicleIndices_);
    canvas.setShader(art.plain());
    canvas.sprite(inside_, box_.centre(), box_.size);
    canvas.setShader({});
    canvas.mesh({}, vertices_, indices_);
    for (const Crack& crack : cracks_) {
        if (visible(crack.points.front(), crack.points.back()))
            canvas.polyline(crack.points, 0.008f, rim_.withAlpha(crack.alpha));
    }
    const std::size_t n = loop_.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = loop_[i], b = loop_[(i + 1) % n];
        if (!visible(a, b)) continue;
        const float bright = lightOn(-perpendicular(normalized(b - a)));
        canvas.line(a, b, 0.014f + 0.014f * bright, rim_.withAlpha(0.3f + 0.6f * bright));
    }
    for (const auto* caps : {&drips_, &caps_}) {
        for (const Cap& cap : *caps)
            if (visible(cap.from, cap.to)) canvas.line(cap.from, cap.to, cap.width, cap.color);
    }
    if (surface_.look != Surface::Look::mirror) return;
    // Polished: streaks of reflected sky.
    for (std::size_t i = 0; i < pieces_.size(); i += 5) {
        const Piece& piece = pieces_[i];
        const Vec2 in = piece.from - piece.normal * 0.05f;
        canvas.line(in, in - piece.normal * 0.13f, 0.02f, Color::hex(0xFFFFFF).withAlpha(0.28f));
    }
}

void IceView::drawTrim(atlax::Canvas& canvas, float surfaceSpeed, double seconds) const {
    if (surface_.deadly) drawSpikes(canvas, loop_, seconds);
    if (surfaceSpeed != 0) drawBelt(canvas, loop_, surfaceSpeed, seconds, look_.accent);
}

void IceView::drawLit(atlax::Canvas& canvas, Vec2 lamp, float reach, Color light) const {
    std::vector<atlax::MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    const auto brightness = [&](Vec2 at, Vec2 normal) {
        const Vec2 way = lamp - at;
        const float away = length(way), falls = std::max(0.0f, 1 - away / reach);
        const float facing = std::max(0.0f, dot(way / std::max(away, 0.01f), normal));
        return falls * falls * (0.25f + 0.75f * facing);
    };
    // Strips whose light goes over from corner to corner: on the border, and into the rock.
    for (const Piece& piece : pieces_) {
        const Vec2 way = lamp - piece.from;
        if (std::abs(way.x) > reach || std::abs(way.y) > reach) continue;
        const float a = brightness(piece.from, piece.normal),
                    b = brightness(piece.to, piece.normal);
        if (std::max(a, b) < 0.01f) continue;
        const Vec2 out = piece.normal * 0.01f, edge = piece.normal * -0.03f,
                   in = piece.normal * -0.34f;
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back({piece.from + out, {}, light.withAlpha(0.75f * a)});
        vertices.push_back({piece.to + out, {}, light.withAlpha(0.75f * b)});
        vertices.push_back({piece.from + edge, {}, light.withAlpha(0.5f * a)});
        vertices.push_back({piece.to + edge, {}, light.withAlpha(0.5f * b)});
        vertices.push_back({piece.from + in, {}, light.withAlpha(0)});
        vertices.push_back({piece.to + in, {}, light.withAlpha(0)});
        for (const std::uint32_t k : {0u, 2u}) {
            const std::uint32_t i = first + k;
            indices.insert(indices.end(), {i, i + 1, i + 2, i + 1, i + 3, i + 2});
        }
    }
    canvas.mesh({}, vertices, indices);
    for (const Glint& glint : glints_) {
        const Vec2 way = lamp - glint.at;
        if (std::abs(way.x) > reach || std::abs(way.y) > reach) continue;
        const float falls = std::max(0.0f, 1 - length(way) / reach);
        // They flash as the angle to the lamp changes.
        const float wave = std::sin((way.x * 5 + way.y * 9) * 2 + glint.size * 400);
        const float flash = std::max(0.0f, wave);
        if (falls * flash < 0.04f) continue;
        const float s = glint.size * (0.4f + 0.9f * flash);
        const Color color = mix(light, look_.accent, 0.5f).withAlpha(falls * flash);
        for (const Vec2 arm : {Vec2{0, s * 1.8f}, Vec2{s * 1.3f, 0}}) {
            const Vec2 side = perpendicular(arm) * 0.16f;
            canvas.triangle(glint.at - side, glint.at + side, glint.at + arm, color);
            canvas.triangle(glint.at - side, glint.at + side, glint.at - arm, color);
        }
    }
}

}  // namespace quaoar
