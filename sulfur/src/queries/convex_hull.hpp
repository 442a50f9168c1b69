// Convex hulls of a few points, made thicker all round, seen from the origin.
//
// Two convex shapes touch where the origin is in their Minkowski difference; a shape that moves
// meets the other where the ray of its motion enters it (Ericson 2005, 3.6 and 9.2). The shapes of
// queries have few points, so that the difference is made as it is.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <sulfur/math.hpp>

namespace sulfur::detail {

/// Where a ray enters something.
struct Entry {
    double fraction = 0;  // of the way, 0 to 1
    Point normal{0, 0};   // unit, outwards; zero when the ray starts inside
};

/// The convex hull of up to 16 points (Andrew 1979). One or two corners are a point or a segment.
class ConvexHull {
public:
    static constexpr std::size_t maxCorners = 16;

    explicit ConvexHull(std::span<const Point> points);
    /// What the segment from a to b and a convex shape are apart: all b - p.
    static ConvexHull difference(const Point& a, const Point& b, std::span<const Point> shape);

    /// Counter-clockwise, none on the way between two others.
    std::span<const Point> corners() const { return {corners_.data(), count_}; }
    /// How far the origin is from the hull, 0 inside.
    double distance() const;
    /// Where the ray from the origin along `way` enters the hull made thicker by `radius` > 0.
    std::optional<Entry> enter(const Point& way, double radius) const;

private:
    const Point& corner(std::size_t i) const { return corners_[i < count_ ? i : i - count_]; }

    std::array<Point, maxCorners + 1> corners_;  // one more while it is made
    std::size_t count_ = 0;
};

}  // namespace sulfur::detail
