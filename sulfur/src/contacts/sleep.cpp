// Stage: bodies that something comes near wake; islands that have been at rest fall asleep.
//
// An island is what is near each other or tied together. Who is near somebody awake is awake: what
// sleeps never takes an impulse as if it were fixed.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bodies/mechanism_bodies.hpp"
#include "bodies/sleep.hpp"
#include "contacts/encounters.hpp"
#include "contacts/pair_table.hpp"
#include "contacts/stages.hpp"
#include "core/disjoint_sets.hpp"
#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/slow_speeds.hpp"
#include "model/state.hpp"
#include "rigid/cluster_motion.hpp"

namespace sulfur::detail {

namespace {

constexpr Real timeToSleep = Real(tuned::timeToSleep);

bool isDynamic(const State& state, std::uint32_t body) {
    return state.bodies[body].kind == BodyKind::dynamic && !state.bodies[body].disabled;
}

/// Whether any part of a kinematic body moves; the first particle may be what it turns about.
bool isDriving(const State& state, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    if (body.kind != BodyKind::kinematic || body.disabled) return false;
    const auto first = state.particles.velocity.begin() + body.firstParticle;
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(body.particles.size()),
                       [](const Point& v) { return v.squaredNorm() > 0; });
}

/// Whether the rim of a disc moves, although it goes nowhere.
bool spinsInPlace(const State& state, const Cluster& c, double restingSpeed) {
    if (!isDisc(c) || c.spin == 0) return false;
    const auto radius = state.particles.radius[state.clusters.members[c.first]];
    return std::abs(c.spin) * static_cast<double>(radius) >= restingSpeed;
}

/// Returns whether any body has been at rest for long enough. Not in a step that has changed
/// bodies: the lists are of those before.
bool measureRest(State& state) {
    if (state.structure.stale) return false;
    const double slow = restingSpeedUnder(state.settings, 1, false);
    const auto restingSpeedOf = [&](std::uint32_t index) {
        if (!state.gravityScaled && !state.damped) return slow;
        const BodyRecord& body = state.bodies[index];
        return restingSpeedUnder(state.settings, body.gravityScale, isDamped(body));
    };
    const auto isMoved = [&](std::uint32_t body) { state.bodies[body].restingTime = -state.h; };
    for (const auto index : state.work.awakeClusters) {
        const Cluster& c = state.clusters.list[index];
        const double restingSpeed = restingSpeedOf(c.body);
        const double rest = restingSpeed - std::abs(c.spin) * c.reach;
        if (spinsInPlace(state, c, restingSpeed) || rest <= 0 ||
            c.velocity.squaredNorm() >= rest * rest)
            isMoved(c.body);
    }
    for (const Range range : state.work.points)
        for (auto i = range.first; i < range.last; ++i) {
            const double restingSpeed = restingSpeedOf(state.particles.body[i]);
            if (state.particles.velocity[i].squaredNorm() >= restingSpeed * restingSpeed)
                isMoved(state.particles.body[i]);
        }
    bool any = false;
    state.looked(Stage::sleep, state.work.bodies.size());
    for (const auto index : state.work.bodies) {
        BodyRecord& body = state.bodies[index];
        const bool mayRest = isDynamic(state, index) && !body.sleepless;
        body.restingTime = mayRest ? body.restingTime + state.h : 0;
        any |= body.restingTime >= timeToSleep;
    }
    return any;
}

/// Calls f(a, b) for bodies (dense) that are near each other.
template <class Function>
void linkIfNear(const State& state, const Pair& pair, Function&& f) {
    const auto bodyOf = [&](std::uint32_t chunk) {
        return state.bodySlots.denseOf(state.core.shapes.chunks[chunk].body);
    };
    if (pair.a != none && isNear(pair)) f(bodyOf(pair.a), bodyOf(pair.b));
}
/// The same for those that are tied together.
template <class Function>
void forEachTie(const State& state, Function&& f) {
    const auto& body = state.particles.body;
    const Joints& joints = state.joints;
    if (!state.work.stale && !state.structure.stale) {
        for (const auto j : state.work.tiedJoints) f(body[joints.a[j]], body[joints.b[j]]);
    } else {
        for (std::size_t j = 0; j < joints.size(); ++j)
            if (joints.body[j] == none) f(body[joints.a[j]], body[joints.b[j]]);
    }
    for (const Attachment& held : state.attachments) f(body[held.particle], body[held.support[0]]);
    for (const Mechanism& m : state.mechanisms.list) forEachTieOf(state, m, f);
}

/// Unites dynamic bodies that are near or tied to each other. Calls onDriver(body) for those that
/// are so to a kinematic body that moves.
template <class Function>
void findIslands(const State& state, DisjointSets& islands, Function&& onDriver) {
    const auto unite = [&](std::uint32_t a, std::uint32_t b) {
        if (isDynamic(state, a) && isDynamic(state, b)) {
            islands.unite(a, b);
            return;
        }
        for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)})
            if (isDynamic(state, one) && isDriving(state, other)) onDriver(one);
    };
    for (const Pair& pair : state.core.pairs) linkIfNear(state, pair, unite);
    // Else each of two that pass through each other would wake the other for ever.
    if (state.callbacks.preSolve)
        for (const auto& [a, b] : state.core.passedBy)
            if (state.bodySlots.denseOf(a) != none && state.bodySlots.denseOf(b) != none)
                unite(state.bodySlots.denseOf(a), state.bodySlots.denseOf(b));
    forEachTie(state, unite);
}

/// Puts to sleep what is awake of the islands for which rests(their first body).
template <class Function>
void sleepIslands(State& state, DisjointSets& islands, Function&& rests) {
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) {
        if (!isDynamic(state, i) || state.bodies[i].asleep || !rests(islands.find(i))) continue;
        bringMembers(state);  // who falls asleep stays where it is
        sleepBody(state, i);
    }
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i)
        if (isDynamic(state, i) && state.bodies[i].asleep) joinSleepers(state, islands.find(i), i);
}

/// What was to act on sleepers in the next tick.
void forgetForces(State& state) {
    const auto sleeps = [&](std::uint32_t particle) {
        return state.bodies[state.particles.body[particle]].asleep;
    };
    for (std::uint32_t i = 0; i < state.particles.size(); ++i)
        if (sleeps(i)) state.particles.force[i] = Point(0, 0);
    std::erase_if(state.discTurns, [&](const DiscTurn& turn) {
        return state.particleSlots.contains(turn.disc) &&
               sleeps(state.particleSlots.dense(turn.disc));
    });
}

void wake(State& state) {
    auto& list = state.core.toWake;
    for (const auto slot : list)
        if (const auto body = state.bodySlots.denseOf(slot); body != none) wakeBody(state, body);
    list.clear();
    if (state.work.sleepers == 0) return;
    // What is near or tied to somebody awake, or lies on what is driven. Sleepers that only
    // sleepers are near are not watched.
    const auto wakeEither = [&](std::uint32_t a, std::uint32_t b) {
        for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
            if (!state.bodies[one].asleep) continue;
            if (isDynamic(state, other) ? !state.bodies[other].asleep : isDriving(state, other))
                wakeBody(state, one);
        }
    };
    state.looked(Stage::sleep, state.core.watches.size());
    // Movers of convex chunks tell who may sleep, without a look at the pair.
    const ContactCore& core = state.core;
    const auto maySleep = [&](std::uint32_t m) {
        return core.denseOfMover[m] == none && core.movers.particle[m] != none;
    };
    for (const PairWatch& watch : core.watches)
        if (watch.isManifold == 0 || maySleep(watch.a) || maySleep(watch.b))
            linkIfNear(state, core.pairs[watch.pair], wakeEither);
    forEachTie(state, wakeEither);
}

}  // namespace

void wakeTouching(State& state, std::uint32_t index) {
    const ContactCore& core = state.core;
    const auto slot = state.bodies[index].id.index - 1;
    const auto wakeSlot = [&](std::uint32_t other) {
        if (const auto body = state.bodySlots.denseOf(other); body != none) wakeBody(state, body);
    };
    auto c = slot < core.shapes.firstChunk.size() ? core.shapes.firstChunk[slot] : none;
    for (; c != none; c = core.shapes.chunks[c].nextOfBody)
        for (auto at = core.shapes.chunks[c].firstPair; at != none;) {
            const Pair& pair = core.pairs[at / 2];
            at = pair.next[at % 2];
            if (!isNear(pair)) continue;
            wakeSlot(core.shapes.chunks[pair.a].body);
            wakeSlot(core.shapes.chunks[pair.b].body);
        }
    // What lies on a capsule between two bodies is near one of them.
    const auto& linked = core.linkedBodies;
    for (auto tie = std::lower_bound(linked.begin(), linked.end(), std::pair(slot, 0u));
         tie != linked.end() && tie->first == slot; ++tie)
        wakeSlot(tie->second);
    wakeBody(state, index);
}

void wakeInTheWay(State& state) {
    const auto sleeps = [](const BodyRecord& body) { return body.asleep; };
    const ContactCore& core = state.core;
    if (state.fresh.empty() && core.struck.empty()) return;
    if (std::none_of(state.bodies.begin(), state.bodies.end(), sleeps)) return;
    bringMembers(state);
    std::pmr::vector<std::uint32_t> movers(&state.arena), inTheWay(&state.arena);
    const auto add = [&](std::uint32_t body) {
        if (body != none && isDynamic(state, body) && state.bodies[body].gone == 0)
            movers.push_back(body);
    };
    for (const auto i : state.fresh)
        if (!state.particles.velocity[i].isZero()) add(state.particles.body[i]);
    for (const auto pair : core.struck)
        for (const auto chunk : {core.pairs[pair].a, core.pairs[pair].b}) {
            if (chunk == none) continue;  // the pair has ended since
            add(state.bodySlots.denseOf(core.shapes.chunks[chunk].body));
        }
    std::sort(movers.begin(), movers.end());
    movers.erase(std::unique(movers.begin(), movers.end()), movers.end());
    for (const auto index : movers) {
        const BodyBounds way = boundsOf(state, index, static_cast<double>(state.h));
        const std::array<double, 2> low{way.min()[0], way.min()[1]},
            high{way.max()[0], way.max()[1]};
        std::uint32_t last = none;  // the chunks of a body lie together in the grid
        core.grid.forEachIn(core.shapes.chunks, low, high, [&](std::uint32_t c) {
            const auto other = state.bodySlots.denseOf(core.shapes.chunks[c].body);
            if (other == none || !state.bodies[other].asleep) return;
            if (std::exchange(last, other) == other) return;
            const BodyRecord &mover = state.bodies[index], &sleeper = state.bodies[other];
            if (mayTouch(state, mover, sleeper) && !passThrough(core, mover.id, sleeper.id) &&
                boundsOf(state, other, 0).intersects(way))
                inTheWay.push_back(other);
        });
    }
    for (const auto body : inTheWay) wakeBody(state, body);
}

void updateSleep(State& state) {
    if (!state.settings.sleeping) return;
    wake(state);
    if (!measureRest(state) || stepNumber(state) % tuned::pileInterval != 0) return;
    DisjointSets islands(state.bodies.size(), &state.arena);
    findIslands(state, islands, [&](std::uint32_t i) { state.bodies[i].restingTime = 0; });
    std::pmr::vector<bool> restless(state.bodies.size(), false, &state.arena);
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i)
        if (isDynamic(state, i) && !state.bodies[i].asleep &&
            state.bodies[i].restingTime < timeToSleep)
            restless[islands.find(i)] = true;
    sleepIslands(state, islands, [&](std::uint32_t first) { return !restless[first]; });
}

bool sleepIsland(State& state, std::uint32_t index) {
    if (!state.settings.sleeping || !isDynamic(state, index)) return false;
    if (state.bodies[index].asleep) return true;
    DisjointSets islands(state.bodies.size());
    std::vector<bool> isDriven(state.bodies.size(), false);
    findIslands(state, islands, [&](std::uint32_t i) { isDriven[i] = true; });
    const auto own = islands.find(index);
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i)
        if (islands.find(i) == own && (isDriven[i] || state.bodies[i].sleepless)) return false;
    sleepIslands(state, islands, [&](std::uint32_t first) { return first == own; });
    forgetForces(state);
    return true;
}

}  // namespace sulfur::detail
