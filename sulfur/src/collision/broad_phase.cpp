// Stage: candidates from the uniform grid.
#include <algorithm>

#include "collision/geometry.hpp"
#include "collision/rasterise.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

void addCollider(State& state, const Collider& collider) {
    const bool fixed = state.bodies[collider.body].kind == BodyKind::fixed;
    (fixed ? state.broad.fixed : state.broad.moving).push_back(collider);
    state.broad.reach = std::max(state.broad.reach, static_cast<double>(collider.radius));
}

/// A joint between bodies counts as part of its first particle's body, or of the second's when
/// the first cannot move.
std::uint32_t bodyOf(const State& state, std::uint32_t joint) {
    const Joints& joints = state.joints;
    if (joints.body[joint] != none) return joints.body[joint];
    const auto first = state.particles.body[joints.a[joint]];
    return state.bodies[first].kind == BodyKind::fixed ? state.particles.body[joints.b[joint]]
                                                       : first;
}

void collectColliders(State& state) {
    BroadPhase& broad = state.broad;
    const auto fixedBefore = broad.fixed;
    broad.moving.clear();
    broad.fixed.clear();
    broad.reach = 0;
    const Joints& joints = state.joints;
    for (std::uint32_t j = 0; j < joints.size(); ++j)
        if (joints.radius[j] > 0)
            addCollider(state, {joints.a[j], joints.b[j], bodyOf(state, j), j, joints.radius[j]});
    const Particles& particles = state.particles;
    for (std::uint32_t i = 0; i < particles.size(); ++i)
        if (particles.radius[i] > 0)
            addCollider(state, {i, i, particles.body[i], none, particles.radius[i]});
    if (broad.fixed != fixedBefore) broad.fixedStale = true;
}

/// Particles that are tied to another body never collide with that body.
void collectLinks(State& state) {
    auto& linked = state.broad.linked;
    linked.clear();
    const auto& body = state.particles.body;
    const auto link = [&](std::uint32_t p, std::uint32_t q) {
        linked.emplace_back(p, body[q]);
        linked.emplace_back(q, body[p]);
    };
    const Joints& joints = state.joints;
    for (std::size_t j = 0; j < joints.size(); ++j)
        if (joints.body[j] == none) link(joints.a[j], joints.b[j]);
    for (const Attachment& held : state.attachments)
        for (std::uint32_t k = 0; k < held.count; ++k) link(held.particle, held.support[k]);
    std::sort(linked.begin(), linked.end());
    linked.erase(std::unique(linked.begin(), linked.end()), linked.end());
}

/// The cell is as large as the average moving capsule with its skin, so that a capsule covers a
/// few cells and a cell holds a few capsules. It is kept while it is within a factor of two of
/// that, because a change rasterises all fixed geometry again.
void chooseCellSize(State& state) {
    BroadPhase& broad = state.broad;
    const auto& list = broad.moving.empty() ? broad.fixed : broad.moving;
    double sum = 0;
    for (const Collider& c : list) {
        const Point along = state.particles.position[c.b] - state.particles.position[c.a];
        sum += along.norm() + 2 * static_cast<double>(c.radius);
    }
    const double mean =
        list.empty() ? 1.0 : std::clamp(sum / static_cast<double>(list.size()), 0.02, 1e3);
    if (broad.cellSize > 2 * mean || broad.cellSize < mean / 2) {
        broad.cellSize = mean;
        broad.fixedStale = true;
    }
    broad.baseSkin = static_cast<Real>(0.1 * broad.cellSize);
    broad.cellSizeStale = false;
}

/// More cells than this cost more than comparing with everything.
constexpr double mostCellsMoving = 2000;
constexpr double mostCellsFixed = 200000;

/// Returns false, leaving the grid as it was, when the capsule would cover more than `most` cells.
bool rasterise(const State& state, const Collider& collider, Real skin, double most, Grid& grid,
               std::uint32_t number) {
    const BroadPhase& broad = state.broad;
    const auto& x = state.particles.position;
    const Point from = inCells(broad, x[collider.a]), to = inCells(broad, x[collider.b]);
    const double radius = static_cast<double>(collider.radius + skin) / broad.cellSize;
    if (cellsCovered(from, to, radius) > most) return false;
    rasteriseCapsule(from, to, radius, [&](Cell cell) { grid.insert(cell, number); });
    return true;
}

void rasteriseFixed(State& state) {
    BroadPhase& broad = state.broad;
    broad.fixedGrid.clear();
    broad.largeFixed.clear();
    for (std::uint32_t i = 0; i < broad.fixed.size(); ++i)
        if (!rasterise(state, broad.fixed[i], 0, mostCellsFixed, broad.fixedGrid, i))
            broad.largeFixed.push_back(i);
    broad.fixedGrid.build();
    broad.fixedStale = false;
    broad.pairsStale = true;
}

/// A skin as wide as what the fastest end covers in this tick and half of the next, at least.
Real skinOf(const State& state, std::uint32_t particle) {
    return state.broad.baseSkin + Real(1.5) * state.particles.displacement[particle].norm();
}

void rasteriseMoving(State& state) {
    BroadPhase& broad = state.broad;
    broad.reference = state.particles.position;
    broad.skin.assign(state.particles.size(), 0);
    broad.movingGrid.clear();
    broad.largeMoving.clear();
    for (std::uint32_t i = 0; i < broad.moving.size(); ++i) {
        const Collider& c = broad.moving[i];
        const Real skin = std::max(skinOf(state, c.a), skinOf(state, c.b));
        // A particle may leave the narrowest skin of the capsules that it ends.
        for (const auto p : {c.a, c.b})
            broad.skin[p] = broad.skin[p] == 0 ? skin : std::min(broad.skin[p], skin);
        if (!rasterise(state, c, skin, mostCellsMoving, broad.movingGrid, i))
            broad.largeMoving.push_back(i);
    }
    broad.movingGrid.build();
}

bool isVetoed(const State& state, std::uint32_t a, std::uint32_t b) {
    if (state.vetoes.empty()) return false;
    return std::binary_search(state.vetoes.begin(), state.vetoes.end(),
                              BodyPair::of(state.bodies[a].id, state.bodies[b].id));
}

bool mayTouch(const State& state, const Collider& a, const Collider& b) {
    if (!state.movable(a.body) && !state.movable(b.body)) return false;
    if (state.bodies[a.body].sensor || state.bodies[b.body].sensor) return false;
    if (a.body == b.body) return state.bodies[a.body].selfCollision;
    return mayCollide(state.bodies[a.body].filter, state.bodies[b.body].filter) &&
           !isVetoed(state, a.body, b.body);
}

/// Parts of one body that are this near to each other in the blueprint, in thicknesses, belong
/// together and never touch.
constexpr Real togetherWithin = Real(1.2);

bool belongsTogether(const State& state, std::uint32_t particle, const Collider& c) {
    const Particles& p = state.particles;
    if (p.body[particle] != c.body) return false;
    if (particle == c.a || particle == c.b) return true;
    const auto cluster = p.cluster[particle];
    if (cluster != none && cluster == p.cluster[c.a] && cluster == p.cluster[c.b]) return true;
    const Vec2 a = p.rest[c.a], b = p.rest[c.b], at = p.rest[particle];
    const Vec2 nearest = a + nearestAlong<Vec2>(at, a, b) * (b - a);
    return (at - nearest).norm() < togetherWithin * (p.reach[particle] + c.radius);
}

/// Whether the boxes around two colliders, with room for their skins, overlap.
bool boxesOverlap(const State& state, const Collider& a, const Collider& b) {
    const auto& x = state.particles.position;
    const auto& skin = state.broad.skin;
    const double margin = static_cast<double>(a.radius + b.radius + std::max(skin[a.a], skin[a.b]) +
                                              std::max(skin[b.a], skin[b.b]));
    const Point lowA = x[a.a].cwiseMin(x[a.b]), highA = x[a.a].cwiseMax(x[a.b]);
    const Point lowB = x[b.a].cwiseMin(x[b.b]), highB = x[b.a].cwiseMax(x[b.b]);
    return ((lowA - highB).array() <= margin).all() && ((lowB - highA).array() <= margin).all();
}

void collectPairs(State& state) {
    BroadPhase& broad = state.broad;
    auto& pairs = broad.pairs;
    pairs.clear();
    const auto keep = [&](std::uint32_t i, std::uint32_t j) {
        if (mayTouch(state, broad.collider(i), broad.collider(j)))
            pairs.push_back(static_cast<std::uint64_t>(std::min(i, j)) << 32 | std::max(i, j));
    };
    broad.movingGrid.forEachPair(keep);
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    for (const auto& entry : broad.movingGrid.entries())
        broad.fixedGrid.forEachIn(entry.cell,
                                  [&](std::uint32_t fixed) { keep(entry.item, offset + fixed); });
    const auto keepIfNear = [&](std::uint32_t i, std::uint32_t j) {
        if (boxesOverlap(state, broad.collider(i), broad.collider(j))) keep(i, j);
    };
    for (const auto large : broad.largeMoving)
        for (std::uint32_t i = 0; i < offset + broad.fixed.size(); ++i) keepIfNear(large, i);
    for (const auto large : broad.largeFixed)
        for (std::uint32_t i = 0; i < offset; ++i) keepIfNear(i, offset + large);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

void collectCandidates(State& state) {
    BroadPhase& broad = state.broad;
    auto& candidates = broad.candidates;
    candidates.clear();
    const auto add = [&](std::uint32_t particle, std::uint32_t collider) {
        const Collider& c = broad.collider(collider);
        const std::pair link(particle, c.body);
        if (!std::binary_search(broad.linked.begin(), broad.linked.end(), link) &&
            !belongsTogether(state, particle, c))
            candidates.push_back({particle, collider});
    };
    const auto addEnds = [&](std::uint32_t of, std::uint32_t against) {
        const Collider& ends = broad.collider(of);
        add(ends.a, against);
        if (ends.b != ends.a) add(ends.b, against);
    };
    for (const auto pair : broad.pairs) {
        const auto first = static_cast<std::uint32_t>(pair >> 32);
        const auto second = static_cast<std::uint32_t>(pair);
        addEnds(first, second);
        addEnds(second, first);
    }
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
}

/// Whether every collider still is, and with `lookAhead` ticks of displacement stays, inside the
/// skin with which it was rasterised; a quarter of the base skin is left for the contact margin.
bool insideSkins(const State& state, Real lookAhead) {
    const BroadPhase& broad = state.broad;
    const Particles& particles = state.particles;
    for (const Range range : state.work.awake) {
        for (std::uint32_t i = range.first; i < range.last; ++i) {
            if (particles.reach[i] == 0) continue;
            const Vec2 moved = (particles.position[i] - broad.reference[i]).cast<Real>() +
                               lookAhead * particles.displacement[i];
            const Real allowed = broad.skin[i] - broad.baseSkin / 4;
            if (moved.squaredNorm() > allowed * allowed) return false;
        }
    }
    return true;
}

/// What follows from bodies and joints alone.
void collectAnew(State& state) {
    BroadPhase& broad = state.broad;
    updateReach(state);
    collectColliders(state);
    collectLinks(state);
    broad.outlines.derive(state);
    findSpokes(state, broad.spokes);
    listSensors(state);
    broad.collidersStale = false;
    broad.cellSizeStale = true;
    broad.pairsStale = true;
}

}  // namespace

void refreshGrid(State& state, Real lookAhead) {
    BroadPhase& broad = state.broad;
    const bool query = lookAhead == 0;
    if (broad.collidersStale) {
        collectAnew(state);
    } else if (query && broad.queriedTick == state.tick && !broad.fixedStale && !broad.pairsStale) {
        return;
    }
    broad.queriedTick = query ? state.tick : ~std::uint64_t{0};
    // Only ticks choose: the skin that follows from the size decides which contacts there are.
    if (broad.cellSizeStale && !query) chooseCellSize(state);
    if (broad.fixedStale) rasteriseFixed(state);
    if (!broad.pairsStale && insideSkins(state, lookAhead)) return;
    rasteriseMoving(state);
    collectPairs(state);
    collectCandidates(state);
    broad.pairsStale = false;
    ++broad.runs;
}

void updateBroadPhase(State& state) {
    refreshGrid(state, 1);
    state.statistics.broadPhases = state.broad.runs;
    state.statistics.candidates = static_cast<std::uint32_t>(state.broad.candidates.size());
}

}  // namespace sulfur::detail
