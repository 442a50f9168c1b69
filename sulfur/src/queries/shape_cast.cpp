// The first surface that a moved shape meets.
#include <algorithm>
#include <limits>

#include "bodies/impl.hpp"
#include "core/segments.hpp"
#include "queries/query.hpp"

namespace sulfur {

namespace detail {

namespace {

/// A disc that covers a shape.
struct Cover {
    Point centre{0, 0};
    double radius = 0;
};

Cover coverOf(const QueryShape& shape) {
    Cover cover;
    for (const Point& p : shape.points()) cover.centre += p;
    cover.centre /= static_cast<double>(shape.points().size());
    for (const Point& p : shape.points())
        cover.radius = std::max(cover.radius, (p - cover.centre).norm());
    cover.radius += shape.radius();
    return cover;
}

/// What lies flat on a capsule touches it along a line, of which this is the middle; two
/// directions are taken as parallel when they differ by less than 1e-9 rad.
constexpr double flatness = 1e-9;

/// Where on a capsule the moved shape touches it when the normal there is `normal`.
Point touchingPoint(const Collider& c, const QueryShape& shape, const Point& moved,
                    const Point& normal) {
    const Point &a = c.from, &b = c.to;
    const double radius = static_cast<double>(c.radius);
    const double rise = normal.dot(b - a), length = (b - a).norm();
    if (std::abs(rise) > flatness * length) return (rise > 0 ? b : a) + radius * normal;
    double lowest = std::numeric_limits<double>::infinity();
    double size = length;
    for (const Point& p : shape.points()) {
        lowest = std::min(lowest, normal.dot(p + moved - a));
        size = std::max(size, (p - shape.points().front()).norm());
    }
    double low = 1, high = 0;
    for (const Point& p : shape.points()) {
        if (normal.dot(p + moved - a) > lowest + flatness * size) continue;
        const double along = nearestAlong<Point>(p + moved, a, b);
        low = std::min(low, along);
        high = std::max(high, along);
    }
    return a + (low + high) / 2 * (b - a) + radius * normal;
}

/// A hit at the start: the point is the place of the capsule's axis nearest to the shape's middle.
CastHit hitAtStart(const State& state, const Strike& strike, const Point& middle) {
    const Collider& c = strike.collider;
    const double along = nearestAlong<Point>(middle, c.from, c.to);
    return hitAt(state, strike, c.from + along * (c.to - c.from));
}

}  // namespace

}  // namespace detail

std::optional<CastHit> World::castShape(const QueryShape& shape, Point translation,
                                        const QueryFilter& filter) const {
    using namespace detail;
    requireCoordinates(translation, "translation");
    State& state = impl_->state();
    prepareNearby(state);
    const Cover cover = coverOf(shape);
    Strike best{{std::numeric_limits<double>::infinity(), {0, 0}}, {}};
    forEachColliderAlong(state, cover.centre, translation, cover.radius, [&](const Collider& c) {
        const auto entry = ConvexHull::difference(c.from, c.to, shape.points())
                               .enter(translation, static_cast<double>(c.radius) + shape.radius());
        if (entry && admits(state, filter, c.body)) best = std::min(best, Strike{*entry, c});
        return best.entry.fraction;
    });
    if (best.entry.fraction > 0) {
        const auto around = enclosing(state, shape.points().front(), filter);
        if (!around.empty()) {
            CastHit inside;
            inside.body = state.bodies[around.front()].id;
            inside.point = shape.points().front();
            return inside;
        }
    }
    if (best.collider.body == none) return std::nullopt;
    if (best.entry.fraction == 0) return hitAtStart(state, best, cover.centre);
    return hitAt(
        state, best,
        touchingPoint(best.collider, shape, best.entry.fraction * translation, best.entry.normal));
}

}  // namespace sulfur
