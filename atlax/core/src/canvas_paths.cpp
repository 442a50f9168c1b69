// Polylines and polygons, in pixels.
#include <algorithm>
#include <cmath>

#include "canvas_impl.hpp"
#include "polygon.hpp"

namespace atlax {

using detail::Mode;
using detail::PackedColor;
using detail::Vertex;

namespace {

void gatherPixels(std::vector<Vec2>& out, const Space& space, std::span<const Vec2> points) {
    out.clear();
    for (const Vec2 p : points) out.push_back(space.toPixels(p));
}

/// The vector along the bisector of a corner whose part across either side is 1. `before` and
/// `after` are the unit directions of the sides. Capped in length for sharp corners.
Vec2 miter(Vec2 before, Vec2 after, float longest) {
    const Vec2 sum = perpendicular(before) + perpendicular(after);
    const float squared = dot(sum, sum);
    if (squared < 1e-6f) return perpendicular(before);
    const Vec2 m = sum * (2 / squared);
    const float l = length(m);
    return l > longest ? m * (longest / l) : m;
}

/// One end of a segment of a stroke: the two corners of its quad.
struct StrokeEnd {
    Vec2 left;
    Vec2 right;
};

/// Neighbouring segments meet on the bisector of their corner. Their distance fields are equal
/// there, so a transparent colour shows no overlap. Where the corner is too sharp or a side too
/// short for that, the segment ends in a cap of its own.
StrokeEnd strokeEnd(Vec2 at, Vec2 outward, float reach, const Vec2* beyond, float sideLength) {
    const Vec2 side = perpendicular(outward);
    const Vec2 cap = outward * reach;
    const StrokeEnd capped{at + side * reach + cap, at - side * reach + cap};
    if (beyond == nullptr) return capped;
    const float neighbour = length(*beyond - at);
    const Vec2 after = (*beyond - at) / neighbour;
    const float cosine = dot(outward, after);
    constexpr float sharpest = -0.85f;  // a turn of about 150 degrees
    if (cosine < sharpest) return capped;
    const Vec2 m = miter(outward, after, 4) * reach;
    const float along = std::abs(dot(m, outward));
    if (along > std::min(sideLength, neighbour)) return capped;
    return {at + m, at - m};
}

}  // namespace

void Canvas::Implementation::strokePixels(std::span<const Vec2> points, float width, Color color,
                                          bool closed) {
    float radius = width / 2;
    if (radius < 0.5f) {
        color.a *= radius / 0.5f;
        radius = 0.5f;
    }
    const PackedColor packed = pack(color);
    const float reach = radius + 1;
    const std::size_t n = points.size();
    const std::size_t segments = closed ? n : n - 1;
    for (std::size_t i = 0; i < segments; ++i) {
        const Vec2 a = points[i];
        const Vec2 b = points[(i + 1) % n];
        const float sideLength = length(b - a);
        const Vec2 axis = (b - a) / sideLength;
        const Vec2* before = closed || i > 0 ? &points[(i + n - 1) % n] : nullptr;
        const Vec2* after = closed || i + 2 < n ? &points[(i + 2) % n] : nullptr;
        const StrokeEnd start = strokeEnd(a, -axis, reach, before, sideLength);
        const StrokeEnd end = strokeEnd(b, axis, reach, after, sideLength);
        const Vec2 middle = lerp(a, b, 0.5f);
        const std::array<float, 4> shape{sideLength / 2, 0, radius, 0};
        const auto corner = [&](Vec2 p) {
            const Vec2 d = p - middle;
            return Vertex{p, {dot(d, axis), dot(d, perpendicular(axis))}, packed, shape};
        };
        // The start looks backwards, so its right is the segment's left.
        batch.quad({corner(start.right), corner(start.left), corner(end.right), corner(end.left)});
    }
}

void Canvas::polyline(std::span<const Vec2> points, float width, Color color, bool closed) {
    auto& self = *implementation_;
    gatherPixels(self.scratch, self.frame.space, points);
    detail::removeRepeats(self.scratch);
    // removeRepeats also drops an end that lies on the start; such a line is closed.
    const bool loops = closed || (points.size() > 2 && points.front() == points.back());
    const float pixels = self.frame.space.length(width);
    if (!(pixels > 0) || self.scratch.empty()) return;
    if (self.scratch.size() == 1) {
        self.capsule(self.scratch[0], self.scratch[0], pixels / 2, color);
        return;
    }
    self.strokePixels(self.scratch, pixels, color, loops && self.scratch.size() > 2);
}

void Canvas::polygonOutline(std::span<const Vec2> points, float width, Color color) {
    polyline(points, width, color, true);
}

void Canvas::triangle(Vec2 a, Vec2 b, Vec2 c, Color color) {
    const std::array<Vec2, 3> points{a, b, c};
    polygon(points, color);
}

void Canvas::polygon(std::span<const Vec2> points, Color color) {
    implementation_->fillPolygon(points, {.color = implementation_->pack(color)});
}

void Canvas::polygon(std::span<const Vec2> points, const Gradient& gradient) {
    const Vec2 way = gradient.to - gradient.from;
    if (!std::isfinite(way.x) || !std::isfinite(way.y)) return;
    implementation_->fillPolygon(points, implementation_->fillOf(gradient));
}

Canvas::Implementation::Fill Canvas::Implementation::fillOf(const Gradient& gradient) const {
    const Vec2 from = frame.space.toPixels(gradient.from);
    const Vec2 way = frame.space.toPixels(gradient.to) - from;
    // Of no length, all is beyond its end.
    const float squared = std::max(dot(way, way), 1e-12f);
    const bool radial = gradient.kind == Gradient::Kind::Radial;
    constexpr std::uint16_t full = 65535;
    Fill fill{.color = {full, full, full, full},
              .shape = detail::gradientShape(pack(gradient.start), pack(gradient.end),
                                             radial ? Mode::Radial : Mode::Linear),
              .origin = from,
              .u = way / squared};
    if (radial) fill.v = perpendicular(fill.u);
    return fill;
}

void Canvas::Implementation::fillPolygon(std::span<const Vec2> points, const Fill& fill) {
    gatherPixels(scratch, frame.space, points);
    detail::removeRepeats(scratch);
    if (scratch.size() < 3) return;
    if (detail::doubleArea(scratch) < 0) std::reverse(scratch.begin(), scratch.end());
    polygonPixels(scratch, fill);
}

void Canvas::Implementation::polygonPixels(std::span<const Vec2> points, const Fill& fill) {
    // The border becomes a strip one pixel wide, from full colour inside to nothing outside.
    constexpr PackedColor nothing{};
    const auto vertex = [&](Vec2 p, const PackedColor& color) {
        const Vec2 d = p - fill.origin;
        return Vertex{p, {dot(d, fill.u), dot(d, fill.v)}, color, fill.shape};
    };
    const std::size_t n = points.size();
    batch.reserve(2 * n);
    const std::uint32_t first = batch.nextVertex();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 before = normalized(points[i] - points[(i + n - 1) % n]);
        const Vec2 after = normalized(points[(i + 1) % n] - points[i]);
        const Vec2 inward = miter(before, after, 2) * 0.5f;
        batch.add(vertex(points[i] + inward, fill.color));
        batch.add(vertex(points[i] - inward, nothing));
    }
    for (const auto& t : detail::triangulate(points))
        batch.triangle(first + 2 * t[0], first + 2 * t[1], first + 2 * t[2]);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = first + 2 * i;
        const std::uint32_t b = first + 2 * ((i + 1) % static_cast<std::uint32_t>(n));
        batch.triangle(a, a + 1, b + 1);
        batch.triangle(a, b + 1, b);
    }
}

}  // namespace atlax
