#include "collision/listing.hpp"

#include <algorithm>

#include "collision/covering.hpp"
#include "core/disjoint_sets.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

/// A joint between bodies counts as part of its first particle's body, or of the second's when
/// the first cannot move.
std::uint32_t bodyOf(const State& state, std::uint32_t joint) {
    const Joints& joints = state.joints;
    if (joints.body[joint] != none) return joints.body[joint];
    const auto first = state.particles.body[joints.a[joint]];
    return state.bodies[first].kind == BodyKind::fixed ? state.particles.body[joints.b[joint]]
                                                       : first;
}

/// Calls f(collider) for the capsules, and g(collider) for the discs, that are not of `before`.
template <class Capsule, class Disc>
void forEachCollider(const State& state, const Counts& before, Capsule&& f, Disc&& g) {
    const Joints& joints = state.joints;
    for (auto j = before.joints; j < joints.size(); ++j)
        if (joints.radius[j] > 0)
            f(Collider{joints.a[j], joints.b[j], bodyOf(state, j), j, joints.radius[j]});
    const Particles& particles = state.particles;
    for (auto i = before.particles; i < particles.size(); ++i)
        if (particles.radius[i] > 0)
            g(Collider{i, i, particles.body[i], none, particles.radius[i]});
}

void widenReach(BroadPhase& broad, const Collider& collider) {
    broad.reach = std::max(broad.reach, static_cast<double>(collider.radius));
}

void collectColliders(State& state) {
    BroadPhase& broad = state.broad;
    const auto fixedBefore = broad.fixed;
    const auto thickBefore = broad.fixedCover;
    broad.moving.clear();
    broad.fixed.clear();
    broad.reach = 0;
    const auto add = [&](const Collider& collider) {
        const bool fixed = state.bodies[collider.body].kind == BodyKind::fixed;
        (fixed ? broad.fixed : broad.moving).push_back(collider);
        widenReach(broad, collider);
    };
    forEachCollider(state, {}, add, add);
    broad.fixedCover.clear();
    for (const Collider& c : broad.fixed) broad.fixedCover.push_back(coverRadius(state, c));
    if (broad.fixed != fixedBefore || broad.fixedCover != thickBefore) broad.fixedStale = true;
}

/// Room for what packed things have, so that the tick in which a heap has grown together takes no
/// memory: discs in a plane touch six others, each pair makes two candidates.
void reserveRoom(BroadPhase& broad) {
    // Never by a little: bodies that are added one by one must not copy all of it each time.
    const auto reserve = [](auto& list, std::size_t size) {
        if (list.capacity() < size) list.reserve(std::max(size, 2 * list.capacity()));
    };
    reserve(broad.pairs, 8 * broad.moving.size());
    reserve(broad.watches, 16 * broad.moving.size());
    reserve(broad.pairRuns, broad.pairs.capacity());
    reserve(broad.watchRuns, broad.watches.capacity());
    broad.looks.forEachArray([&](auto& list) { reserve(list, broad.watches.capacity()); });
    reserve(broad.plans, broad.watches.capacity() / 2);
}

/// Particles that are tied to another body never collide with that body.
void collectLinks(State& state) {
    auto& linked = state.broad.linked;
    auto& tied = state.broad.tied;
    linked.clear();
    tied.clear();
    const auto& body = state.particles.body;
    const auto link = [&](std::uint32_t p, std::uint32_t q) {
        linked.emplace_back(p, body[q]);
        linked.emplace_back(q, body[p]);
    };
    const Joints& joints = state.joints;
    for (std::size_t j = 0; j < joints.size(); ++j)
        if (joints.body[j] == none) {
            link(joints.a[j], joints.b[j]);
            tied.emplace_back(body[joints.a[j]], body[joints.b[j]]);
        }
    for (const Attachment& held : state.attachments)
        for (std::uint32_t k = 0; k < held.count; ++k) link(held.particle, held.support[k]);
    std::sort(linked.begin(), linked.end());
    linked.erase(std::unique(linked.begin(), linked.end()), linked.end());
}

/// Gives the particles from `first` on their pieces, numbered after those that there are in the
/// order of their first particles.
void numberPieces(BroadPhase& broad, std::uint32_t first, std::uint32_t size) {
    auto& ofParticle = broad.pieces.ofParticle;
    ofParticle.resize(first);
    ofParticle.resize(size, none);
    DisjointSets sets(size - first);
    for (const Collider& c : broad.moving) {
        if (c.a < first) continue;
        sets.unite(c.a - first, c.b - first);
        ofParticle[c.a] = ofParticle[c.b] = 0;
    }
    std::uint32_t count = broad.pieces.size();
    // The first particle of a set leads it and comes before its others.
    for (auto p = first; p < size; ++p) {
        if (ofParticle[p] == none) continue;
        const auto leader = first + sets.find(p - first);
        ofParticle[p] = leader == p ? count++ : ofParticle[leader];
    }
    broad.hasLeft.resize(count, 0);
    broad.left.reserve(count);
}

/// Lists the numbers in [0, size) by their pieces, of which the first so many have their lists.
template <class PieceOf>
void listByPieces(std::vector<std::uint32_t>& start, std::vector<std::uint32_t>& items,
                  std::uint32_t first, std::size_t count, std::size_t size, PieceOf&& pieceOf) {
    const auto isNew = [&](std::uint32_t i) { return pieceOf(i) != none && pieceOf(i) >= first; };
    start.resize(first);
    start.resize(count + 1, 0);
    start[first] = static_cast<std::uint32_t>(items.size());
    for (std::uint32_t i = 0; i < size; ++i)
        if (isNew(i)) ++start[pieceOf(i) + 1];
    for (std::size_t k = first + 1; k <= count; ++k) start[k] += start[k - 1];
    items.resize(start[count]);
    for (auto i = static_cast<std::uint32_t>(size); i-- > 0;)
        if (isNew(i)) items[--start[pieceOf(i) + 1]] = i;
    for (std::size_t k = first; k < count; ++k) start[k] = start[k + 1];
    start[count] = static_cast<std::uint32_t>(items.size());
}

/// The pieces of the particles from `firstParticle` on.
void collectPieces(State& state, std::uint32_t firstParticle) {
    BroadPhase& broad = state.broad;
    Pieces& pieces = broad.pieces;
    const auto size = static_cast<std::uint32_t>(state.particles.size());
    const auto first = pieces.size();
    numberPieces(broad, firstParticle, size);
    const auto count = broad.hasLeft.size();
    listByPieces(pieces.particleStart, pieces.particles, first, count, size,
                 [&](std::uint32_t p) { return pieces.ofParticle[p]; });
    listByPieces(pieces.colliderStart, pieces.colliders, first, count, broad.moving.size(),
                 [&](std::uint32_t i) { return pieces.ofParticle[broad.moving[i].a]; });
}

/// Colliders that come in between and after those that there are: capsules stand before discs, and
/// moving colliders before fixed ones.
struct Insertion {
    std::uint32_t place = 0, end = 0;  // before this disc, and after the last one
    std::vector<Collider> capsules, discs;

    /// The new number of an old collider. Keeps the order.
    std::uint32_t operator()(std::uint32_t i) const {
        const auto size = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
        return i + (i >= place ? size(capsules) : 0) + (i >= end ? size(discs) : 0);
    }
    /// Makes room, for a value each, in a list by moving colliders (and fixed ones, perhaps).
    template <class T>
    void spread(std::vector<T>& list, const T& value) const {
        list.insert(list.begin() + end, discs.size(), value);
        list.insert(list.begin() + place, capsules.size(), value);
    }
};

Insertion collectAdded(State& state) {
    BroadPhase& broad = state.broad;
    Insertion added;
    const auto isCapsule = [](const Collider& c) { return c.joint != none; };
    const auto& moving = broad.moving;
    added.place = static_cast<std::uint32_t>(
        std::partition_point(moving.begin(), moving.end(), isCapsule) - moving.begin());
    added.end = static_cast<std::uint32_t>(moving.size());
    forEachCollider(
        state, broad.listed, [&](const Collider& c) { added.capsules.push_back(c); },
        [&](const Collider& c) { added.discs.push_back(c); });
    return added;
}

/// Everything that is kept by the numbers of colliders follows them.
void renumber(BroadPhase& broad, const Insertion& added) {
    const auto change = [&](std::uint32_t& i) { i = added(i); };
    for (auto* list : {&broad.largeMoving, &broad.pieces.colliders})
        std::for_each(list->begin(), list->end(), change);
    broad.movingGrid.renumber(change);
    for (CoarseGrid& grid : broad.coarse) grid.moving.renumber(change);
    for (Watch& w : broad.watches) change(w.candidate.collider);
    for (WatchedPair& pair : broad.pairs) {
        change(pair.first);
        change(pair.second);
    }
}

void insert(BroadPhase& broad, const Insertion& added) {
    renumber(broad, added);
    added.spread(broad.levelOfMoving, std::uint8_t{0});
    added.spread(broad.cellsOf, 0u);
    added.spread(broad.surroundings, Surroundings{});
    auto& moving = broad.moving;
    moving.insert(moving.end(), added.discs.begin(), added.discs.end());
    moving.insert(moving.begin() + added.place, added.capsules.begin(), added.capsules.end());
    for (const auto* list : {&added.capsules, &added.discs})
        for (const Collider& c : *list) widenReach(broad, c);
}

/// Whether all that is not listed yet is bodies that can move, and everything else is in the grid
/// and as it was.
bool canAdd(const State& state) {
    const BroadPhase& broad = state.broad;
    if (!broad.onlyAdded || broad.fixedStale || broad.pairsStale) return false;
    if (state.structure.stale || state.work.stale) return false;
    return std::none_of(state.bodies.begin() + broad.listed.bodies, state.bodies.end(),
                        [](const BodyRecord& body) { return body.kind == BodyKind::fixed; });
}

void noteListed(State& state) {
    state.broad.listed = countsOf(state);
    state.broad.collidersStale = state.broad.onlyAdded = false;
}

}  // namespace

void listAnew(State& state) {
    BroadPhase& broad = state.broad;
    updateReach(state);
    collectColliders(state);
    collectLinks(state);
    broad.pieces = {};
    broad.hasLeft.clear();
    broad.left.clear();
    collectPieces(state, 0);
    broad.outlines.derive(state);
    findSpokes(state, broad.spokes);
    listSensors(state);
    reserveRoom(broad);
    broad.setCellSize(broad.cellSize);
    noteListed(state);
    broad.pairsStale = true;
}

bool listAdded(State& state) {
    if (!canAdd(state)) return false;
    BroadPhase& broad = state.broad;
    const Counts before = broad.listed;
    updateReach(state, before);
    insert(broad, collectAdded(state));
    collectPieces(state, before.particles);
    broad.outlines.extend(state, before);
    addSpokes(state, before, broad.spokes);
    listSensors(state);
    reserveRoom(broad);
    const auto& x = state.particles.position;
    broad.reference.insert(broad.reference.end(), x.begin() + before.particles, x.end());
    broad.step.resize(x.size(), -1);
    noteListed(state);
    return true;
}

}  // namespace sulfur::detail
