// Stage: candidates from the uniform grid.
#include <algorithm>

#include "collision/cell_size.hpp"
#include "collision/covering.hpp"
#include "collision/listing.hpp"
#include "collision/pairs.hpp"
#include "collision/skins.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

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
    broad.setCellSize(size);
    broad.fixedStale = broad.pairsStale = true;
}

/// More cells than this cost too much memory, even for what is rasterised once.
constexpr double mostCellsFixed = 20000;

/// The finest grid of which a collider covers at most `most` cells, or the coarsest.
std::size_t levelFor(const State& state, const Collider& collider, Real skin, double most) {
    const BroadPhase& broad = state.broad;
    const auto& x = state.particles.position;
    const double radius = static_cast<double>(coverRadius(state, collider) + skin);
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
        rasterise(state, broad.fixed[i], skinOf(broad, Real(-1)), level,
                  [&](Cell cell) { gridOf(level).insert(cell, i); });
    }
    for (std::size_t level = 0; level <= broad.coarse.size(); ++level) gridOf(level).build();
    broad.fixedStale = false;
    broad.pairsStale = true;
    ++broad.fixedRuns;
}

/// The skin with which a moving collider is drawn now.
Real skinNow(const State& state, const Collider& c) {
    const auto& d = state.particles.displacement;
    return skinFor(state.broad, std::max(d[c.a].norm(), d[c.b].norm()));
}

/// Notes for which step a moving collider is drawn, and finds the grid in which it belongs.
std::size_t placeMoving(State& state, std::uint32_t i) {
    BroadPhase& broad = state.broad;
    const Collider& c = broad.moving[i];
    const auto& d = state.particles.displacement;
    const Real step = std::max(d[c.a].norm(), d[c.b].norm());
    // A particle may leave the narrowest skin of the capsules that it ends.
    for (const auto p : {c.a, c.b})
        broad.step[p] = broad.step[p] < 0 ? step : std::min(broad.step[p], step);
    return levelFor(state, c, skinFor(broad, step), mostCellsMoving);
}

void rasteriseMoving(State& state) {
    BroadPhase& broad = state.broad;
    const auto gridOf = [&](std::size_t level) -> Grid& {
        return level == 0 ? broad.movingGrid : broad.coarse[level - 1].moving;
    };
    broad.reference = state.particles.position;
    broad.step.assign(state.particles.size(), -1);
    for (std::size_t level = 0; level <= broad.coarse.size(); ++level) gridOf(level).clear();
    broad.largeMoving.clear();
    broad.levelOfMoving.clear();
    broad.cellsOf.assign(broad.moving.size(), 0);
    broad.liveCells = 0;
    for (std::uint32_t i = 0; i < broad.moving.size(); ++i) {
        const auto level = placeMoving(state, i);
        broad.levelOfMoving.push_back(static_cast<std::uint8_t>(level));
        if (level > 0) broad.largeMoving.push_back(i);
        const Collider& c = broad.moving[i];
        rasterise(state, c, skinNow(state, c), level, [&](Cell cell) {
            gridOf(level).insert(cell, i);
            ++broad.cellsOf[i];
            ++broad.liveCells;
        });
    }
    for (std::size_t level = 0; level <= broad.coarse.size(); ++level) gridOf(level).build();
    broad.drawnPieces = broad.pieces.size();
}

/// Enters the pieces that have left their skins into the grid once more; where they were entered
/// before, they are found in vain. Returns false where it is better to begin anew: when much has
/// left, when as much was entered since the grid was built as then, or when something large has, or
/// what is tied to fixed geometry by a joint with a surface.
bool rasteriseLeft(State& state) {
    BroadPhase& broad = state.broad;
    const Pieces& pieces = broad.pieces;
    const auto forEachLeft = [&](const auto& start, const auto& list, auto&& f) {
        for (const auto piece : broad.left)
            for (auto k = start[piece]; k < start[piece + 1]; ++k) f(list[k]);
    };
    std::size_t count = 0;
    bool mustBeginAnew = false;
    forEachLeft(pieces.colliderStart, pieces.colliders, [&](std::uint32_t i) {
        ++count;
        mustBeginAnew |= broad.levelOfMoving[i] > 0;
    });
    if (mustBeginAnew || 4 * count > broad.moving.size()) return false;
    if (2 * broad.movingGrid.added() > broad.movingGrid.entries().size()) return false;
    // What others have with fixed geometry is not found again by the colliders of a piece that is
    // tied to it.
    forEachLeft(pieces.particleStart, pieces.particles, [&](std::uint32_t p) {
        mustBeginAnew |= state.bodies[state.particles.body[p]].kind == BodyKind::fixed;
    });
    if (mustBeginAnew) return false;
    forEachLeft(pieces.particleStart, pieces.particles, [&](std::uint32_t p) {
        broad.reference[p] = state.particles.position[p];
        broad.step[p] = -1;
    });
    forEachLeft(pieces.colliderStart, pieces.colliders,
                [&](std::uint32_t i) { mustBeginAnew |= placeMoving(state, i) > 0; });
    if (mustBeginAnew) return false;
    forEachLeft(pieces.colliderStart, pieces.colliders, [&](std::uint32_t i) {
        const Collider& c = broad.moving[i];
        broad.liveCells -= broad.cellsOf[i];
        broad.cellsOf[i] = 0;
        rasterise(state, c, skinNow(state, c), 0, [&](Cell cell) {
            broad.movingGrid.add(cell, i);
            ++broad.cellsOf[i];
            ++broad.liveCells;
        });
    });
    broad.drawnPieces = pieces.size();
    return true;
}

/// Whether a particle is, or with `lookAhead` ticks of displacement will be, further than a share
/// of its leeway from where it was rasterised, or goes too far with them (see skins.hpp).
bool hasUsed(const State& state, std::uint32_t i, Real lookAhead, Real share) {
    const BroadPhase& broad = state.broad;
    const Point &at = state.particles.position[i], &from = broad.reference[i];
    const Vec2& d = state.particles.displacement[i];
    const Vec2 here = (at - from).cast<Real>(), step = lookAhead * d, there = here + step;
    const Real allowed = share * leewayFor(broad, broad.step[i]);
    const Real stride = strideFor(broad, broad.step[i]);
    return std::max(here.squaredNorm(), there.squaredNorm()) > allowed * allowed ||
           step.squaredNorm() > stride * stride;
}

/// Calls f(Range) for the particles of all that is awake and has a surface.
template <class Function>
void forEachAwake(const State& state, Function&& f) {
    for (const Range& range : state.work.awake) f(range);
}

/// Whether any awake surface has used a share of its leeway.
bool anyHasUsed(const State& state, Real lookAhead, Real share) {
    const Particles& p = state.particles;
    const BroadPhase& broad = state.broad;
    const OutingView view = outingsOf(state, p.displacement);
    const SkinBound bound{broad.step.data(), p.reach.data(),
                          broad.baseSkin,    static_cast<Real>(broad.cellSize),
                          lookAhead,         share};
    bool any = false;
    forEachAwake(state, [&](const Range& range) {
        any = any || outingKernels().anyBeyond(view, bound, range.first, range.last);
    });
    return any;
}

/// Calls f(piece) for awake surfaces that have used a share of their leeways.
template <class Function>
void forEachOuting(const State& state, Real lookAhead, Real share, Function&& f) {
    const BroadPhase& broad = state.broad;
    forEachAwake(state, [&](const Range& range) {
        for (auto i = range.first; i < range.last; ++i)
            if (hasUsed(state, i, lookAhead, share) && state.particles.reach[i] > 0)
                f(broad.pieces.ofParticle[i]);
    });
}

/// Notes the pieces that have left their skins, and those that soon will: that saves another look
/// at everything in one of the next ticks. What was never drawn has left too.
void findLeft(State& state, Real lookAhead) {
    constexpr Real soon = Real(0.5);
    BroadPhase& broad = state.broad;
    for (const auto piece : broad.left) broad.hasLeft[piece] = 0;
    broad.left.clear();
    const auto note = [&](std::uint32_t piece) {
        if (broad.hasLeft[piece] != 0) return;
        broad.hasLeft[piece] = 1;
        broad.left.push_back(piece);
    };
    for (auto piece = broad.drawnPieces; piece < broad.pieces.size(); ++piece) note(piece);
    if (!anyHasUsed(state, lookAhead, 1)) return;
    bool any = false;
    forEachOuting(state, lookAhead, 1,
                  [&](std::uint32_t piece) { any = any || broad.hasLeft[piece] == 0; });
    if (any) forEachOuting(state, lookAhead, soon, note);
}

}  // namespace

void refreshGrid(State& state, Real lookAhead) {
    BroadPhase& broad = state.broad;
    const bool query = lookAhead == 0;
    const bool added = broad.collidersStale && listAdded(state);
    if (broad.collidersStale) {
        listAnew(state);
    } else if (!added && query && broad.queriedTick == state.tick && !broad.fixedStale &&
               !broad.pairsStale) {
        return;
    }
    broad.queriedTick = query ? state.tick : ~std::uint64_t{0};
    // Only ticks choose: the skin that follows from the size decides which contacts there are.
    if (broad.cellSizeStale && !query) chooseCellSize(state);
    if (broad.fixedStale) rasteriseFixed(state);
    // Where something broke in the last tick, the lists of who is awake are those before it.
    if (state.structure.stale || state.work.stale) broad.pairsStale = true;
    if (!broad.pairsStale) {
        findLeft(state, lookAhead);
        if (broad.left.empty() && !added) return;
    }
    ++broad.runs;
    if (!broad.pairsStale && rasteriseLeft(state)) return renewPairs(state);
    rasteriseMoving(state);
    findPairs(state);
    broad.pairsStale = false;
}

void updateBroadPhase(State& state) {
    refreshGrid(state, 1);
    measureOutings(state, state.particles.displacement, state.broad.outings);
    state.statistics.broadPhases = state.broad.runs;
    state.statistics.fixedRebuilds = state.broad.fixedRuns;
    state.statistics.gridCells = static_cast<std::uint32_t>(state.broad.liveCells);
    state.statistics.candidates = static_cast<std::uint32_t>(state.broad.watches.size());
}

}  // namespace sulfur::detail
