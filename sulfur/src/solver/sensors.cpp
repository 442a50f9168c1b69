// Stage: which bodies are in which sensors.
//
// Candidates are found when the broad phase has run: colliders of visitors in the cells of a
// sensor's box. In between a tick looks only at these, and at nothing where both bodies are still.
#include <algorithm>
#include <array>

#include "collision/query.hpp"
#include "collision/skins.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

bool feels(const State& state, std::uint32_t sensor, std::uint32_t visitor) {
    const BodyRecord& body = state.bodies[visitor];
    return sensor != visitor && !body.sensor && body.kind != BodyKind::fixed &&
           mayCollide(state.bodies[sensor].filter, body.filter);
}

void collectParts(State& state) {
    const BroadPhase& broad = state.broad;
    auto& parts = state.sensing.parts;
    parts.clear();
    const auto count = static_cast<std::uint32_t>(broad.moving.size() + broad.fixed.size());
    for (std::uint32_t i = 0; i < count; ++i)
        if (state.bodies[broad.collider(i).body].sensor)
            parts.push_back({broad.collider(i).body, i});
    std::sort(parts.begin(), parts.end());
}

/// All colliders that may be within a sensor's box before the broad phase runs again.
void collectAroundSensor(State& state, std::uint32_t sensor) {
    const BroadPhase& broad = state.broad;
    const BodyRecord& body = state.bodies[sensor];
    Point low = broad.reference[body.firstParticle], high = low;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        const double room =
            static_cast<double>(skinOf(broad, broad.step[i]) + state.particles.reach[i]);
        low = low.cwiseMin((broad.reference[i].array() - room).matrix());
        high = high.cwiseMax((broad.reference[i].array() + room).matrix());
    }
    auto& around = state.sensing.around;
    around.clear();
    collectInBox(broad, low, high, around);
}

void findNear(State& state) {
    Sensing& sensing = state.sensing;
    collectParts(state);
    sensing.near.clear();
    for (const auto sensor : sensing.bodies) {
        collectAroundSensor(state, sensor);
        for (const auto number : sensing.around) {
            const auto visitor = state.broad.collider(number).body;
            if (feels(state, sensor, visitor)) sensing.near.push_back({sensor, visitor, number});
        }
    }
    std::sort(sensing.near.begin(), sensing.near.end());
    sensing.run = state.broad.runs;
}

/// Whether a visitor's collider touches a sensor's or is inside of its outline.
bool isIn(const State& state, std::uint32_t sensor, const Collider& c) {
    const auto& x = state.particles.position;
    const auto& parts = state.sensing.parts;
    auto part = std::lower_bound(parts.begin(), parts.end(), Sensing::Part{sensor, 0});
    for (; part != parts.end() && part->sensor == sensor; ++part) {
        const Collider& own = state.broad.collider(part->collider);
        const std::array ends{x[own.a], x[own.b]};
        if (ConvexHull::difference(x[c.a], x[c.b], ends).distance() <=
            static_cast<double>(own.radius + c.radius))
            return true;
    }
    return encloses(state, sensor, x[c.a]);
}

Visit visitOf(const State& state, std::uint32_t sensor, std::uint32_t visitor) {
    return {state.bodies[sensor].id, state.bodies[visitor].id};
}

/// Adds those of the candidates that are in their sensors; where nothing has moved since the last
/// tick nothing has changed.
void addNear(State& state, bool anew) {
    Sensing& sensing = state.sensing;
    for (std::size_t i = 0; i < sensing.near.size();) {
        const auto [sensor, visitor, first] = sensing.near[i];
        const Visit visit = visitOf(state, sensor, visitor);
        const bool still = !anew && !state.awake(sensor) && !state.awake(visitor);
        bool inside =
            still && std::binary_search(sensing.visits.begin(), sensing.visits.end(), visit);
        for (; i < sensing.near.size() && sensing.near[i].sensor == sensor &&
               sensing.near[i].visitor == visitor;
             ++i)
            if (!inside && !still)
                inside = isIn(state, sensor, state.broad.collider(sensing.near[i].collider));
        if (inside) sensing.now.push_back(visit);
    }
}

/// A visitor may be so large that all of the sensor is in its hollow.
void addAround(State& state) {
    Sensing& sensing = state.sensing;
    Hollows& hollows = state.broad.hollows;
    if (hollows.stale(state.broad.runs)) hollows.derive(state);
    std::uint32_t last = none;
    for (const Sensing::Part& part : sensing.parts) {
        const auto sensor = part.sensor;
        if (sensor == last) continue;
        last = sensor;
        const Point& place = state.particles.position[state.broad.collider(part.collider).a];
        hollows.forEachNear(place, [&](std::uint32_t visitor) {
            if (feels(state, sensor, visitor) && encloses(state, visitor, place))
                sensing.now.push_back(visitOf(state, sensor, visitor));
        });
    }
}

/// Tells the differences to the last tick. When a sensor itself is gone, nobody is told.
void tell(State& state) {
    const auto& before = state.sensing.visits;
    const auto& now = state.sensing.now;
    for (const Visit& visit : now)
        if (!std::binary_search(before.begin(), before.end(), visit))
            state.events.sensorsEntered.push_back({visit.sensor, visit.visitor});
    for (const Visit& visit : before)
        if (state.bodySlots.contains(visit.sensor) &&
            !std::binary_search(now.begin(), now.end(), visit))
            state.events.sensorsLeft.push_back({visit.sensor, visit.visitor});
}

}  // namespace

void listSensors(State& state) {
    state.sensing.bodies.clear();
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i)
        if (state.bodies[i].sensor) state.sensing.bodies.push_back(i);
}

void updateSensors(State& state) {
    Sensing& sensing = state.sensing;
    if (sensing.bodies.empty() && sensing.visits.empty()) return;
    refreshGrid(state, 0);
    const bool anew = sensing.run != state.broad.runs;
    if (anew) findNear(state);
    state.looked(Stage::sensors, sensing.near.size());
    sensing.now.clear();
    addNear(state, anew);
    addAround(state);
    std::sort(sensing.now.begin(), sensing.now.end());
    sensing.now.erase(std::unique(sensing.now.begin(), sensing.now.end()), sensing.now.end());
    tell(state);
    std::swap(sensing.visits, sensing.now);
}

}  // namespace sulfur::detail
