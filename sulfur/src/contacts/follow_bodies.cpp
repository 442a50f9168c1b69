// Stage: shapes, pairs and lists follow bodies that were made, changed, fell asleep or woke.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contacts/pair_table.hpp"
#include "contacts/stages.hpp"
#include "core/room.hpp"
#include "model/clusters.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"
#include "shape/make_shapes.hpp"

namespace sulfur::detail {

namespace {

using Links = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

void sortOnce(Links& links) {
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end()), links.end());
}

/// Calls f with what only one of two sorted lists has.
template <class List, class Function>
void forEachChange(const List& now, const List& before, Function&& f) {
    List changed;
    std::set_symmetric_difference(now.begin(), now.end(), before.begin(), before.end(),
                                  std::back_inserter(changed));
    for (const auto& entry : changed) f(entry);
}

/// Joints between bodies that collide. Bodies that get or lose one change their shapes, whatever
/// else ties them.
void findTiedCapsules(State& state) {
    const Joints& joints = state.joints;
    const auto slotOfBody = [&](std::uint32_t i) {
        return state.bodies[state.particles.body[i]].id.index - 1;
    };
    std::vector<TiedCapsule> before = std::exchange(state.core.tiedCapsules, {});
    for (std::uint32_t j = 0; j < joints.size(); ++j)
        if (joints.body[j] == none && joints.radius[j] > 0)
            state.core.tiedCapsules.push_back(
                {joints.id[j], slotOfBody(joints.a[j]), slotOfBody(joints.b[j])});
    std::vector<TiedCapsule> now = state.core.tiedCapsules;
    std::sort(now.begin(), now.end());
    std::sort(before.begin(), before.end());
    forEachChange(now, before, [&](const TiedCapsule& tied) {
        shapeIsStale(state, tied.a);
        shapeIsStale(state, tied.b);
    });
}

/// Particles that are tied to another body never collide with that body.
void findLinks(State& state) {
    ContactCore& core = state.core;
    Links linked, bodies;
    findTiedCapsules(state);
    const auto slotOfParticle = [&](std::uint32_t i) { return state.particles.id[i].index - 1; };
    const auto slotOfBody = [&](std::uint32_t i) {
        return state.bodies[state.particles.body[i]].id.index - 1;
    };
    const auto link = [&](std::uint32_t p, std::uint32_t q) {
        linked.emplace_back(slotOfParticle(p), slotOfBody(q));
        linked.emplace_back(slotOfParticle(q), slotOfBody(p));
        bodies.emplace_back(slotOfBody(p), slotOfBody(q));
        bodies.emplace_back(slotOfBody(q), slotOfBody(p));
    };
    const Joints& joints = state.joints;
    for (std::uint32_t j = 0; j < joints.size(); ++j)
        if (joints.body[j] == none) link(joints.a[j], joints.b[j]);
    for (const Attachment& held : state.attachments)
        for (std::uint32_t k = 0; k < held.count; ++k) link(held.particle, held.support[k]);
    sortOnce(linked);
    sortOnce(bodies);
    // Who was let go of, or tied, may touch others than before.
    forEachChange(linked, core.linked, [&](const auto& tie) {
        shapeIsStale(state, tie.second);
        if (const auto i = state.particleSlots.denseOf(tie.first); i != none)
            shapeIsStale(state, slotOfBody(i));
    });
    core.linked = std::move(linked);
    core.linkedBodies = std::move(bodies);
}

/// Shapes that share a capsule between two bodies change together.
void spreadStaleness(State& state) {
    auto& stale = state.core.staleShapes;
    for (bool grew = true; grew;) {
        grew = false;
        for (const TiedCapsule& tied : state.core.tiedCapsules) {
            const bool hasA = std::find(stale.begin(), stale.end(), tied.a) != stale.end();
            const bool hasB = std::find(stale.begin(), stale.end(), tied.b) != stale.end();
            if (hasA == hasB) continue;
            stale.push_back(hasA ? tied.b : tied.a);
            grew = true;
        }
    }
}

/// How many surfaces of a body bounce, or resist rolling.
std::uint32_t countSurfaces(const State& state, const BodyRecord& body, Real Material::*what) {
    const auto& material = state.joints.material;
    return static_cast<std::uint32_t>(
        (body.material.*what > 0) +
        std::count_if(body.joints.begin(), body.joints.end(),
                      [&](JointId id) { return material[state.jointSlots.dense(id)].*what > 0; }));
}

template <class Function>
void forEachChunk(const ContactCore& core, std::uint32_t bodySlot, Function&& f) {
    const auto& first = core.shapes.firstChunk;
    for (auto c = bodySlot < first.size() ? first[bodySlot] : none; c != none;) {
        const auto chunk = std::exchange(c, core.shapes.chunks[c].nextOfBody);
        f(chunk);
    }
}

/// What one mover carries of an awake chunk.
void listMover(State& state, std::uint32_t m) {
    ContactCore& core = state.core;
    if (core.denseOfMover[m] != none) return;
    const auto leader = core.movers.particle[m];
    if (leader == none) return;
    const auto i = state.particleSlots.denseOf(leader);
    if (!state.awake(state.particles.body[i])) return;
    const auto cluster = state.particles.cluster[i];
    core.awakeMovers.push_back(m);
    core.awakeIsCluster.push_back(cluster != none);
    core.awakeDense.push_back(cluster != none ? cluster : i);
    core.denseOfMover[m] = core.awakeDense.back();
    core.moverIsCluster[m] = core.awakeIsCluster.back();
}

/// What is awake of one body goes to the end of the lists.
void listBody(State& state, std::uint32_t index) {
    ContactCore& core = state.core;
    const bool awake = state.awake(index);
    forEachChunk(core, state.bodies[index].id.index - 1, [&](std::uint32_t c) {
        const Chunk& chunk = core.shapes.chunks[c];
        if (awake) core.awakeChunks.push_back(c);
        if (awake && chunk.uses > 1) core.awakeStrips.push_back(c);
        for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u)
            listMover(state, core.shapes.uses[u].mover);
    });
}

/// Lists what is awake of the bodies that are not in the lists yet.
void listAwake(State& state) {
    ContactCore& core = state.core;
    core.denseOfMover.resize(core.movers.size(), none);
    core.moverIsCluster.resize(core.movers.size(), 0);
    for (; core.listedBodies < state.bodies.size(); ++core.listedBodies) {
        const BodyRecord& body = state.bodies[core.listedBodies];
        core.bouncingPairs += countSurfaces(state, body, &Material::restitution);
        core.rollingSurfaces += countSurfaces(state, body, &Material::rollingResistance);
        if (body.sensor && !body.disabled) state.sensing.bodies.push_back(core.listedBodies);
        if (body.gone == 0) listBody(state, core.listedBodies);
    }
}

/// The part [first, second) of a list in the order of bodies that belongs to one of them.
template <class BodyOf>
std::pair<std::ptrdiff_t, std::ptrdiff_t> partOf(const std::vector<std::uint32_t>& list,
                                                 std::uint32_t body, BodyOf&& bodyOf) {
    const auto from = std::partition_point(list.begin(), list.end(),
                                           [&](std::uint32_t i) { return bodyOf(i) < body; });
    const auto to =
        std::find_if(from, list.end(), [&](std::uint32_t i) { return bodyOf(i) != body; });
    return {from - list.begin(), to - list.begin()};
}

/// Takes what a body carries out of the lists. With capsules between bodies, which carry movers of
/// both, all lists are made anew instead.
void unlistBody(State& state, std::uint32_t index) {
    ContactCore& core = state.core;
    if (core.listsStale || index >= core.listedBodies) return;
    core.listsStale = !core.tiedCapsules.empty();
    if (core.listsStale) return;
    const auto bodyOfChunk = [&](std::uint32_t c) {
        return state.bodySlots.denseOf(core.shapes.chunks[c].body);
    };
    const auto bodyOfMover = [&](std::uint32_t m) {
        return state.bodySlots.denseOf(core.movers.body[m]);
    };
    const auto take = [](auto& list, std::pair<std::ptrdiff_t, std::ptrdiff_t> part) {
        list.erase(list.begin() + part.first, list.begin() + part.second);
    };
    take(core.awakeChunks, partOf(core.awakeChunks, index, bodyOfChunk));
    take(core.awakeStrips, partOf(core.awakeStrips, index, bodyOfChunk));
    const auto part = partOf(core.awakeMovers, index, bodyOfMover);
    for (auto k = part.first; k < part.second; ++k)
        core.denseOfMover[core.awakeMovers[static_cast<std::size_t>(k)]] = none;
    take(core.awakeMovers, part);
    take(core.awakeDense, part);
    take(core.awakeIsCluster, part);
}

/// A body that goes away leaves gaps in the lists, which the next step closes all at once.
void leaveLists(State& state, std::uint32_t index) {
    ContactCore& core = state.core;
    if (core.listsStale || index >= core.listedBodies || !state.awake(index)) return;
    core.listsStale = !core.tiedCapsules.empty();
    if (core.listsStale) return;
    core.listsHaveGaps = true;
    forEachChunk(core, state.bodies[index].id.index - 1, [&](std::uint32_t c) {
        const Chunk& chunk = core.shapes.chunks[c];
        for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u)
            core.denseOfMover[core.shapes.uses[u].mover] = none;
    });
}

/// Before slots of chunks and movers that are gone become others'.
void closeListGaps(State& state) {
    ContactCore& core = state.core;
    if (!std::exchange(core.listsHaveGaps, false) || core.listsStale) return;
    state.statistics.upkeep +=
        core.awakeChunks.size() + core.awakeStrips.size() + core.awakeMovers.size();
    for (auto* list : {&core.awakeChunks, &core.awakeStrips})
        std::erase_if(*list, [&](std::uint32_t c) { return core.shapes.chunks[c].body == none; });
    std::size_t kept = 0;
    for (std::size_t k = 0; k < core.awakeMovers.size(); ++k) {
        if (core.denseOfMover[core.awakeMovers[k]] == none) continue;
        core.awakeMovers[kept] = core.awakeMovers[k];
        core.awakeDense[kept] = core.awakeDense[k];
        core.awakeIsCluster[kept++] = core.awakeIsCluster[k];
    }
    core.awakeMovers.resize(kept);
    core.awakeDense.resize(kept);
    core.awakeIsCluster.resize(kept);
}

/// Lists a body that is in no list, in the order of bodies.
void enlistBody(State& state, std::uint32_t index) {
    ContactCore& core = state.core;
    if (core.listsStale || index >= core.listedBodies) return;
    const auto chunks = static_cast<std::ptrdiff_t>(core.awakeChunks.size());
    const auto strips = static_cast<std::ptrdiff_t>(core.awakeStrips.size());
    const auto movers = static_cast<std::ptrdiff_t>(core.awakeMovers.size());
    listBody(state, index);
    const auto comesBefore = [&](std::uint32_t bodySlot) {
        return state.bodySlots.denseOf(bodySlot) < index;
    };
    const auto ofChunk = [&](std::uint32_t c) { return comesBefore(core.shapes.chunks[c].body); };
    const auto ofMover = [&](std::uint32_t m) { return comesBefore(core.movers.body[m]); };
    const auto placeIn = [](const auto& list, std::ptrdiff_t had, auto&& before) {
        return std::partition_point(list.begin(), list.begin() + had, before) - list.begin();
    };
    const auto bringTo = [](auto& list, std::ptrdiff_t place, std::ptrdiff_t had) {
        std::rotate(list.begin() + place, list.begin() + had, list.end());
    };
    bringTo(core.awakeChunks, placeIn(core.awakeChunks, chunks, ofChunk), chunks);
    bringTo(core.awakeStrips, placeIn(core.awakeStrips, strips, ofChunk), strips);
    const auto place = placeIn(core.awakeMovers, movers, ofMover);
    bringTo(core.awakeMovers, place, movers);
    bringTo(core.awakeDense, place, movers);
    bringTo(core.awakeIsCluster, place, movers);
}

void clearLists(State& state) {
    ContactCore& core = state.core;
    for (auto* list : {&core.awakeMovers, &core.awakeDense, &core.awakeChunks, &core.awakeStrips,
                       &core.denseOfMover})
        list->clear();
    core.awakeIsCluster.clear();
    core.moverIsCluster.clear();
    state.sensing.bodies.clear();
    core.listedBodies = core.bouncingPairs = core.rollingSurfaces = 0;
    for (const auto j : state.work.tiedJoints) {
        if (state.joints.material[j].restitution > 0) ++core.bouncingPairs;
        if (state.joints.material[j].rollingResistance > 0) ++core.rollingSurfaces;
    }
}

bool isAwake(const State& state, std::uint32_t bodySlot) {
    return state.awake(state.bodySlots.denseOf(bodySlot));
}

/// Whether a pair is near enough to have rows and has none, as while it sleeps.
bool lacksRows(const ContactCore& core, const Pair& pair) {
    if (pair.firstTouch != none) return !core.touches[pair.firstTouch].row;
    return isNear(pair) && !pair.row;
}

/// Pairs of sleepers and of what never moves are not watched. Only with somebody awake that rows
/// can push they have rows; with what the caller may move they are watched without, and looked at
/// as soon as the sleeper wakes.
void watchPairOfTurned(State& state, std::uint32_t index) {
    ContactCore& core = state.core;
    const Pair& pair = core.pairs[index];
    bool isWatched = false, hasRows = false;
    for (const auto chunk : {pair.a, pair.b}) {
        const auto slot = core.shapes.chunks[chunk].body;
        if (!isAwake(state, slot)) continue;
        isWatched = true;
        hasRows |= state.bodies[state.bodySlots.denseOf(slot)].kind == BodyKind::dynamic;
    }
    if (pair.watch != none && !hasRows) keepRows(state, index);
    if (isWatched && (pair.watch == none || (hasRows && lacksRows(core, pair))))
        watchPair(state, index, -1);
    else if (!isWatched && pair.watch != none)
        unwatchPair(state, index);
}

/// Who woke or fell asleep since the last step.
void followTurned(State& state) {
    ContactCore& core = state.core;
    for (const auto slot : state.work.turned) {
        const auto body = state.bodySlots.denseOf(slot);
        if (body == none) continue;
        unlistBody(state, body);
        enlistBody(state, body);
        forEachChunk(core, slot, [&](std::uint32_t c) {
            for (auto at = core.shapes.chunks[c].firstPair; at != none;
                 at = core.pairs[at / 2].next[at % 2])
                watchPairOfTurned(state, at / 2);
        });
    }
}

}  // namespace

void removeShape(State& state, std::uint32_t slot) {
    ContactCore& core = state.core;
    if (slot >= core.shapes.firstChunk.size() || core.shapes.firstChunk[slot] == none) return;
    forEachChunk(core, slot, [&](std::uint32_t c) {
        endPairs(state, c);
        core.grid.remove(core.shapes.chunks, c);
    });
    dropShape(state, slot);
}

void makeRoomToForget(State& state, std::uint32_t slot) {
    ContactCore& core = state.core;
    makeRoomFor(core.freePairs, core.pairs.size());
    makeRoomFor(core.freeTouches, core.touches.size());
    makeRoomFor(core.changedEncounters, core.encounters.size());
    makeRoomToDrop(state, slot);
}

void forgetBody(State& state, std::uint32_t index) {
    ContactCore& core = state.core;
    const BodyRecord& body = state.bodies[index];
    if (!core.listsStale && index < core.listedBodies) {
        core.bouncingPairs -= countSurfaces(state, body, &Material::restitution);
        core.rollingSurfaces -= countSurfaces(state, body, &Material::rollingResistance);
    }
    if (body.sensor) std::erase(state.sensing.bodies, index);
    state.sensing.left = true;
    leaveLists(state, index);
    removeShape(state, body.id.index - 1);
}

bool hasLinks(const ContactCore& core, std::uint32_t bodySlot) {
    const auto& linked = core.linkedBodies;
    const auto at = std::lower_bound(linked.begin(), linked.end(), std::pair(bodySlot, 0u));
    return at != linked.end() && at->first == bodySlot;
}

void updateShapes(State& state) {
    ContactCore& core = state.core;
    closeListGaps(state);
    if (state.structureChanged) findLinks(state);
    state.structureChanged = false;
    if (!core.staleShapes.empty()) {
        spreadStaleness(state);
        auto& stale = core.staleShapes;
        std::sort(stale.begin(), stale.end());
        stale.erase(std::unique(stale.begin(), stale.end()), stale.end());
        core.keepsHeirs = true;
        core.listsStale |= std::any_of(stale.begin(), stale.end(), [&](std::uint32_t slot) {
            return state.bodySlots.denseOf(slot) < core.listedBodies;
        });
        for (const auto slot : stale) removeShape(state, slot);
        core.keepsHeirs = false;
        for (const auto slot : stale) {
            const auto body = state.bodySlots.denseOf(slot);
            if (body == none) continue;
            // New pairs of sleepers are looked at once, and not watched any more.
            if (!state.awake(body)) state.turned.push_back(slot);
            makeShape(state, body);
            for (auto c = core.shapes.firstChunk.size() > slot ? core.shapes.firstChunk[slot]
                                                               : none;
                 c != none; c = core.shapes.chunks[c].nextOfBody)
                core.newChunks.push_back(c);
        }
        stale.clear();
    }
    if (core.listsStale || !core.newChunks.empty()) state.sensing.anew = true;
    followTurned(state);
    if (core.listsStale) clearLists(state);
    core.listsStale = false;
    listAwake(state);
}

}  // namespace sulfur::detail
