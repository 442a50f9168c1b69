// The shapes of queries.
#include <algorithm>
#include <string>
#include <sulfur/error.hpp>
#include <sulfur/queries.hpp>

#include "core/error_checks.hpp"
#include "core/trigonometry.hpp"
#include "queries/convex_hull.hpp"
#include "queries/query.hpp"

namespace sulfur {

QueryShape::QueryShape(std::span<const Point> points, double radius) : radius_(radius) {
    if (points.empty() || points.size() > maxPoints)
        throw Error(ErrorCode::outOfRange, "the shape has " + std::to_string(points.size()) +
                                               " points; allowed is 1 to " +
                                               std::to_string(maxPoints));
    for (const Point& p : points) detail::requireCoordinates(p, "point of the shape");
    detail::requireRange(radius, 0, 1e6, "radius of the shape");
    const detail::ConvexHull hull(points);
    const auto end = std::copy(hull.corners().begin(), hull.corners().end(), points_.begin());
    count_ = static_cast<std::size_t>(end - points_.begin());
}

QueryShape QueryShape::circle(Point centre, double radius) {
    return {{&centre, 1}, radius};
}

QueryShape QueryShape::capsule(Point a, Point b, double radius) {
    return {std::array{a, b}, radius};
}

QueryShape QueryShape::box(Point centre, Vec2 size, double angle) {
    for (int axis = 0; axis < 2; ++axis)
        detail::requireRange(static_cast<double>(size[axis]), 0, 1e6, "size of the box");
    detail::requireRange(angle, -1e6, 1e6, "angle of the box");
    const Point right = detail::unitVector(angle) * static_cast<double>(size[0]) / 2;
    const Point turn = detail::unitVector(angle) * static_cast<double>(size[1]) / 2;
    const Point up(-turn[1], turn[0]);
    return {std::array<Point, 4>{centre - right - up, centre + right - up, centre + right + up,
                                 centre - right + up},
            0};
}

QueryShape QueryShape::polygon(std::span<const Point> points, double radius) {
    return {points, radius};
}

}  // namespace sulfur
