// The first surface that a ray meets.
#include <cmath>
#include <limits>

#include "collision/geometry.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "solver/stages.hpp"
#include "world/impl.hpp"

namespace sulfur {

namespace detail {

namespace {

struct Strike {
    double fraction = std::numeric_limits<double>::infinity();
    Point normal{0, 0};
    std::uint32_t collider = none;
};

/// Smallest fraction of the way at which a ray from `from` along `way` enters the circle.
double enterCircle(const Point& from, const Point& way, const Point& centre, double radius) {
    const Point offset = from - centre;
    const double a = way.squaredNorm(), b = offset.dot(way);
    const double c = offset.squaredNorm() - radius * radius;
    const double discriminant = b * b - a * c;
    if (a == 0 || discriminant < 0) return std::numeric_limits<double>::infinity();
    return (-b - std::sqrt(discriminant)) / a;
}

/// The ray against a capsule whose ends are `a` and `b`: its two sides, then its two caps.
void strikeCapsule(const Point& from, const Point& way, const Point& a, const Point& b,
                   double radius, std::uint32_t number, Strike& best) {
    const auto consider = [&](double fraction, const Point& normal) {
        if (fraction >= 0 && fraction <= 1 && fraction < best.fraction)
            best = {fraction, normal, number};
    };
    const Point nearest = a + nearestAlong<Point>(from, a, b) * (b - a);
    if ((from - nearest).squaredNorm() <= radius * radius) return consider(0, Point(0, 0));
    const Point along = b - a;
    const double length = along.norm();
    if (length > 0) {
        Point normal = Point(-along[1], along[0]) / length;
        if (normal.dot(from - a) < 0) normal = -normal;
        const double speed = normal.dot(way);
        if (speed < 0) {
            const double fraction = (radius - normal.dot(from - a)) / speed;
            const double place = (from + fraction * way - a).dot(along) / (length * length);
            if (place >= 0 && place <= 1) consider(fraction, normal);
        }
    }
    for (const Point& end : {a, b}) {
        const double fraction = enterCircle(from, way, end, radius);
        if (fraction >= 0 && fraction <= 1)
            consider(fraction, (from + fraction * way - end) / radius);
    }
}

/// Calls visit(cell, leaving fraction) along the way, until it returns false (Amanatides and Woo
/// 1987: always step over the nearer cell border).
template <class Visit>
void walkCells(const Point& from, const Point& to, double cellSize, Visit&& visit) {
    const Point start = from / cellSize, way = (to - from) / cellSize;
    Cell cell{static_cast<std::int32_t>(std::floor(start[0])),
              static_cast<std::int32_t>(std::floor(start[1]))};
    std::int32_t* const at[2] = {&cell.x, &cell.y};
    double next[2], step[2];
    int direction[2];
    for (int axis = 0; axis < 2; ++axis) {
        const double w = way[axis];
        direction[axis] = w > 0 ? 1 : -1;
        const double border = *at[axis] + (w > 0 ? 1 : 0);
        step[axis] = w != 0 ? std::abs(1 / w) : std::numeric_limits<double>::infinity();
        next[axis] = w != 0 ? (border - start[axis]) / w : std::numeric_limits<double>::infinity();
    }
    while (true) {
        const int axis = next[0] < next[1] ? 0 : 1;
        if (!visit(cell, next[axis]) || next[axis] > 1) return;
        *at[axis] += direction[axis];
        next[axis] += step[axis];
    }
}

Strike cast(State& state, const Point& from, const Point& to, const QueryFilter& filter) {
    refreshGrid(state, 0);
    const BroadPhase& broad = state.broad;
    const auto& x = state.particles.position;
    Strike best;
    const auto test = [&](std::uint32_t number) {
        const Collider& c = broad.collider(number);
        const BodyRecord& body = state.bodies[c.body];
        if ((body.filter.category & filter.mask) == 0 || body.id == filter.ignore) return;
        strikeCapsule(from, to - from, x[c.a], x[c.b], static_cast<double>(c.radius), number, best);
    };
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    for (const auto i : broad.largeMoving) test(i);
    for (const auto i : broad.largeFixed) test(offset + i);
    walkCells(from, to, broad.cellSize, [&](Cell cell, double leave) {
        broad.movingGrid.forEachIn(cell, test);
        broad.fixedGrid.forEachIn(cell, [&](std::uint32_t i) { test(offset + i); });
        return best.fraction > leave;
    });
    return best;
}

}  // namespace

}  // namespace detail

std::optional<RayHit> World::castRay(Point from, Point to, const QueryFilter& filter) const {
    for (const Point& p : {from, to})
        for (int axis = 0; axis < 2; ++axis) detail::requireRange(p[axis], -1e7, 1e7, "ray");
    detail::State& state = impl_->state;  // the grid is a cache: queries may bring it up to date
    const detail::Strike strike = detail::cast(state, from, to, filter);
    if (strike.collider == detail::none) return std::nullopt;
    const detail::Collider& c = state.broad.collider(strike.collider);
    const auto& x = state.particles.position;
    RayHit hit;
    hit.body = state.bodies[c.body].id;
    if (c.joint != detail::none) hit.joint = state.joints.id[c.joint];
    hit.point = from + strike.fraction * (to - from);
    hit.normal = strike.normal.cast<Real>();
    hit.fraction = static_cast<Real>(strike.fraction);
    const double along = detail::nearestAlong<Point>(hit.point, x[c.a], x[c.b]);
    hit.along = static_cast<Real>(along);
    hit.particle = state.particles.id[along < 0.5 ? c.a : c.b];
    return hit;
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
