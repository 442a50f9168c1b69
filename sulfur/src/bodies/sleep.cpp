// Falling asleep and waking up, of one body and of what sleeps with it.
#include <algorithm>

#include "bodies/sleep.hpp"
#include "rigid/find_clusters.hpp"

namespace sulfur::detail {

BodyBounds boundsOf(const State& state, std::uint32_t index, double duration) {
    const BodyRecord& body = state.bodies[index];
    const Particles& p = state.particles;
    BodyBounds bounds;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        const double around = static_cast<double>(p.reach[i]);
        for (const Point& place :
             {p.position[i], Point(p.position[i] + duration * p.velocity[i])}) {
            bounds.extend(Point(place - Point(around, around)));
            bounds.extend(Point(place + Point(around, around)));
        }
    }
    return bounds;
}

void restoreInverseMass(State& state, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    Particles& p = state.particles;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        const bool free = body.kind == BodyKind::dynamic && state.awake(index) && p.pinned[i] == 0;
        p.inverseMass[i] = free ? 1 / p.mass[i] : 0;
    }
    restoreClusterMasses(state, index);
}

void joinSleepers(State& state, std::uint32_t a, std::uint32_t b) {
    BodyRecord& first = state.bodies[a];
    BodyRecord& second = state.bodies[b];
    if (a == b || !first.asleep || !second.asleep) return;
    const bool alone = first.nextAsleep == first.id || second.nextAsleep == second.id;
    for (BodyId id = first.nextAsleep; !alone && id != first.id;
         id = state.bodies[state.bodySlots.dense(id)].nextAsleep)
        if (id == second.id) return;
    std::swap(first.nextAsleep, second.nextAsleep);
}

void wakeBody(State& state, std::uint32_t index) {
    BodyRecord* body = &state.bodies[index];
    body->restingTime = 0;
    while (body->asleep) {
        index = state.bodySlots.dense(body->id);
        body->asleep = false;
        body->restingTime = 0;
        restoreInverseMass(state, index);
        state.turned.push_back(body->id.index - 1);
        body = &state.bodies[state.bodySlots.dense(body->nextAsleep)];
    }
}

void wakeNear(State& state, std::uint32_t index) {
    const BodyBounds own = boundsOf(state, index, 0);
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i)
        if (state.bodies[i].asleep && boundsOf(state, i, 0).intersects(own)) wakeBody(state, i);
}

void sleepBody(State& state, std::uint32_t index) {
    BodyRecord& body = state.bodies[index];
    body.asleep = true;
    body.nextAsleep = body.id;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        state.particles.velocity[i] = Point(0, 0);
        state.particles.displacement[i] = Vec2(0, 0);
        state.particles.inverseMass[i] = 0;
    }
    restoreClusterMasses(state, index);
    state.turned.push_back(body.id.index - 1);
}

}  // namespace sulfur::detail
