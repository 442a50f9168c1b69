#include "queries/convex_hull.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/segments.hpp"

namespace sulfur::detail {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Fraction at which the ray from the origin enters a circle.
double enterCircle(const Point& way, const Point& centre, double radius) {
    const double a = way.squaredNorm(), b = centre.dot(way);
    const double c = centre.squaredNorm() - radius * radius;
    const double discriminant = b * b - a * c;
    if (a == 0 || discriminant < 0) return never;
    return (b - std::sqrt(discriminant)) / a;
}

/// Fraction at which the ray from the origin crosses the side of a thick edge inwards.
double enterSide(const Point& way, const Point& from, const Point& along, const Point& normal,
                 double radius) {
    const double speed = normal.dot(way);
    if (!(speed < 0)) return never;
    const double fraction = (radius + normal.dot(from)) / speed;
    const double place = (fraction * way - from).dot(along);
    return place >= 0 && place <= along.squaredNorm() ? fraction : never;
}

}  // namespace

ConvexHull::ConvexHull(std::span<const Point> points) {
    assert(!points.empty() && points.size() <= maxCorners);
    std::array<Point, maxCorners> sorted;
    const auto end = std::copy(points.begin(), points.end(), sorted.begin());
    std::sort(sorted.begin(), end, [](const Point& a, const Point& b) {
        return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
    });
    const auto last = std::unique(sorted.begin(), end);
    const auto count = static_cast<std::size_t>(last - sorted.begin());
    const auto add = [&](const Point& p, std::size_t least) {
        while (count_ > least && cross(Point(corners_[count_ - 1] - corners_[count_ - 2]),
                                       Point(p - corners_[count_ - 1])) <= 0)
            --count_;
        corners_[count_++] = p;
    };
    for (std::size_t i = 0; i < count; ++i) add(sorted[i], 1);
    const std::size_t lower = count_;
    for (std::size_t i = count - 1; i-- > 0;) add(sorted[i], lower);
    if (count_ > 1) --count_;  // the first point again
}

ConvexHull ConvexHull::difference(const Point& a, const Point& b, std::span<const Point> shape) {
    std::array<Point, maxCorners> points;
    std::size_t count = 0;
    for (const Point& p : shape) {
        points[count++] = a - p;
        if (b != a) points[count++] = b - p;
    }
    return ConvexHull({points.data(), count});
}

double ConvexHull::distance() const {
    if (count_ == 1) return corners_[0].norm();
    const Point origin(0, 0);
    bool inside = count_ > 2;
    double nearest2 = never;
    for (std::size_t i = 0; i < count_; ++i) {
        const Point &from = corner(i), &to = corner(i + 1);
        inside &= cross(from, to) >= 0;
        const Point nearest = from + nearestAlong<Point>(origin, from, to) * (to - from);
        nearest2 = std::min(nearest2, nearest.squaredNorm());
    }
    return inside ? 0 : std::sqrt(nearest2);
}

std::optional<Entry> ConvexHull::enter(const Point& way, double radius) const {
    if (distance() <= radius) return Entry{};
    Entry first{never};
    const auto consider = [&](double fraction, const Point& normal) {
        if (fraction >= 0 && fraction < first.fraction) first = {fraction, normal};
    };
    for (std::size_t i = 0; i < count_; ++i) {
        const Point& from = corner(i);
        const double atEnd = enterCircle(way, from, radius);
        if (atEnd <= 1) consider(atEnd, (atEnd * way - from) / radius);
        if (count_ == 1) break;
        const Point along = corner(i + 1) - from;
        const Point normal = Point(along[1], -along[0]).normalized();
        consider(enterSide(way, from, along, normal, radius), normal);
    }
    if (!(first.fraction <= 1)) return std::nullopt;
    return first;
}

}  // namespace sulfur::detail
