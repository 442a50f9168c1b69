#include "contacts/pair_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contacts/encounters.hpp"
#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"
#include "narrow_phase/convex.hpp"

namespace sulfur::detail {

namespace {

std::uint32_t& headOf(ContactCore& core, std::uint32_t chunk) {
    return core.shapes.chunks[chunk].firstPair;
}

/// Enters a pair with its chunk a (side 0) or b (side 1).
void link(ContactCore& core, std::uint32_t pair, std::uint32_t side) {
    Pair& p = core.pairs[pair];
    const auto chunk = side == 0 ? p.a : p.b;
    auto& head = headOf(core, chunk);
    p.previous[side] = none;
    p.next[side] = head;
    if (head != none) core.pairs[head / 2].previous[head % 2] = 2 * pair + side;
    head = 2 * pair + side;
    ++core.shapes.chunks[chunk].pairs;
    if (p.owner == side) ++core.shapes.chunks[chunk].owned;
}
void unlink(ContactCore& core, std::uint32_t pair, std::uint32_t side) {
    const Pair p = core.pairs[pair];
    const auto chunk = side == 0 ? p.a : p.b;
    const auto next = p.next[side], previous = p.previous[side];
    if (previous != none)
        core.pairs[previous / 2].next[previous % 2] = next;
    else
        headOf(core, chunk) = next;
    if (next != none) core.pairs[next / 2].previous[next % 2] = previous;
    --core.shapes.chunks[chunk].pairs;
    if (p.owner == side) --core.shapes.chunks[chunk].owned;
}

bool isVetoed(const State& state, BodyId a, BodyId b) {
    return !state.vetoes.empty() &&
           std::binary_search(state.vetoes.begin(), state.vetoes.end(), BodyPair::of(a, b));
}

bool mayTouch(const State& state, const Chunk& a, const Chunk& b) {
    const BodyRecord& first = state.bodies[state.bodySlots.denseOf(a.body)];
    const BodyRecord& second = state.bodies[state.bodySlots.denseOf(b.body)];
    if (a.body != b.body) return mayTouch(state, first, second);
    return first.kind == BodyKind::dynamic && !first.sensor && first.selfCollision &&
           a.frame != b.frame;
}

bool areLinked(const ContactCore& core, std::uint32_t a, std::uint32_t b) {
    return !core.linkedBodies.empty() &&
           std::binary_search(core.linkedBodies.begin(), core.linkedBodies.end(), std::pair(a, b));
}

double extentOf(const Chunk& c) {
    return std::max(c.high[0] - c.low[0], c.high[1] - c.low[1]);
}

/// Whose pair it would be: that of the smaller one, because only so many larger ones have room
/// around it.
std::uint32_t ownerOf(const std::vector<Chunk>& chunks, std::uint32_t first, std::uint32_t second) {
    const double one = extentOf(chunks[first]), other = extentOf(chunks[second]);
    if (one == other) return std::max(first, second);
    return one < other ? first : second;
}

std::uint32_t makePair(State& state, std::uint32_t first, std::uint32_t second,
                       std::uint32_t owner) {
    ContactCore& core = state.core;
    const auto& chunks = core.shapes.chunks;
    // What reaches less far from its centre is b, so that turns count little where looks are
    // judged.
    const Real reach1 = core.movers.reach[chunks[first].frame];
    const Real reach2 = core.movers.reach[chunks[second].frame];
    if (reach1 < reach2 || (reach1 == reach2 && second < first)) std::swap(first, second);
    std::uint32_t slot;
    if (core.freePairs.empty()) {
        slot = static_cast<std::uint32_t>(core.pairs.size());
        core.pairs.emplace_back();
    } else {
        slot = core.freePairs.back();
        core.freePairs.pop_back();
        core.pairs[slot] = {};
    }
    Pair& pair = core.pairs[slot];
    pair.a = first;
    pair.b = second;
    pair.owner = owner == first ? 0 : 1;
    const Chunk &a = chunks[first], &b = chunks[second];
    pair.isManifold = a.kind == ChunkKind::convex && b.kind == ChunkKind::convex &&
                              a.body != b.body && !areLinked(core, a.body, b.body)
                          ? 1
                          : 0;
    enterEncounter(state, slot);
    // Who passes through each other takes no room from who collides.
    if (core.encounters[pair.encounter].rowless == Encounter::letPass) pair.owner = 2;
    link(core, slot, 0);
    if (first != second) link(core, slot, 1);
    watchPair(state, slot, -1);  // it is looked at in this step
    return slot;
}

bool isDynamic(const State& state, const Chunk& chunk) {
    return state.bodies[state.bodySlots.denseOf(chunk.body)].kind == BodyKind::dynamic;
}

/// How many pairs the owner of one of these two may have before. What is fixed or driven finds room
/// beside a crowd of what moves.
std::uint32_t mostPairsBefore(const State& state, const Chunk& a, const Chunk& b) {
    const ContactCore& core = state.core;
    if (!isDynamic(state, a) || !isDynamic(state, b)) return tuned::mostPairs;
    const std::size_t chunks = core.awakeChunks.size() + tuned::fewMovers;
    const bool isCrowd = core.watches.size() > tuned::crowdedPairs * chunks;
    return isCrowd ? tuned::crowdedPairs : tuned::mostPairs - tuned::crowdedPairs;
}

bool meet(const Chunk& a, const Chunk& b) {
    return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] &&
           b.low[1] <= a.high[1];
}

}  // namespace

void watchPair(State& state, std::uint32_t pair, double limit) {
    ContactCore& core = state.core;
    Pair& p = core.pairs[pair];
    if (p.watch == none) {
        p.watch = static_cast<std::uint32_t>(core.watches.size());
        const Chunk &a = core.shapes.chunks[p.a], &b = core.shapes.chunks[p.b];
        const auto fineness = static_cast<float>(a.fineness + b.fineness);
        core.watches.push_back({pair, a.frame, b.frame, fineness, limit, p.isManifold});
        core.rooms.emplace_back();
    }
    core.watches[p.watch].limit = limit;
    core.rooms[p.watch].room = 0;
}

namespace {

/// m, from a to b.
Vec2 wayBetween(const Movers& movers, std::uint32_t a, std::uint32_t b) {
    const Point apart = movers.placeAtReference(b) - movers.placeAtReference(a);
    const SolverBody &p = movers.bodies[a], &q = movers.bodies[b];
    return apart.cast<Real>() + Vec2(q.x - p.x, q.y - p.y);
}

/// m, by how much a body's surface can have moved round its centre.
Real turnedSince(const Movers& movers, std::uint32_t m, const Heading& then, const Heading& now) {
    return movers.reach[m] * (std::abs(now.cosine - then.cosine) + std::abs(now.sine - then.sine));
}

/// m, by how much the surfaces of two that were found apart have moved against each other.
Real usedRoom(const Movers& movers, const PairWatch& watch, const PairRoom& then) {
    const Vec2 moved = wayBetween(movers, watch.a, watch.b) - Vec2(then.apartX, then.apartY);
    return moved.norm() + turnedSince(movers, watch.a, then.headA, headingNow(movers, watch.a)) +
           turnedSince(movers, watch.b, then.headB, headingNow(movers, watch.b));
}

const PairRoom& roomOf(const ContactCore& core, const PairWatch& watch) {
    return core.rooms[static_cast<std::size_t>(&watch - core.watches.data())];
}

}  // namespace

void watchApart(State& state, std::uint32_t pair, Real room) {
    ContactCore& core = state.core;
    const Movers& movers = core.movers;
    const Pair& p = core.pairs[pair];
    const auto a = core.shapes.chunks[p.a].frame, b = core.shapes.chunks[p.b].frame;
    watchPair(state, pair, movers.odometer[a] + movers.odometer[b] + static_cast<double>(room));
    const Vec2 apart = wayBetween(movers, a, b);
    core.rooms[p.watch] = {apart[0], apart[1], headingNow(movers, a), headingNow(movers, b), room};
}

namespace {

/// m, by how much the surfaces of a pair move against each other in a step at most.
Real stepOf(const Movers& movers, const PairWatch& watch, const Motion3& wayA,
            const Motion3& wayB) {
    return Vec2(wayB.x - wayA.x, wayB.y - wayA.y).norm() +
           movers.reach[watch.a] * std::abs(wayA.turn) +
           movers.reach[watch.b] * std::abs(wayB.turn);
}

}  // namespace

bool staysApart(const ContactCore& core, const PairWatch& watch, const Motion3& wayA,
                const Motion3& wayB) {
    const PairRoom& then = roomOf(core, watch);
    const Real step = stepOf(core.movers, watch, wayA, wayB);
    return step < then.room && usedRoom(core.movers, watch, then) + step < then.room;
}

bool isDue(ContactCore& core, PairWatch& watch) {
    const Movers& movers = core.movers;
    const PairRoom& then = roomOf(core, watch);
    const Real step = stepOf(movers, watch, motionNow(movers, watch.a), motionNow(movers, watch.b));
    if (!(step < then.room)) return true;
    const Real used = usedRoom(movers, watch, then);
    if (!(used + step < then.room)) return true;
    watch.limit =
        movers.odometer[watch.a] + movers.odometer[watch.b] + static_cast<double>(then.room - used);
    return false;
}

void unwatchPair(State& state, std::uint32_t pair) {
    ContactCore& core = state.core;
    const auto place = std::exchange(core.pairs[pair].watch, none);
    if (place == none) return;
    core.watches[place] = core.watches.back();
    core.watches.pop_back();
    core.rooms[place] = core.rooms.back();
    core.rooms.pop_back();
    if (place < core.watches.size()) core.pairs[core.watches[place].pair].watch = place;
}

void endPair(State& state, std::uint32_t pair) {
    ContactCore& core = state.core;
    dropRows(state, pair);
    leaveEncounter(core, pair);
    unwatchPair(state, pair);
    const bool itself = core.pairs[pair].a == core.pairs[pair].b;
    unlink(core, pair, 0);
    if (!itself) unlink(core, pair, 1);
    core.pairs[pair] = {};
    core.freePairs.push_back(pair);
}

std::uint32_t priceOf(const ContactCore& core, const Pair& pair) {
    const auto& chunks = core.shapes.chunks;
    return pair.isManifold != 0 ? 1 : (chunks[pair.a].corners + chunks[pair.b].corners) / 2;
}

void endPairs(State& state, std::uint32_t chunk) {
    ContactCore& core = state.core;
    while (core.shapes.chunks[chunk].firstPair != none)
        endPair(state, core.shapes.chunks[chunk].firstPair / 2);
}

namespace {

/// Ends the pairs of a chunk that have parted, and lists with whom it has others.
void findKnown(State& state, std::uint32_t index, std::vector<std::uint32_t>& known) {
    ContactCore& core = state.core;
    known.clear();
    for (auto at = core.shapes.chunks[index].firstPair; at != none;) {
        const Pair& p = core.pairs[at / 2];
        const auto next = p.next[at % 2];
        if (meet(core.shapes.chunks[p.a], core.shapes.chunks[p.b]))
            known.push_back(at % 2 == 0 ? p.b : p.a);
        else
            endPair(state, at / 2);
        at = next;
    }
    std::sort(known.begin(), known.end());
}

}  // namespace

bool mayTouch(const State& state, const BodyRecord& a, const BodyRecord& b) {
    if (a.kind != BodyKind::dynamic && b.kind != BodyKind::dynamic) return false;
    if (a.sensor || b.sensor) return false;
    return mayCollide(a.filter, b.filter) && !isVetoed(state, a.id, b.id);
}

void updatePairs(State& state, std::uint32_t index) {
    ContactCore& core = state.core;
    auto& chunks = core.shapes.chunks;
    auto& known = core.again;  // chunks
    findKnown(state, index, known);
    if (chunks[index].owned >= tuned::mostPairs) {
        chunks[index].crowded = 1;
        return;
    }
    const bool wasCrowded = std::exchange(chunks[index].crowded, 0) != 0;
    const Chunk& own = chunks[index];
    const auto meetOther = [&](std::uint32_t other) {
        if (std::binary_search(known.begin(), known.end(), other)) return;
        if (other == index) {
            // The parts of one chunk may touch each other, where they can move.
            const BodyRecord& body = state.bodies[state.bodySlots.denseOf(own.body)];
            if (!body.selfCollision || own.uses < 2 || body.kind != BodyKind::dynamic) return;
        } else if (!mayTouch(state, own, chunks[other])) {
            return;
        }
        const auto owner = ownerOf(chunks, index, other);
        if (chunks[owner].owned >= mostPairsBefore(state, own, chunks[other])) {
            chunks[owner].crowded = 1;
            return;
        }
        const auto pair = makePair(state, index, other, owner);
        // What had to wait for its pair may be in the other already.
        if (wasCrowded || chunks[other].crowded != 0)
            core.leading.push_back(core.pairs[pair].encounter);
    };
    std::uint32_t level = none, met = 0;
    core.grid.forEachWhile(chunks, own.low, own.high, [&](std::uint32_t other) {
        meetOther(other);
        if (chunks[other].level != std::exchange(level, chunks[other].level)) met = 0;
        // Smaller ones are not many for each of them.
        if (level < own.level || ++met < tuned::mostMet) return true;
        chunks[index].crowded = 1;
        return false;
    });
}

}  // namespace sulfur::detail
