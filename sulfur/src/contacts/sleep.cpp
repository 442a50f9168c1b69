// Stage: bodies that something comes near wake; islands that have been at rest fall asleep.
//
// An island is what is near each other or tied together. Who is near somebody awake is awake: what
// sleeps never takes an impulse as if it were fixed.
#include <algorithm>
#include <cmath>

#include "contacts/contact_core.hpp"
#include "contacts/stages.hpp"
#include "core/disjoint_sets.hpp"
#include "solver/stages.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

namespace {

constexpr double restingSpeed = 0.005;   // m/s
constexpr Real timeToSleep = Real(0.5);  // s

bool isDynamic(const State& state, std::uint32_t body) {
    return state.bodies[body].kind == BodyKind::dynamic;
}

/// Whether any part of a kinematic body moves; the first particle may be what it turns about.
bool isDriving(const State& state, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    if (body.kind != BodyKind::kinematic) return false;
    const auto first = state.particles.velocity.begin() + body.firstParticle;
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(body.particles.size()),
                       [](const Point& v) { return v.squaredNorm() > 0; });
}

/// Returns whether any body has been at rest for long enough. Not in a step that has changed
/// bodies: the lists are of those before.
bool measureRest(State& state) {
    if (state.structure.stale) return false;
    const auto isMoved = [&](std::uint32_t body) { state.bodies[body].restingTime = -state.h; };
    for (const auto index : state.work.awakeClusters) {
        const Cluster& c = state.clusters.list[index];
        if (c.velocity.norm() + std::abs(c.spin) * c.reach >= restingSpeed) isMoved(c.body);
    }
    for (const Range range : state.work.points)
        for (auto i = range.first; i < range.last; ++i)
            if (state.particles.velocity[i].squaredNorm() >= restingSpeed * restingSpeed)
                isMoved(state.particles.body[i]);
    bool any = false;
    for (const auto index : state.work.bodies) {
        BodyRecord& body = state.bodies[index];
        body.restingTime = isDynamic(state, index) ? body.restingTime + state.h : 0;
        any |= body.restingTime >= timeToSleep;
    }
    return any;
}

/// Calls f(a, b) for bodies (dense) that are near each other or tied together.
template <class Function>
void forEachLink(const State& state, Function&& f) {
    const ContactCore& core = state.core;
    const auto bodyOf = [&](std::uint32_t chunk) {
        return state.bodySlots.denseOf(core.shapes.chunks[chunk].body);
    };
    for (const Pair& pair : core.pairs)
        if (pair.a != none && (pair.row || pair.firstTouch != none))
            f(bodyOf(pair.a), bodyOf(pair.b));
    const auto& body = state.particles.body;
    const Joints& joints = state.joints;
    for (std::size_t j = 0; j < joints.size(); ++j)
        if (joints.body[j] == none) f(body[joints.a[j]], body[joints.b[j]]);
    for (const Attachment& held : state.attachments) f(body[held.particle], body[held.support[0]]);
}

void wake(State& state) {
    auto& list = state.core.toWake;
    for (const auto slot : list)
        if (const auto body = state.bodySlots.denseOf(slot); body != none) wakeBody(state, body);
    list.clear();
    if (state.work.sleepers == 0) return;
    // What is near or tied to somebody awake, or lies on what is driven.
    forEachLink(state, [&](std::uint32_t a, std::uint32_t b) {
        for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
            if (!state.bodies[one].asleep) continue;
            if (isDynamic(state, other) ? !state.bodies[other].asleep : isDriving(state, other))
                wakeBody(state, one);
        }
    });
}

}  // namespace

void updateSleep(State& state) {
    if (!state.settings.sleeping) return;
    wake(state);
    if (!measureRest(state)) return;
    DisjointSets islands(state.bodies.size());
    forEachLink(state, [&](std::uint32_t a, std::uint32_t b) {
        if (isDynamic(state, a) && isDynamic(state, b)) {
            islands.unite(a, b);
            return;
        }
        for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)})
            if (isDynamic(state, one) && isDriving(state, other)) state.bodies[one].restingTime = 0;
    });
    std::vector<bool> restless(state.bodies.size(), false);
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
