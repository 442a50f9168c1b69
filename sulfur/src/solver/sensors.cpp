// Stage: which bodies are in which sensors.
//
// Each tick looks at what is near a sensor, and at nothing where both bodies are still.
#include <algorithm>
#include <array>

#include "queries/query.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

bool feels(const State& state, std::uint32_t sensor, std::uint32_t visitor) {
    const BodyRecord& body = state.bodies[visitor];
    return sensor != visitor && !body.sensor && !body.disabled && body.kind != BodyKind::fixed &&
           mayCollide(state.bodies[sensor].filter, body.filter);
}

/// Whether a visitor's collider touches a sensor's or is inside of its outline.
bool isIn(const State& state, std::uint32_t sensor, const Collider& c) {
    if (encloses(state, sensor, c.from)) return true;
    bool touches = false;
    forEachColliderOf(state, sensor, [&](const Collider& own) {
        const std::array ends{own.from, own.to};
        touches = touches || ConvexHull::difference(c.from, c.to, ends).distance() <=
                                 static_cast<double>(own.radius + c.radius);
    });
    return touches;
}

/// Who is in one sensor.
class Feeling {
public:
    Feeling(State& state, std::uint32_t sensor) : state_(state), sensor_(sensor) {}

    void run() {
        state_.sensing.inside.clear();
        const BodyRecord& body = state_.bodies[sensor_];
        const Particles& p = state_.particles;
        Point low = p.position[body.firstParticle], high = low;
        forEachColliderOf(state_, sensor_, [&](const Collider& c) {
            const Point room = Point::Constant(static_cast<double>(c.radius));
            low = low.cwiseMin(c.from.cwiseMin(c.to) - room);
            high = high.cwiseMax(c.from.cwiseMax(c.to) + room);
        });
        forEachColliderIn(state_, low, high, [&](const Collider& c) { look(c); });
        // A visitor may be so large that all of the sensor is in its hollow.
        for (const auto visitor : bodiesAround(state_, p.position[body.firstParticle]))
            if (feels(state_, sensor_, visitor)) state_.sensing.inside.push_back(visitor);
        for (const auto visitor : state_.sensing.inside)
            state_.sensing.now.push_back(visitOf(visitor));
    }

private:
    Visit visitOf(std::uint32_t visitor) const {
        return {state_.bodies[sensor_].id, state_.bodies[visitor].id};
    }

    void look(const Collider& c) {
        Sensing& sensing = state_.sensing;
        const auto visitor = c.body;
        if (!feels(state_, sensor_, visitor)) return;
        if (std::find(sensing.inside.begin(), sensing.inside.end(), visitor) !=
            sensing.inside.end())
            return;
        ++sensing.looks;
        // Where nothing has moved since the last tick nothing has changed.
        const bool still = !sensing.anew && !state_.awake(sensor_) && !state_.awake(visitor);
        if (still
                ? std::binary_search(sensing.visits.begin(), sensing.visits.end(), visitOf(visitor))
                : isIn(state_, sensor_, c))
            sensing.inside.push_back(visitor);
    }

    State& state_;
    std::uint32_t sensor_;
};

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

void updateSensors(State& state) {
    Sensing& sensing = state.sensing;
    if (sensing.bodies.empty() && sensing.visits.empty()) return;
    if (state.idle && !sensing.anew && !sensing.left) return;
    prepareNearby(state);
    sensing.now.clear();
    sensing.looks = 0;
    for (const auto sensor : sensing.bodies) Feeling(state, sensor).run();
    state.looked(Stage::sensors, sensing.looks);
    sensing.anew = sensing.left = false;
    std::sort(sensing.now.begin(), sensing.now.end());
    sensing.now.erase(std::unique(sensing.now.begin(), sensing.now.end()), sensing.now.end());
    tell(state);
    std::swap(sensing.visits, sensing.now);
}

}  // namespace sulfur::detail
