// The surfaces that a straight way meets.
#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/query.hpp"
#include "core/error_checks.hpp"
#include "world/impl.hpp"

namespace sulfur {

namespace detail {

namespace {

constexpr double maxReach = 1e6;  // m

/// Calls visit(cell, leaving fraction) along the part `span` of the way, until it returns false
/// (Amanatides and Woo 1987: always step over the nearer cell border). In units of cells.
template <class Visit>
void walkCells(const Point& start, const Point& way, const Span& span, Visit&& visit) {
    const Point first = start + span.enter * way;
    Cell cell{static_cast<std::int32_t>(std::floor(first[0])),
              static_cast<std::int32_t>(std::floor(first[1]))};
    std::int32_t* const at[2] = {&cell.x, &cell.y};
    // From the border's own place, not by adding up: a long way must not drift.
    const auto leaveAt = [&](int axis) {
        if (way[axis] == 0) return std::numeric_limits<double>::infinity();
        return (*at[axis] + (way[axis] > 0 ? 1 : 0) - start[axis]) / way[axis];
    };
    double next[2] = {leaveAt(0), leaveAt(1)};
    while (true) {
        const int axis = next[0] < next[1] ? 0 : 1;
        if (!visit(cell, next[axis]) || next[axis] > span.leave) return;
        *at[axis] += way[axis] > 0 ? 1 : -1;
        next[axis] = leaveAt(axis);
    }
}

std::optional<Entry> strike(const State& state, const Collider& c, const Point& from,
                            const Point& way) {
    const auto& x = state.particles.position;
    return ConvexHull::difference(x[c.a], x[c.b], {&from, 1})
        .enter(way, static_cast<double>(c.radius));
}

/// Calls meet(Strike) for all colliders in the cells along the way, some of them repeatedly, until
/// it returns a fraction before the cell's end: nothing beyond interests then.
template <class Meet>
void cast(State& state, const Point& from, const Point& way, const QueryFilter& filter,
          Meet&& meet) {
    prepareQuery(state);
    const BroadPhase& broad = state.broad;
    double enough = std::numeric_limits<double>::infinity();
    const auto test = [&](std::uint32_t number) {
        const Collider& c = broad.collider(number);
        const auto entry = strike(state, c, from, way);
        if (entry && admits(state, filter, c.body)) enough = meet(Strike{*entry, number});
    };
    forEachLarge(broad, test);
    const GridExtent extent = extentOf(broad);
    if (extent.empty) return;
    const Point start = from / broad.cellSize, along = way / broad.cellSize;
    const Span span = clip(start, along, extent.low, extent.high);
    if (span.empty()) return;
    walkCells(start, along, span, [&](Cell cell, double leave) {
        forEachInCell(broad, cell, test);
        return enough > leave;
    });
}

std::optional<CastHit> firstHit(State& state, const Point& from, const Point& way,
                                const QueryFilter& filter) {
    Strike best{{std::numeric_limits<double>::infinity(), {0, 0}}, none};
    cast(state, from, way, filter, [&](const Strike& strike) {
        best = std::min(best, strike);
        return best.entry.fraction;
    });
    if (best.collider == none) return std::nullopt;
    return hitAt(state, best, from + best.entry.fraction * way);
}

}  // namespace

}  // namespace detail

std::optional<CastHit> World::castSegment(Point from, Point to, const QueryFilter& filter) const {
    detail::requireCoordinates(from, "start of the segment");
    detail::requireCoordinates(to, "end of the segment");
    return detail::firstHit(impl_->state, from, to - from, filter);
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
    return detail::firstHit(impl_->state, from, way, filter);
}

std::vector<CastHit> World::castAll(Point from, Point to, const QueryFilter& filter) const {
    detail::requireCoordinates(from, "start of the segment");
    detail::requireCoordinates(to, "end of the segment");
    detail::State& state = impl_->state;
    std::vector<detail::Strike> strikes;
    detail::cast(state, from, to - from, filter, [&](const detail::Strike& strike) {
        strikes.push_back(strike);
        return std::numeric_limits<double>::infinity();
    });
    std::sort(strikes.begin(), strikes.end());
    std::vector<CastHit> hits;
    std::uint32_t last = detail::none;
    for (const detail::Strike& strike : strikes) {
        if (strike.collider == last) continue;
        last = strike.collider;
        hits.push_back(detail::hitAt(state, strike, from + strike.entry.fraction * (to - from)));
    }
    return hits;
}

}  // namespace sulfur
