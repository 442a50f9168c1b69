// Stage: candidates from the uniform grid.
#include <algorithm>

#include "collision/cell_size.hpp"
#include "collision/covering.hpp"
#include "collision/pairs.hpp"
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

/// Room for what packed things have, so that the tick in which a heap has grown together takes no
/// memory: discs in a plane touch six others, each pair makes two candidates.
void reserveRoom(BroadPhase& broad) {
    broad.pairs.reserve(8 * broad.moving.size());
    broad.watches.reserve(16 * broad.moving.size());
    broad.pairRuns.reserve(broad.pairs.capacity());
    broad.watchRuns.reserve(broad.watches.capacity());
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

void useCellSize(BroadPhase& broad) {
    broad.baseSkin = static_cast<Real>(0.1 * broad.cellSize);
    double size = broad.cellSize;
    for (CoarseGrid& grid : broad.coarse) grid.cellSize = size *= coarsening;
}

/// The cell size decides how far off contacts are watched, and with that how the world goes on. So
/// it is chosen by rest lengths and only when bodies or joints have changed, not by when somebody
/// asks for it.
void chooseCellSize(State& state) {
    BroadPhase& broad = state.broad;
    SizeCensus census;
    for (const Collider& c : broad.moving.empty() ? broad.fixed : broad.moving)
        census.add(c.joint == none ? 0 : static_cast<double>(state.joints.restLength[c.joint]),
                   static_cast<double>(c.radius));
    const double size = census.choose(broad.cellSize);
    broad.cellSizeStale = false;
    if (size == broad.cellSize) return;
    broad.cellSize = size;
    broad.fixedStale = broad.pairsStale = true;
    useCellSize(broad);
}

/// More cells than this cost too much memory, even for what is rasterised once.
constexpr double mostCellsFixed = 20000;

/// The finest grid of which a collider covers at most `most` cells, or the coarsest.
std::size_t levelFor(const State& state, const Collider& collider, Real skin, double most) {
    const BroadPhase& broad = state.broad;
    const auto& x = state.particles.position;
    const double radius = static_cast<double>(collider.radius + skin);
    std::size_t level = 0;
    for (; level < broad.coarse.size(); ++level) {
        const double size = cellSizeOf(broad, level);
        if (cellsCovered(x[collider.a] / size, x[collider.b] / size, radius / size) <= most) break;
    }
    return level;
}

void rasteriseFixed(State& state) {
    BroadPhase& broad = state.broad;
    const auto gridOf = [&](std::size_t level) -> Grid& {
        return level == 0 ? broad.fixedGrid : broad.coarse[level - 1].fixed;
    };
    for (std::size_t level = 0; level <= broad.coarse.size(); ++level) gridOf(level).clear();
    broad.largeFixed.clear();
    broad.levelOfFixed.clear();
    for (std::uint32_t i = 0; i < broad.fixed.size(); ++i) {
        const auto level = levelFor(state, broad.fixed[i], 0, mostCellsFixed);
        broad.levelOfFixed.push_back(static_cast<std::uint8_t>(level));
        if (level > 0) broad.largeFixed.push_back(i);
        rasterise(state, broad.fixed[i], 0, level,
                  [&](Cell cell) { gridOf(level).insert(cell, i); });
    }
    for (std::size_t level = 0; level <= broad.coarse.size(); ++level) gridOf(level).build();
    broad.fixedStale = false;
    broad.pairsStale = true;
    ++broad.fixedRuns;
}

/// A skin as wide as what the particle covers in this tick and half of the next, at least; and up
/// to ten ticks, if that is no more than a cell, so that not every tick something leaves its skin.
Real skinOf(const State& state, std::uint32_t particle) {
    const Real cell = static_cast<Real>(state.broad.cellSize);
    const Real step = state.particles.displacement[particle].norm();
    return state.broad.baseSkin + Real(1.5) * step + std::min(Real(8.5) * step, cell);
}

void rasteriseMoving(State& state) {
    BroadPhase& broad = state.broad;
    const auto gridOf = [&](std::size_t level) -> Grid& {
        return level == 0 ? broad.movingGrid : broad.coarse[level - 1].moving;
    };
    broad.reference = state.particles.position;
    broad.skin.assign(state.particles.size(), 0);
    for (std::size_t level = 0; level <= broad.coarse.size(); ++level) gridOf(level).clear();
    broad.largeMoving.clear();
    broad.levelOfMoving.clear();
    for (std::uint32_t i = 0; i < broad.moving.size(); ++i) {
        const Collider& c = broad.moving[i];
        const Real skin = std::max(skinOf(state, c.a), skinOf(state, c.b));
        // A particle may leave the narrowest skin of the capsules that it ends.
        for (const auto p : {c.a, c.b})
            broad.skin[p] = broad.skin[p] == 0 ? skin : std::min(broad.skin[p], skin);
        const auto level = levelFor(state, c, skin, mostCellsMoving);
        broad.levelOfMoving.push_back(static_cast<std::uint8_t>(level));
        if (level > 0) broad.largeMoving.push_back(i);
        rasterise(state, c, skin, level, [&](Cell cell) { gridOf(level).insert(cell, i); });
    }
    for (std::size_t level = 0; level <= broad.coarse.size(); ++level) gridOf(level).build();
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
    reserveRoom(broad);
    useCellSize(broad);
    broad.collidersStale = false;
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
    findPairs(state);
    broad.pairsStale = false;
    ++broad.runs;
}

namespace {

std::uint32_t coveredCells(const BroadPhase& broad) {
    std::size_t cells = broad.movingGrid.entries().size();
    for (const CoarseGrid& grid : broad.coarse) cells += grid.moving.entries().size();
    return static_cast<std::uint32_t>(cells);
}

}  // namespace

void updateBroadPhase(State& state) {
    refreshGrid(state, 1);
    measureOutings(state, state.particles.displacement, state.broad.outings);
    state.statistics.broadPhases = state.broad.runs;
    state.statistics.fixedRebuilds = state.broad.fixedRuns;
    state.statistics.gridCells = coveredCells(state.broad);
    state.statistics.candidates = static_cast<std::uint32_t>(state.broad.watches.size());
}

}  // namespace sulfur::detail
