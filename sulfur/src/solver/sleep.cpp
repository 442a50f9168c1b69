// Stage: islands that have been at rest for a while fall asleep; what is touched wakes.
#include <algorithm>

#include "core/disjoint_sets.hpp"
#include "rigid/find_clusters.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

constexpr double restingSpeed = 0.005;   // m/s
constexpr Real timeToSleep = Real(0.5);  // s
constexpr double wakingSpeed = 0.02;     // m/s, of what touches a sleeper

bool isDynamic(const State& state, std::uint32_t body) {
    return state.bodies[body].kind == BodyKind::dynamic;
}

void measureRest(State& state) {
    const auto& v = state.particles.velocity;
    for (BodyRecord& body : state.bodies) {
        if (body.kind != BodyKind::dynamic || body.asleep) continue;
        bool resting = true;
        for (std::uint32_t k = 0; k < body.particles.size() && resting; ++k)
            resting = v[body.firstParticle + k].squaredNorm() < restingSpeed * restingSpeed;
        body.restingTime = resting ? body.restingTime + state.h : 0;
    }
}

/// A body that is pushed by a kinematic one, or tied to one that moves, is never at rest.
void tie(State& state, DisjointSets& islands, std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    if (isDynamic(state, a) && isDynamic(state, b)) {
        islands.unite(a, b);
        return;
    }
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
        if (!isDynamic(state, one) || state.bodies[other].kind != BodyKind::kinematic) continue;
        const auto first = state.bodies[other].firstParticle;
        if (state.particles.velocity[first].squaredNorm() > 0) state.bodies[one].restingTime = 0;
    }
}

void findIslands(State& state, DisjointSets& islands) {
    islands.reset(state.bodies.size());
    for (const Contact& c : state.contacts)
        if (c.normalLambda > 0) tie(state, islands, c.bodyA, c.bodyB);
    const auto& body = state.particles.body;
    const Joints& joints = state.joints;
    for (std::size_t j = 0; j < joints.size(); ++j)
        if (joints.body[j] == none) tie(state, islands, body[joints.a[j]], body[joints.b[j]]);
    for (const Attachment& held : state.attachments)
        tie(state, islands, body[held.particle], body[held.support[0]]);
}

void wakeTouched(State& state) {
    for (const auto body : state.knocked) wakeBody(state, body);
    for (const Contact& c : state.contacts) {
        if (static_cast<double>(c.approach) < wakingSpeed) continue;
        for (const auto body : {c.bodyA, c.bodyB})
            if (state.bodies[body].asleep) wakeBody(state, body);
    }
}

bool isMovingKinematic(const State& state, const BodyRecord& body) {
    return body.kind == BodyKind::kinematic &&
           state.particles.velocity[body.firstParticle].squaredNorm() > 0;
}

/// What sleeps on a kinematic body that starts to move does not stay behind.
void wakeCarried(State& state) {
    const bool any = std::any_of(state.bodies.begin(), state.bodies.end(), [&](const auto& body) {
        return isMovingKinematic(state, body);
    });
    if (!any) return;
    const auto& body = state.particles.body;
    for (const ContactMemory& m : state.contactMemory)
        for (const auto& [one, other] : {std::pair(m.particle, m.a), std::pair(m.a, m.particle)})
            if (state.bodies[body[one]].asleep &&
                isMovingKinematic(state, state.bodies[body[other]]))
                wakeBody(state, body[one]);
}

/// What is tied to something that moves moves with it.
void wakeTied(State& state) {
    const auto wake = [&](std::uint32_t p, std::uint32_t q) {
        const auto& body = state.particles.body;
        const auto& v = state.particles.velocity;
        for (const auto& [mover, sleeper] : {std::pair(p, q), std::pair(q, p)})
            if (state.bodies[body[sleeper]].asleep &&
                v[mover].squaredNorm() > wakingSpeed * wakingSpeed)
                wakeBody(state, body[sleeper]);
    };
    const Joints& joints = state.joints;
    for (std::size_t j = 0; j < joints.size(); ++j)
        if (joints.body[j] == none) wake(joints.a[j], joints.b[j]);
    for (const Attachment& held : state.attachments)
        for (std::uint32_t k = 0; k < held.count; ++k) wake(held.particle, held.support[k]);
}

/// Joins the rings of two sleepers, so that they wake together.
void joinRings(State& state, std::uint32_t a, std::uint32_t b) {
    BodyRecord& first = state.bodies[a];
    BodyRecord& second = state.bodies[b];
    if (a == b || !first.asleep || !second.asleep) return;
    const bool alone = first.nextAsleep == first.id || second.nextAsleep == second.id;
    for (BodyId id = first.nextAsleep; !alone && id != first.id;
         id = state.bodies[state.bodySlots.dense(id)].nextAsleep)
        if (id == second.id) return;
    std::swap(first.nextAsleep, second.nextAsleep);
}

}  // namespace

void wakeBody(State& state, std::uint32_t index) {
    BodyRecord* body = &state.bodies[index];
    body->restingTime = 0;
    while (body->asleep) {
        body->asleep = false;
        body->restingTime = 0;
        index = state.bodySlots.dense(body->id);
        restoreInverseMass(state, index);
        body = &state.bodies[state.bodySlots.dense(body->nextAsleep)];
        state.work.stale = true;
        state.broad.pairsStale = true;
    }
}

void wakeTouching(State& state, std::uint32_t gone) {
    const auto& body = state.particles.body;
    for (const ContactMemory& m : state.contactMemory) {
        if (body[m.particle] == gone) wakeBody(state, body[m.a]);
        if (body[m.a] == gone) wakeBody(state, body[m.particle]);
    }
    wakeBody(state, gone);
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
    state.work.stale = true;
    state.broad.pairsStale = true;
}

void updateSleep(State& state) {
    if (!state.settings.sleeping) return;
    wakeTouched(state);
    wakeTied(state);
    wakeCarried(state);
    measureRest(state);
    // Memory is taken when bodies are added, not when they first tire.
    thread_local DisjointSets islands;
    thread_local std::vector<bool> restless;
    islands.reserve(state.bodies.size());
    restless.reserve(state.bodies.size());
    const bool anyTired = std::any_of(
        state.bodies.begin(), state.bodies.end(),
        [](const BodyRecord& body) { return !body.asleep && body.restingTime >= timeToSleep; });
    if (!anyTired) return;
    findIslands(state, islands);
    restless.assign(state.bodies.size(), false);
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i)
        if (isDynamic(state, i) && !state.bodies[i].asleep &&
            state.bodies[i].restingTime < timeToSleep)
            restless[islands.find(i)] = true;
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) {
        if (!isDynamic(state, i) || state.bodies[i].asleep || restless[islands.find(i)]) continue;
        sleepBody(state, i);
    }
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i)
        if (isDynamic(state, i) && state.bodies[i].asleep) joinRings(state, islands.find(i), i);
}

}  // namespace sulfur::detail
