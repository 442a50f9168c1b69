// Stage: islands that have been at rest for a while fall asleep; what is touched wakes.
#include <Eigen/Geometry>
#include <algorithm>

#include "contacts/stages.hpp"
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

/// Calls `act` with each body that may be awake. Who woke since the lists were made is in none.
template <class Act>
void forEachMover(State& state, Act&& act) {
    if (!state.work.stale && !state.structure.stale) {
        state.looked(Stage::sleep, state.work.bodies.size());
        for (const auto i : state.work.bodies) act(i);
        return;
    }
    state.looked(Stage::sleep, state.bodies.size());
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) act(i);
}

/// Whether a list of sleepers would be empty. It may not say so until the next tick.
bool nobodySleeps(const State& state) {
    return state.work.sleepers == 0 && !state.work.stale && !state.structure.stale;
}

void measureRest(State& state) {
    const auto& v = state.particles.velocity;
    forEachMover(state, [&](std::uint32_t index) {
        BodyRecord& body = state.bodies[index];
        if (body.kind != BodyKind::dynamic || body.asleep) return;
        bool resting = true;
        for (std::uint32_t k = 0; k < body.particles.size() && resting; ++k)
            resting = v[body.firstParticle + k].squaredNorm() < restingSpeed * restingSpeed;
        body.restingTime = resting ? body.restingTime + state.h : 0;
    });
}

/// Whether any part of a kinematic body moves; the first particle may be what it turns about.
bool isMovingKinematic(const State& state, const BodyRecord& body) {
    if (body.kind != BodyKind::kinematic) return false;
    const auto first = state.particles.velocity.begin() + body.firstParticle;
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(body.particles.size()),
                       [](const Point& v) { return v.squaredNorm() > 0; });
}

/// A body that is pushed by a kinematic one, or tied to one that moves, is never at rest.
void tie(State& state, DisjointSets& islands, std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    if (isDynamic(state, a) && isDynamic(state, b)) {
        islands.unite(a, b);
        return;
    }
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)})
        if (isDynamic(state, one) && isMovingKinematic(state, state.bodies[other]))
            state.bodies[one].restingTime = 0;
}

void findIslands(State& state, DisjointSets& islands) {
    islands.reset(state.bodies.size());
    const auto& body = state.particles.body;
    for (const Contact& c : state.contacts) {
        if (c.normalLambda <= 0) continue;
        tie(state, islands, c.bodyA, c.bodyB);
        tie(state, islands, c.bodyA, body[c.b]);  // of a joint between two bodies, the other one
    }
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

using Bounds = Eigen::AlignedBox<double, 2>;

/// Of all that a body touches with in the next `duration` seconds; joints between bodies and what
/// acts on it are left out.
Bounds boundsOf(const State& state, std::uint32_t index, double duration) {
    const BodyRecord& body = state.bodies[index];
    const Particles& p = state.particles;
    Bounds bounds;
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

/// Whether a body crosses in a tick more than its own thinnest part: the narrow phase first sees
/// it next to what it hits when it hits it.
bool isFast(const State& state, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    if (!state.awake(index) || body.sensor) return false;
    const double tick = static_cast<double>(state.h);
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        const double reach = static_cast<double>(state.particles.reach[i]) / 2;
        const double way2 = state.particles.velocity[i].squaredNorm() * tick * tick;
        if (reach > 0 && way2 > reach * reach) return true;
    }
    return false;
}

/// A sleeper takes no part in the tick in which it is hit, and what is fast would lose in it the
/// momentum that the sleeper should have got. So it wakes a tick before. The two ticks of motion
/// leave room for what speeds it up.
void wakeThreatened(State& state) {
    forEachMover(state, [&](std::uint32_t i) {
        if (!isFast(state, i)) return;
        ++state.statistics.fastBodies;
        const Bounds way = boundsOf(state, i, 2 * static_cast<double>(state.h));
        state.looked(Stage::sleep, state.bodies.size());
        for (std::uint32_t k = 0; k < state.bodies.size(); ++k)
            if (state.bodies[k].asleep &&
                mayCollide(state.bodies[i].filter, state.bodies[k].filter) &&
                boundsOf(state, k, 0).intersects(way))
                wakeBody(state, k);
    });
}

/// What sleeps on a kinematic body that starts to move does not stay behind.
void wakeCarried(State& state) {
    bool any = false;
    const auto look = [&](std::uint32_t i) { any |= isMovingKinematic(state, state.bodies[i]); };
    if (state.work.stale || state.structure.stale)
        for (std::uint32_t i = 0; i < state.bodies.size(); ++i) look(i);
    else
        for (const auto i : state.work.kinematic) look(i);
    if (!any) return;
    const auto& body = state.particles.body;
    for (const ContactMemory& m : state.contactMemory)
        for (const auto& [one, other] : {std::pair(m.particle, m.a), std::pair(m.particle, m.b),
                                         std::pair(m.a, m.particle), std::pair(m.b, m.particle)})
            if (state.bodies[body[one]].asleep &&
                isMovingKinematic(state, state.bodies[body[other]]))
                wakeBody(state, body[one]);
}

/// What is tied to something that moves moves with it.
void wakeTied(State& state) {
    const auto wake = [&](std::uint32_t p, std::uint32_t q) {
        const auto& body = state.particles.body;
        const auto& v = state.particles.velocity;
        for (const auto& [mover, sleeper] : {std::pair(p, q), std::pair(q, p)}) {
            // What the caller moves goes on, however slowly; what physics moves may come to rest.
            const bool driven = state.bodies[body[mover]].kind == BodyKind::kinematic;
            const double least = driven ? 0 : wakingSpeed;
            if (state.bodies[body[sleeper]].asleep && v[mover].squaredNorm() > least * least)
                wakeBody(state, body[sleeper]);
        }
    };
    const Joints& joints = state.joints;
    if (!state.work.stale && !state.structure.stale) {
        for (const auto j : state.work.tiedJoints) wake(joints.a[j], joints.b[j]);
    } else {
        for (std::size_t j = 0; j < joints.size(); ++j)
            if (joints.body[j] == none) wake(joints.a[j], joints.b[j]);
    }
    for (const Attachment& held : state.attachments)
        for (std::uint32_t k = 0; k < held.count; ++k) wake(held.particle, held.support[k]);
}

}  // namespace

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
        body = &state.bodies[state.bodySlots.dense(body->nextAsleep)];
        state.work.changed();
        state.broad.pairsStale = true;
    }
}

void wakeTouching(State& state, std::uint32_t gone) {
    if (state.core.on) return wakeNeighbours(state, gone);
    const auto& body = state.particles.body;
    for (const ContactMemory& m : state.contactMemory) {
        if (body[m.particle] == gone)
            for (const auto end : {m.a, m.b}) wakeBody(state, body[end]);
        if (body[m.a] == gone || body[m.b] == gone) wakeBody(state, body[m.particle]);
    }
    wakeBody(state, gone);
}

void wakeNear(State& state, std::uint32_t index) {
    const Bounds own = boundsOf(state, index, 0);
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
    state.work.changed();
    state.broad.pairsStale = true;
}

void updateSleep(State& state) {
    if (!state.settings.sleeping) return;
    if (!nobodySleeps(state)) {
        wakeTouched(state);
        wakeTied(state);
        wakeCarried(state);
        wakeThreatened(state);
    }
    measureRest(state);
    // Memory is taken when bodies are added, not when they first tire.
    thread_local DisjointSets islands;
    thread_local std::vector<bool> restless;
    islands.reserve(state.bodies.size());
    restless.reserve(state.bodies.size());
    bool anyTired = false;
    forEachMover(state, [&](std::uint32_t i) {
        const BodyRecord& body = state.bodies[i];
        anyTired |= !body.asleep && body.restingTime >= timeToSleep;
    });
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
        if (isDynamic(state, i) && state.bodies[i].asleep) joinSleepers(state, islands.find(i), i);
}

}  // namespace sulfur::detail
