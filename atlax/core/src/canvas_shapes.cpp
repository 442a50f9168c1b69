#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "canvas_impl.hpp"
#include "polygon.hpp"

namespace atlax {

using detail::Mode;
using detail::PackedColor;
using detail::shapeOf;
using detail::Vertex;

namespace {

bool finite(Vec2 p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
}

}  // namespace

void Canvas::Implementation::box(const Box& b, const PackedColor& color) {
    // One pixel more than the shape, for the soft border.
    const Vec2 reach = b.half + Vec2{1, 1} * (b.radius + b.halfStroke + 1);
    if (!finite(b.centre) || !finite(reach) || !finite(b.axis)) return;
    const Vec2 side = perpendicular(b.axis);
    const std::array<float, 4> shape{b.half.x, b.half.y, b.radius, b.halfStroke};
    const auto corner = [&](float sx, float sy) {
        const Vec2 local{sx * reach.x, sy * reach.y};
        return Vertex{b.centre + b.axis * local.x + side * local.y, local, color, shape};
    };
    batch.quad({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
}

void Canvas::Implementation::capsule(Vec2 from, Vec2 to, float radius, Color color) {
    if (!(radius > 0)) return;
    constexpr float thinnest = 0.5f;
    if (radius < thinnest) {
        color.a *= radius / thinnest;
        radius = thinnest;
    }
    const float reach = length(to - from);
    box({.centre = lerp(from, to, 0.5f),
         .axis = reach > 0 ? (to - from) / reach : Vec2{1, 0},
         .half = {reach / 2, 0},
         .radius = radius},
        pack(color));
}

void Canvas::Implementation::outline(Box outer, float width, Color color) {
    if (!(width > 0)) return;
    if (width < 1) {
        color.a *= width;
        width = 1;
    }
    // The line's middle lies half its width inside; what the radius cannot give the box does.
    const float inset = width / 2;
    const float fromRadius = std::min(inset, outer.radius);
    outer.radius -= fromRadius;
    outer.half.x = std::max(outer.half.x - (inset - fromRadius), 0.0f);
    outer.half.y = std::max(outer.half.y - (inset - fromRadius), 0.0f);
    outer.halfStroke = inset;
    box(outer, pack(color));
}

void Canvas::line(Vec2 from, Vec2 to, float width, Color color) {
    auto& self = *implementation_;
    const Space& space = self.frame.space;
    self.capsule(space.toPixels(from), space.toPixels(to), space.length(width) / 2, color);
}

void Canvas::capsule(Vec2 from, Vec2 to, float radius, Color color) {
    line(from, to, radius * 2, color);
}

void Canvas::dashedLine(Vec2 from, Vec2 to, float width, float dash, float gap, Color color) {
    const float total = length(to - from);
    const float step = dash + gap;
    constexpr float mostDashes = 10'000;
    if (!(dash > 0) || !(gap >= 0) || !(total > 0) || !std::isfinite(step)) return;
    if (!(total / step < mostDashes)) return;
    const Vec2 direction = (to - from) / total;
    // Round ends make a dash longer by the width; take it from the dash, not from the gap.
    const float inset = std::min(width / 2, dash / 2);
    const int dashes = static_cast<int>(std::ceil(total / step));
    for (int i = 0; i < dashes; ++i) {
        const float at = static_cast<float>(i) * step;
        const float end = std::min(at + dash, total);
        if (end - at < inset) continue;
        line(from + direction * (at + inset), from + direction * std::max(end - inset, at + inset),
             width, color);
    }
}

void Canvas::capsuleOutline(Vec2 from, Vec2 to, float radius, float width, Color color) {
    auto& self = *implementation_;
    const Space& space = self.frame.space;
    const Vec2 a = space.toPixels(from);
    const Vec2 b = space.toPixels(to);
    const float reach = length(b - a);
    self.outline({.centre = lerp(a, b, 0.5f),
                  .axis = reach > 0 ? (b - a) / reach : Vec2{1, 0},
                  .half = {reach / 2, 0},
                  .radius = space.length(radius)},
                 space.length(width), color);
}

void Canvas::circle(Vec2 centre, float radius, Color color) {
    auto& self = *implementation_;
    const Space& space = self.frame.space;
    float pixels = space.length(radius);
    constexpr float smallest = 0.5f;
    if (!(pixels > 0)) return;
    if (pixels < smallest) {
        color.a *= pixels * pixels / (smallest * smallest);
        pixels = smallest;
    }
    self.box({.centre = space.toPixels(centre), .half = {}, .radius = pixels}, self.pack(color));
}

void Canvas::circleOutline(Vec2 centre, float radius, float width, Color color) {
    capsuleOutline(centre, centre, radius, width, color);
}

void Canvas::glow(Vec2 centre, float radius, Color color) {
    auto& self = *implementation_;
    const Vec2 middle = self.frame.space.toPixels(centre);
    const float pixels = self.frame.space.length(radius);
    if (!finite(middle) || !(pixels > 0) || !std::isfinite(pixels)) return;
    const PackedColor packed = self.pack(color);
    const auto corner = [&](float sx, float sy) {
        return Vertex{middle + Vec2{sx, sy} * pixels, {sx, sy}, packed, shapeOf(Mode::Glow)};
    };
    self.batch.quad({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
}

void Canvas::rect(Rect rect, Color color) {
    roundedRect(rect, 0, color);
}

void Canvas::roundedRect(Rect rect, float radius, Color color) {
    auto& self = *implementation_;
    const Rect pixels = self.frame.space.toPixels(rect);
    if (!(pixels.size.x > 0) || !(pixels.size.y > 0)) return;
    const Vec2 half = pixels.size * 0.5f;
    const float round = std::clamp(self.frame.space.length(radius), 0.0f, std::min(half.x, half.y));
    self.box({.centre = pixels.centre(), .half = half - Vec2{round, round}, .radius = round},
             self.pack(color));
}

void Canvas::roundedRectOutline(Rect rect, float radius, float width, Color color) {
    auto& self = *implementation_;
    const Rect pixels = self.frame.space.toPixels(rect);
    const Vec2 half = pixels.size * 0.5f;
    const float round = std::clamp(self.frame.space.length(radius), 0.0f, std::min(half.x, half.y));
    self.outline({.centre = pixels.centre(), .half = half - Vec2{round, round}, .radius = round},
                 self.frame.space.length(width), color);
}

void Canvas::gradientRect(Rect rect, Color top, Color bottom) {
    auto& self = *implementation_;
    const Rect p = self.frame.space.toPixels(rect);
    if (!finite(p.min) || !finite(p.size)) return;
    const PackedColor above = self.pack(top);
    const PackedColor below = self.pack(bottom);
    const auto shape = shapeOf(Mode::Gradient);
    self.batch.quad(
        {Vertex{p.min, {}, above, shape}, Vertex{{p.max().x, p.min.y}, {}, above, shape},
         Vertex{p.max(), {}, below, shape}, Vertex{{p.min.x, p.max().y}, {}, below, shape}});
}

std::array<float, 4> Canvas::Implementation::useTexture(
    const std::shared_ptr<detail::TextureObject>& texture) {
    // A picture of another canvas would be some other picture's name here.
    if (texture == nullptr || texture->graveyard != graveyard) return shapeOf(Mode::Flat);
    batch.useTexture(texture);
    return shapeOf(Mode::Textured);
}

void Canvas::mesh(const Texture& texture, std::span<const MeshVertex> vertices,
                  std::span<const std::uint32_t> indices) {
    auto& self = *implementation_;
    if (vertices.empty() || indices.size() < 3) return;
    const auto shape = self.useTexture(texture.object_);
    self.batch.reserve(vertices.size());
    const std::uint32_t first = self.batch.nextVertex();
    for (const MeshVertex& v : vertices)
        self.batch.add({self.frame.space.toPixels(v.position), v.uv, self.pack(v.tint), shape});
    const auto drawable = [&](std::uint32_t i) {
        return i < vertices.size() && finite(vertices[i].position);
    };
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        if (drawable(indices[i]) && drawable(indices[i + 1]) && drawable(indices[i + 2]))
            self.batch.triangle(first + indices[i], first + indices[i + 1], first + indices[i + 2]);
}

void Canvas::sprite(const Texture& texture, Vec2 centre, Vec2 size, const SpriteStyle& style) {
    auto& self = *implementation_;
    if (!finite(centre) || !finite(size) || !std::isfinite(style.angle)) return;
    const auto shape = self.useTexture(texture.object_);
    const PackedColor packed = self.pack(style.tint);
    const Vec2 axis{std::cos(style.angle), std::sin(style.angle)};
    const float upright = self.frame.space.world() ? 1.0f : -1.0f;
    const auto corner = [&](float u, float v) {
        const Vec2 local{(u - 0.5f) * size.x, (0.5f - v) * size.y * upright};
        const Vec2 place = centre + axis * local.x + perpendicular(axis) * local.y;
        return Vertex{self.frame.space.toPixels(place),
                      {style.uv.min.x + u * style.uv.size.x, style.uv.min.y + v * style.uv.size.y},
                      packed,
                      shape};
    };
    self.batch.quad({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
}

void Canvas::drawTarget(const RenderTarget& target) {
    if (!target.valid()) return;
    implementation_->requireOwn(target);
    auto& frame = implementation_->frame;
    const Space space = std::exchange(frame.space, Space{});
    const std::vector<Rect> clips = std::exchange(frame.clips, {});
    implementation_->applyClip();
    const Vec2 size = frame.size.toVec();
    sprite(target.texture(), size * 0.5f, size);
    frame.space = space;
    frame.clips = clips;
    implementation_->applyClip();
}

namespace {

/// Where the nine parts begin along one side, and the share of the borders that fits.
std::array<float, 4> cuts(float length, float before, float after) {
    const float borders = before + after;
    const float share = borders > length && borders > 0 ? length / borders : 1.0f;
    return {0, before * share, length - after * share, length};
}

}  // namespace

void Canvas::ninePatch(const Texture& texture, Rect rect, const Insets& insets, float pixel,
                       const SpriteStyle& style) {
    const bool sound = insets.left >= 0 && insets.top >= 0 && insets.right >= 0 &&
                       insets.bottom >= 0 && pixel > 0 && rect.size.x > 0 && rect.size.y > 0;
    if (!texture.valid() || !sound) return;
    const Vec2 picture = texture.size().toVec();
    const std::array xs = cuts(rect.size.x, insets.left * pixel, insets.right * pixel);
    const std::array ys = cuts(rect.size.y, insets.top * pixel, insets.bottom * pixel);
    const Rect uv = style.uv;
    const std::array us{0.0f, insets.left / picture.x, uv.size.x - insets.right / picture.x,
                        uv.size.x};
    const std::array vs{0.0f, insets.top / picture.y, uv.size.y - insets.bottom / picture.y,
                        uv.size.y};
    const bool world = implementation_->frame.space.world();
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) {
            const Vec2 size{xs[column + 1] - xs[column], ys[row + 1] - ys[row]};
            if (!(size.x > 0) || !(size.y > 0)) continue;
            // The picture's first row is the upper edge, which in the world is the larger y.
            const float y =
                world ? rect.max().y - ys[row] - size.y / 2 : rect.min.y + ys[row] + size.y / 2;
            const Rect part{uv.min + Vec2{us[column], vs[row]},
                            {us[column + 1] - us[column], vs[row + 1] - vs[row]}};
            sprite(texture, {rect.min.x + xs[column] + size.x / 2, y}, size,
                   {.tint = style.tint, .uv = part});
        }
}

}  // namespace atlax
