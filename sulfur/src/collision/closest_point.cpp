// The surface, and the particle, that is nearest to a point.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "collision/geometry.hpp"
#include "collision/query.hpp"
#include "core/error_checks.hpp"
#include "world/impl.hpp"

namespace sulfur {

namespace detail {

namespace {

/// A place on the axis of a capsule or disc, and how far its surface is from the point: negative
/// when the point is inside.
struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    std::uint32_t body = none;
    std::uint32_t a = 0, b = 0, joint = none;
    double along = 0;
    bool outlined = false;  // the point is inside of the body's outline
};

/// By distance; equal ones by joint, then particle, so that the order of the search decides
/// nothing.
bool nearer(const Nearest& x, const Nearest& y) {
    return std::tie(x.distance, x.joint, x.a) < std::tie(y.distance, y.joint, y.a);
}

double distanceToAxis(const State& state, const Point& point, Nearest& place) {
    const Point &a = state.particles.position[place.a], &b = state.particles.position[place.b];
    place.along = nearestAlong<Point>(point, a, b);
    return (a + place.along * (b - a) - point).norm();
}

/// From inside of an outline the way out leads through the capsule that is nearest beyond.
Nearest wayOut(const State& state, std::uint32_t body, const Point& point) {
    Nearest best;
    for (const OutlineEdge& edge : state.broad.outlines.of(body)) {
        Nearest place{0, body, state.joints.a[edge.joint], state.joints.b[edge.joint], edge.joint};
        place.outlined = true;
        const double radius = static_cast<double>(state.joints.radius[edge.joint]);
        const double depth = distanceToAxis(state, point, place) + radius;
        place.distance = depth;
        if (nearer(place, best)) best = place;
    }
    best.distance = -best.distance;
    return best;
}

/// Cells, both ends included; 64 bits, because a ring may be wider than the numbers of cells.
struct Strip {
    std::int64_t west = 0, south = 0, east = 0, north = 0;
};

/// The cells at the distance `ring` from a cell, counted like a king moves.
std::array<Strip, 4> stripsOf(std::int64_t x, std::int64_t y, std::int64_t ring) {
    const auto west = x - ring, east = x + ring, south = y - ring, north = y + ring;
    return {{{west, south, east, south},
             {west, north, east, north},
             {west, south + 1, west, north - 1},
             {east, south + 1, east, north - 1}}};
}

std::int64_t cellNumber(double place) {
    return static_cast<std::int64_t>(std::floor(place));
}

/// Calls visit(collider) ring by ring of cells around the point, until what is farther away than
/// `enough()` metres is all that is left. Cells may be visited up to `most`; then false.
template <class Enough, class Visit>
bool searchRings(const BroadPhase& broad, const Point& point, Enough&& enough, std::size_t most,
                 Visit&& visit) {
    const GridExtent extent = extentOf(broad);
    if (extent.empty) return true;
    const auto x = cellNumber(point[0] / broad.cellSize);
    const auto y = cellNumber(point[1] / broad.cellSize);
    const Strip all{cellNumber(extent.low[0]), cellNumber(extent.low[1]),
                    cellNumber(extent.high[0]) - 1, cellNumber(extent.high[1]) - 1};
    const auto sides = {all.west - x, x - all.east, all.south - y, y - all.north};
    const auto nearest = std::max<std::int64_t>(0, std::max(sides));
    const auto farthest = -std::min(sides);
    for (auto ring = nearest; ring <= farthest; ++ring) {
        // Nothing in this ring is nearer than the ring inside of it is wide.
        if (static_cast<double>(ring - 1) * broad.cellSize > enough()) return true;
        for (const Strip& strip : stripsOf(x, y, ring)) {
            const auto north = std::min(strip.north, all.north);
            const auto east = std::min(strip.east, all.east);
            for (auto row = std::max(strip.south, all.south); row <= north; ++row) {
                for (auto column = std::max(strip.west, all.west); column <= east; ++column) {
                    if (most-- == 0) return false;
                    const Cell cell{static_cast<std::int32_t>(column),
                                    static_cast<std::int32_t>(row)};
                    forEachInCell(broad, cell, visit);
                }
            }
            if (ring == 0) break;
        }
    }
    return true;
}

/// The nearest of the colliders whose bodies' outlines do not enclose the point.
Nearest nearestCollider(const State& state, const Point& point, double reach,
                        const QueryFilter& filter, const std::vector<std::uint32_t>& around) {
    const BroadPhase& broad = state.broad;
    Nearest best;
    const auto test = [&](std::uint32_t number) {
        const Collider& c = broad.collider(number);
        Nearest place{0, c.body, c.a, c.b, c.joint};
        place.distance = distanceToAxis(state, point, place) - static_cast<double>(c.radius);
        if (place.distance > reach || !nearer(place, best)) return;
        if (std::binary_search(around.begin(), around.end(), c.body)) return;
        if (admits(state, filter, c.body)) best = place;
    };
    forEachLarge(broad, test);
    const auto enough = [&] { return std::min(reach, best.distance); };
    const auto entries = broad.movingGrid.entries().size() + broad.fixedGrid.entries().size();
    if (searchRings(broad, point, enough, entries + 9, test)) return best;
    std::vector<std::uint32_t> near;
    const Point room(enough(), enough());
    collectInBox(broad, point - room, point + room, near);
    std::for_each(near.begin(), near.end(), test);
    return best;
}

/// Out of the body at the surface that is nearest to the point.
Point normalAt(const State& state, const Nearest& place, const Point& point, const Point& axis) {
    const Point away = place.outlined ? Point(axis - point) : Point(point - axis);
    if (away.norm() > 0) return away.normalized();
    const auto& x = state.particles.position;
    const Point along = x[place.b] - x[place.a];
    if (along.isZero(0)) return {0, 1};
    const int side = place.joint == none ? 1 : state.broad.outlines.outwardOf(place.joint);
    const Point right = Point(along[1], -along[0]).normalized();
    return side < 0 ? Point(-right) : right;
}

ClosestPoint describe(const State& state, const Nearest& place, const Point& point) {
    const auto& x = state.particles.position;
    const Point axis = x[place.a] + place.along * (x[place.b] - x[place.a]);
    const Point normal = normalAt(state, place, point, axis);
    ClosestPoint found;
    found.body = state.bodies[place.body].id;
    if (place.joint != none) found.joint = state.joints.id[place.joint];
    found.particle = state.particles.id[place.along < 0.5 ? place.a : place.b];
    found.distance = place.distance;
    found.normal = normal.cast<Real>();
    found.point = point - place.distance * normal;
    found.along = static_cast<Real>(place.along);
    return found;
}

}  // namespace

}  // namespace detail

std::optional<ClosestPoint> World::closestPoint(Point point, double reach,
                                                const QueryFilter& filter) const {
    using namespace detail;
    requireCoordinates(point, "point");
    requireRange(reach, 0, 1e6, "reach");
    State& state = impl_->state;
    prepareQuery(state);
    const auto around = enclosing(state, point, filter);
    Nearest best = nearestCollider(state, point, reach, filter, around);
    for (const auto body : around) {
        const Nearest out = wayOut(state, body, point);
        if (nearer(out, best)) best = out;
    }
    if (best.body == none) return std::nullopt;
    return describe(state, best, point);
}

std::optional<ParticleId> World::nearestParticle(Point point, Real reach) const {
    detail::requireFinite(point, "point");
    detail::requireRange(static_cast<double>(reach), 0, 1e9, "reach");
    const auto& p = impl_->state.particles;
    double best = static_cast<double>(reach) * static_cast<double>(reach);
    std::optional<ParticleId> found;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double distance = (p.position[i] - point).squaredNorm();
        if (distance > best || (found && distance == best)) continue;
        best = distance;
        found = p.id[i];
    }
    return found;
}

}  // namespace sulfur
