#include "queries/query.hpp"

#include "core/error_checks.hpp"
#include "core/segments.hpp"

namespace sulfur::detail {

namespace {

constexpr double maxQueryCoordinate = 1e7;  // m: ten times as far as things may be

}  // namespace

void requireCoordinates(const Point& point, const char* what) {
    for (int axis = 0; axis < 2; ++axis)
        requireRange(point[axis], -maxQueryCoordinate, maxQueryCoordinate, what);
}

bool admits(const State& state, const QueryFilter& filter, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    return !body.disabled && (body.filter.category & filter.mask) != 0 &&
           body.id != filter.ignore && (filter.sensors || !body.sensor) &&
           (!filter.accept || filter.accept(body.id));
}

std::vector<std::uint32_t> enclosing(State& state, const Point& point, const QueryFilter& filter) {
    std::vector<std::uint32_t> found = bodiesAround(state, point);
    std::erase_if(found, [&](std::uint32_t body) { return !admits(state, filter, body); });
    return found;
}

CastHit hitAt(const State& state, const Strike& strike, const Point& point) {
    const Collider& c = strike.collider;
    CastHit hit;
    hit.body = state.bodies[c.body].id;
    if (c.joint != none) hit.joint = state.joints.id[c.joint];
    hit.point = point;
    hit.normal = strike.entry.normal.cast<Real>();
    hit.fraction = strike.entry.fraction;
    const double along = c.begin + nearestAlong<Point>(point, c.from, c.to) * (c.end - c.begin);
    hit.along = static_cast<Real>(along);
    hit.particle = state.particles.id[along < 0.5 ? c.a : c.b];
    return hit;
}

}  // namespace sulfur::detail
