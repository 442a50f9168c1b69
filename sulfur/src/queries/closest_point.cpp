// The surface, and the particle, that is nearest to a point.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "bodies/impl.hpp"
#include "core/error_checks.hpp"
#include "core/segments.hpp"
#include "queries/query.hpp"
#include "shape/outline.hpp"

namespace sulfur {

namespace detail {

namespace {

/// A place on the axis of a capsule or disc, and how far its surface is from the point: negative
/// when the point is inside.
struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    Collider on;
    double along = 0;       // of the collider's own length
    bool outlined = false;  // the point is inside of the body's outline
};

/// By distance; equal ones by joint, then particle, so that the order of the search decides
/// nothing.
bool nearer(const Nearest& x, const Nearest& y) {
    return std::tie(x.distance, x.on.joint, x.on.a) < std::tie(y.distance, y.on.joint, y.on.a);
}

Point axisAt(const Nearest& place) {
    return place.on.from + place.along * (place.on.to - place.on.from);
}
double distanceToAxis(const Point& point, Nearest& place) {
    place.along = nearestAlong<Point>(point, place.on.from, place.on.to);
    return (axisAt(place) - point).norm();
}

/// Capsules of a body's outlines as it is now.
std::vector<RimEdge> outlineOf(const State& state, std::uint32_t body) {
    std::vector<RimEdge> edges;
    for (const auto& loop : findOutlines(state, body))
        edges.insert(edges.end(), loop.begin(), loop.end());
    return edges;
}

/// From inside of an outline the way out leads through the capsule that is nearest beyond.
Nearest wayOut(const State& state, std::uint32_t body, const Point& point) {
    Nearest best;
    for (const RimEdge& edge : outlineOf(state, body)) {
        const auto j = edge.joint;
        const Collider whole{state.joints.a[j], state.joints.b[j], body, j, state.joints.radius[j]};
        forEachPiece(state, whole, [&](const Collider& c) {
            Nearest place{0, c};
            place.outlined = true;
            place.distance = distanceToAxis(point, place) + static_cast<double>(c.radius);
            if (nearer(place, best)) best = place;
        });
    }
    best.distance = -best.distance;
    return best;
}

/// The nearest of the colliders whose bodies' outlines do not enclose the point. It is looked for
/// in boxes that grow, until the next one could find nothing nearer.
Nearest nearestCollider(const State& state, const Point& point, double reach,
                        const QueryFilter& filter, const std::vector<std::uint32_t>& around) {
    Nearest best;
    const auto test = [&](const Collider& c) {
        Nearest place{0, c};
        place.distance = distanceToAxis(point, place) - static_cast<double>(c.radius);
        if (place.distance > reach || !nearer(place, best)) return;
        if (std::binary_search(around.begin(), around.end(), c.body)) return;
        if (admits(state, filter, c.body)) best = place;
    };
    double far = std::max(1e-3, state.core.grid.finestInUse());
    for (;; far *= 4) {
        const double within = std::min(far, reach);
        forEachColliderIn(state, point - Point(within, within), point + Point(within, within),
                          test);
        if (best.distance <= within || within == reach) return best;
    }
}

/// Out of the body at the surface that is nearest to the point.
Point normalAt(const State& state, const Nearest& place, const Point& point, const Point& axis) {
    const Point away = place.outlined ? Point(axis - point) : Point(point - axis);
    if (away.norm() > 0) return away.normalized();
    const Point along = place.on.to - place.on.from;
    if (along.isZero(0)) return {0, 1};
    Point right = Point(along[1], -along[0]).normalized();
    for (const RimEdge& edge : outlineOf(state, place.on.body))
        if (edge.joint == place.on.joint && edge.from == place.on.b) right = -right;
    return right;
}

ClosestPoint describe(const State& state, const Nearest& place, const Point& point) {
    const Point axis = axisAt(place);
    const double along = place.on.begin + place.along * (place.on.end - place.on.begin);
    const Point normal = normalAt(state, place, point, axis);
    ClosestPoint found;
    found.body = state.bodies[place.on.body].id;
    if (place.on.joint != none) found.joint = state.joints.id[place.on.joint];
    found.particle = state.particles.id[along < 0.5 ? place.on.a : place.on.b];
    found.distance = place.distance;
    found.normal = normal.cast<Real>();
    found.point = point - place.distance * normal;
    found.along = static_cast<Real>(along);
    return found;
}

}  // namespace

}  // namespace detail

std::optional<ClosestPoint> World::closestPoint(Point point, double reach,
                                                const QueryFilter& filter) const {
    using namespace detail;
    requireCoordinates(point, "point");
    requireRange(reach, 0, 1e6, "reach");
    State& state = impl_->state();
    prepareNearby(state);
    const auto around = enclosing(state, point, filter);
    Nearest best = nearestCollider(state, point, reach, filter, around);
    for (const auto body : around) {
        const Nearest out = wayOut(state, body, point);
        if (nearer(out, best)) best = out;
    }
    if (best.on.body == none) return std::nullopt;
    return describe(state, best, point);
}

std::optional<ParticleId> World::nearestParticle(Point point, Real reach) const {
    detail::requireFinite(point, "point");
    detail::requireRange(static_cast<double>(reach), 0, 1e9, "reach");
    const detail::State& state = impl_->outside();
    const auto& p = state.particles;
    double best = static_cast<double>(reach) * static_cast<double>(reach);
    std::optional<ParticleId> found;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (state.bodies[p.body[i]].gone > 0 ||
            !detail::isEnabled(state, static_cast<std::uint32_t>(i)))
            continue;
        const double distance = (p.position[i] - point).squaredNorm();
        if (distance > best || (found && distance == best)) continue;
        best = distance;
        found = p.id[i];
    }
    return found;
}

}  // namespace sulfur
