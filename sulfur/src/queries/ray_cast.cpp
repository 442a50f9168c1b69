// The surfaces that a straight way meets.
#include <algorithm>
#include <cmath>
#include <limits>

#include "bodies/impl.hpp"
#include "core/error_checks.hpp"
#include "queries/query.hpp"

namespace sulfur {

namespace detail {

namespace {

constexpr double maxReach = 1e6;  // m

/// Calls meet(Strike) for all colliders along the way, some of them repeatedly; it returns the
/// fraction beyond which nothing interests.
template <class Meet>
void cast(State& state, const Point& from, const Point& way, const QueryFilter& filter,
          Meet&& meet) {
    prepareNearby(state);
    double enough = 1;
    forEachColliderAlong(state, from, way, 0, [&](const Collider& c) {
        const auto entry = ConvexHull::difference(c.from, c.to, {&from, 1})
                               .enter(way, static_cast<double>(c.radius));
        if (entry && admits(state, filter, c.body)) enough = meet(Strike{*entry, c});
        return enough;
    });
}

std::optional<CastHit> firstHit(State& state, const Point& from, const Point& way,
                                const QueryFilter& filter) {
    Strike best{{std::numeric_limits<double>::infinity(), {0, 0}}, {}};
    cast(state, from, way, filter, [&](const Strike& strike) {
        best = std::min(best, strike);
        return best.entry.fraction;
    });
    if (best.collider.body == none) return std::nullopt;
    return hitAt(state, best, from + best.entry.fraction * way);
}

}  // namespace

}  // namespace detail

std::optional<CastHit> World::castSegment(Point from, Point to, const QueryFilter& filter) const {
    detail::requireCoordinates(from, "start of the segment");
    detail::requireCoordinates(to, "end of the segment");
    return detail::firstHit(impl_->state(), from, to - from, filter);
}

std::optional<CastHit> World::castRay(Point from, Vec2 direction, double reach,
                                      const QueryFilter& filter) const {
    detail::requireCoordinates(from, "start of the ray");
    detail::requireFinite(direction, "direction of the ray");
    detail::requireRange(reach, 0, detail::maxReach, "reach");
    if (direction.isZero(0))
        throw Error(ErrorCode::degenerate,
                    "direction of the ray is zero; allowed is any length above 0");
    const Point way = reach * direction.cast<double>().stableNormalized();
    return detail::firstHit(impl_->state(), from, way, filter);
}

std::vector<CastHit> World::castAll(Point from, Point to, const QueryFilter& filter) const {
    detail::requireCoordinates(from, "start of the segment");
    detail::requireCoordinates(to, "end of the segment");
    detail::State& state = impl_->state();
    std::vector<detail::Strike> strikes;
    detail::cast(state, from, to - from, filter, [&](const detail::Strike& strike) {
        strikes.push_back(strike);
        return 1.0;
    });
    std::sort(strikes.begin(), strikes.end());
    std::vector<CastHit> hits;
    detail::Collider last;
    for (const detail::Strike& strike : strikes) {
        if (strike.collider == last) continue;
        last = strike.collider;
        hits.push_back(detail::hitAt(state, strike, from + strike.entry.fraction * (to - from)));
    }
    return hits;
}

}  // namespace sulfur
