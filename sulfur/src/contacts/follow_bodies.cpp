// Stage: shapes, pairs and lists follow bodies that were made, changed, fell asleep or woke.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contacts/contact_core.hpp"
#include "contacts/pair_table.hpp"
#include "contacts/stages.hpp"
#include "rigid/clusters.hpp"
#include "shape/make_shapes.hpp"
#include "solver/stages.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

namespace {

using Links = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

void sortOnce(Links& links) {
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end()), links.end());
}

/// Particles that are tied to another body never collide with that body.
void findLinks(State& state) {
    ContactCore& core = state.core;
    Links linked, bodies;
    core.tiedCapsules.clear();
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
    for (std::uint32_t j = 0; j < joints.size(); ++j) {
        if (joints.body[j] != none) continue;
        link(joints.a[j], joints.b[j]);
        if (joints.radius[j] > 0) core.tiedCapsules.push_back(j);
    }
    for (const Attachment& held : state.attachments)
        for (std::uint32_t k = 0; k < held.count; ++k) link(held.particle, held.support[k]);
    sortOnce(linked);
    sortOnce(bodies);
    if (linked == core.linked) return;
    // Who was let go of, or tied, may touch others than before.
    Links changed;
    std::set_symmetric_difference(linked.begin(), linked.end(), core.linked.begin(),
                                  core.linked.end(), std::back_inserter(changed));
    for (const auto& [particle, body] : changed) {
        shapeIsStale(state, body);
        if (const auto i = state.particleSlots.denseOf(particle); i != none)
            shapeIsStale(state, slotOfBody(i));
    }
    core.linked = std::move(linked);
    core.linkedBodies = std::move(bodies);
}

/// Shapes that share a capsule between two bodies change together.
void spreadStaleness(State& state) {
    auto& stale = state.core.staleShapes;
    for (bool grew = true; grew;) {
        grew = false;
        for (const auto j : state.core.tiedCapsules) {
            const auto bodyOf = [&](std::uint32_t i) {
                return state.bodies[state.particles.body[i]].id.index - 1;
            };
            const auto a = bodyOf(state.joints.a[j]), b = bodyOf(state.joints.b[j]);
            const bool hasA = std::find(stale.begin(), stale.end(), a) != stale.end();
            const bool hasB = std::find(stale.begin(), stale.end(), b) != stale.end();
            if (hasA == hasB) continue;
            stale.push_back(hasA ? b : a);
            grew = true;
        }
    }
}

/// How many surfaces bounce.
std::uint32_t countBouncing(const State& state, const BodyRecord& body) {
    const auto& material = state.joints.material;
    return static_cast<std::uint32_t>(
        (body.material.restitution > 0) +
        std::count_if(body.joints.begin(), body.joints.end(), [&](JointId id) {
            return material[state.jointSlots.dense(id)].restitution > 0;
        }));
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

/// Lists what is awake of the bodies that are not in the lists yet.
void listAwake(State& state) {
    ContactCore& core = state.core;
    core.denseOfMover.resize(core.movers.size(), none);
    core.moverIsCluster.resize(core.movers.size(), 0);
    for (; core.listedBodies < state.bodies.size(); ++core.listedBodies) {
        const BodyRecord& body = state.bodies[core.listedBodies];
        core.bouncingPairs += countBouncing(state, body);
        const bool awake = state.awake(core.listedBodies);
        const auto slot = body.id.index - 1;
        if (slot >= core.shapes.firstChunk.size()) continue;
        for (auto c = core.shapes.firstChunk[slot]; c != none;
             c = core.shapes.chunks[c].nextOfBody) {
            const Chunk& chunk = core.shapes.chunks[c];
            if (awake) core.awakeChunks.push_back(c);
            if (awake && chunk.uses > 1) core.awakeStrips.push_back(c);
            for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u)
                listMover(state, core.shapes.uses[u].mover);
        }
    }
}

void clearLists(State& state) {
    ContactCore& core = state.core;
    for (auto* list : {&core.awakeMovers, &core.awakeDense, &core.awakeChunks, &core.awakeStrips,
                       &core.denseOfMover})
        list->clear();
    core.awakeIsCluster.clear();
    core.moverIsCluster.clear();
    core.listedBodies = core.bouncingPairs = 0;
    for (const auto j : state.work.tiedJoints)
        if (state.joints.material[j].restitution > 0) ++core.bouncingPairs;
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
void watchAwake(State& state) {
    ContactCore& core = state.core;
    for (std::uint32_t k = 0; k < core.pairs.size(); ++k) {
        const Pair& pair = core.pairs[k];
        if (pair.a == none) continue;
        bool isWatched = false, hasRows = false;
        for (const auto chunk : {pair.a, pair.b}) {
            const auto slot = core.shapes.chunks[chunk].body;
            if (!isAwake(state, slot)) continue;
            isWatched = true;
            hasRows |= state.bodies[state.bodySlots.denseOf(slot)].kind == BodyKind::dynamic;
        }
        if (pair.watch != none && !hasRows) keepRows(state, k);
        if (isWatched && (pair.watch == none || (hasRows && lacksRows(core, pair))))
            watchPair(state, k, -1);
        else if (!isWatched && pair.watch != none)
            unwatchPair(state, k);
    }
}

}  // namespace

void shapeIsStale(State& state, std::uint32_t bodySlot) {
    auto& stale = state.core.staleShapes;
    if (stale.empty() || stale.back() != bodySlot) stale.push_back(bodySlot);
}

void removeShape(State& state, std::uint32_t slot) {
    ContactCore& core = state.core;
    if (slot >= core.shapes.firstChunk.size() || core.shapes.firstChunk[slot] == none) return;
    for (auto c = core.shapes.firstChunk[slot]; c != none; c = core.shapes.chunks[c].nextOfBody) {
        endPairs(state, c);
        core.grid.remove(core.shapes.chunks, c);
    }
    dropShape(state, slot);
    core.listsStale = true;
}

void updateShapes(State& state) {
    ContactCore& core = state.core;
    if (state.structureChanged) findLinks(state);
    state.structureChanged = false;
    bool sleeps = false;  // somebody whose shape is made anew, or never moves
    if (!core.staleShapes.empty()) {
        spreadStaleness(state);
        auto& stale = core.staleShapes;
        std::sort(stale.begin(), stale.end());
        stale.erase(std::unique(stale.begin(), stale.end()), stale.end());
        core.keepsHeirs = true;
        for (const auto slot : stale) removeShape(state, slot);
        core.keepsHeirs = false;
        for (const auto slot : stale) {
            const auto body = state.bodySlots.denseOf(slot);
            if (body == none) continue;
            if (body < core.listedBodies) core.listsStale = true;
            sleeps = sleeps || !state.awake(body);
            makeShape(state, body);
            for (auto c = core.shapes.firstChunk.size() > slot ? core.shapes.firstChunk[slot]
                                                               : none;
                 c != none; c = core.shapes.chunks[c].nextOfBody)
                core.newChunks.push_back(c);
        }
        stale.clear();
    }
    if (core.listsStale) clearLists(state);
    if (core.listsStale || !core.newChunks.empty()) listSensors(state);
    listAwake(state);
    if (core.listsStale) watchAwake(state);
    // New pairs of sleepers are looked at once, and not watched any more.
    core.listsStale = sleeps;
}

}  // namespace sulfur::detail
