// Stage: candidates from the uniform grid.
#include <algorithm>

#include "collision/cell_size.hpp"
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

/// Room for what packed things have, so that the tick in which a heap has grown together takes no
/// memory: discs in a plane touch six others, each pair makes two candidates.
void reserveRoom(BroadPhase& broad) {
    broad.pairs.reserve(8 * broad.moving.size());
    broad.candidates.reserve(16 * broad.moving.size());
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

double cellSizeOf(const BroadPhase& broad, std::size_t level) {
    return level == 0 ? broad.cellSize : broad.coarse[level - 1].cellSize;
}

/// Places beyond 2^51 cells are further away than any that a caller may give.
Point inCells(const Point& p, double cellSize) {
    return (p / cellSize).cwiseMax(-2e15).cwiseMin(2e15);
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

/// Calls emit(Cell) for the cells of a level that a collider covers.
template <class Emit>
void rasterise(const State& state, const Collider& collider, Real skin, std::size_t level,
               Emit&& emit) {
    const double size = cellSizeOf(state.broad, level);
    const auto& x = state.particles.position;
    const Point from = inCells(x[collider.a], size), to = inCells(x[collider.b], size);
    if (state.settings.rasterisation == Rasterisation::bresenham)
        rasteriseLine(from, to, emit);
    else
        rasteriseCapsule(from, to, static_cast<double>(collider.radius + skin) / size, emit);
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

/// With how wide a skin a collider was rasterised, at least.
Real skinOf(const BroadPhase& broad, const Collider& c) {
    return std::max(broad.skin[c.a], broad.skin[c.b]);
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
    const Vec2 a = p.rest[c.a], b = p.rest[c.b], at = p.rest[particle];
    const Vec2 nearest = a + nearestAlong<Vec2>(at, a, b) * (b - a);
    return (at - nearest).norm() < togetherWithin * (p.reach[particle] + c.radius);
}

/// Whether two colliders, with their skins, can touch: the circle round each reaches the other's
/// capsule. A shared cell does not say so, least of all a large one.
bool areNear(const State& state, const Collider& a, const Collider& b) {
    const auto& x = state.particles.position;
    const double reach =
        static_cast<double>(a.radius + b.radius + skinOf(state.broad, a) + skinOf(state.broad, b));
    const auto circleReaches = [&](const Collider& round, const Collider& other) {
        const Point origin = x[round.a], half = (x[round.b] - origin) / 2;
        const Point from = x[other.a] - origin, to = x[other.b] - origin;
        const Point nearest = from + nearestAlong<Point>(half, from, to) * (to - from);
        const double most = half.norm() + reach;
        // More than the rounding of places that are 1e9 m away.
        return (half - nearest).squaredNorm() <= most * most * (1 + 1e-9) + 1e-12;
    };
    return circleReaches(a, b) && circleReaches(b, a);
}

/// What finer colliders share cells of a coarse grid with. Each is rasterised there too, which for
/// most gives a cell or two.
template <class Keep>
void collectCoarsePairs(const State& state, std::size_t level, Keep&& keep) {
    const BroadPhase& broad = state.broad;
    const CoarseGrid& grid = broad.coarse[level - 1];
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    grid.moving.forEachPair(keep);
    for (const auto& entry : grid.moving.entries())
        grid.fixed.forEachIn(entry.cell,
                             [&](std::uint32_t other) { keep(entry.item, offset + other); });
    const bool moving = !grid.moving.entries().empty();
    if (!moving && grid.fixed.entries().empty()) return;
    for (std::uint32_t i = 0; i < offset; ++i) {
        if (broad.levelOfMoving[i] >= level) continue;
        rasterise(state, broad.moving[i], skinOf(broad, broad.moving[i]), level, [&](Cell cell) {
            grid.moving.forEachIn(cell, [&](std::uint32_t large) { keep(i, large); });
            grid.fixed.forEachIn(cell, [&](std::uint32_t large) { keep(i, offset + large); });
        });
    }
    for (std::uint32_t i = 0; moving && i < broad.fixed.size(); ++i) {
        if (broad.levelOfFixed[i] >= level) continue;
        rasterise(state, broad.fixed[i], 0, level, [&](Cell cell) {
            grid.moving.forEachIn(cell, [&](std::uint32_t large) { keep(large, offset + i); });
        });
    }
}

void collectPairs(State& state) {
    BroadPhase& broad = state.broad;
    auto& pairs = broad.pairs;
    pairs.clear();
    const auto keep = [&](std::uint32_t i, std::uint32_t j) {
        const Collider &a = broad.collider(i), &b = broad.collider(j);
        if (mayTouch(state, a, b) && areNear(state, a, b))
            pairs.push_back(static_cast<std::uint64_t>(std::min(i, j)) << 32 | std::max(i, j));
    };
    broad.movingGrid.forEachPair(keep);
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    for (const auto& entry : broad.movingGrid.entries())
        broad.fixedGrid.forEachIn(entry.cell,
                                  [&](std::uint32_t fixed) { keep(entry.item, offset + fixed); });
    for (std::size_t level = 1; level <= broad.coarse.size(); ++level)
        collectCoarsePairs(state, level, keep);
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

/// How much each candidate and pair has to spare before it needs a look.
void measureSpares(State& state) {
    BroadPhase& broad = state.broad;
    const auto& x = state.particles.position;
    const auto distance = [&](std::uint32_t particle, const Collider& c) {
        const Point from = x[c.a] - x[particle], to = x[c.b] - x[particle];
        return (from + nearestAlong<Point>(Point(0, 0), from, to) * (to - from)).norm();
    };
    broad.watches.clear();
    for (const Candidate& candidate : broad.candidates) {
        const Collider& c = broad.collider(candidate.collider);
        const Real thickness = state.particles.reach[candidate.particle] + c.radius;
        // A thousandth for rounding.
        const Real needed = Real(1.001) * thickness + broad.watchedGap(thickness);
        const double spare = distance(candidate.particle, c) - static_cast<double>(needed);
        broad.watches.push_back({candidate.particle, c.a, c.b, static_cast<Real>(spare)});
    }
    broad.spareOfPair.clear();
    for (const auto pair : broad.pairs) {
        const Collider& a = broad.collider(static_cast<std::uint32_t>(pair >> 32));
        const Collider& b = broad.collider(static_cast<std::uint32_t>(pair));
        const bool cross = segmentsCross(x[a.a], x[a.b], x[b.a], x[b.b]);
        const double apart = cross ? 0
                                   : std::min({distance(a.a, b), distance(a.b, b), distance(b.a, a),
                                               distance(b.b, a)});
        broad.spareOfPair.push_back(
            static_cast<Real>(apart - static_cast<double>(a.radius + b.radius)));
    }
    broad.outing.assign(x.size(), 0);
}

/// Sleepers have none: when a body falls asleep, everything is rasterised again.
void noteOutings(State& state) {
    const Particles& p = state.particles;
    for (const Range range : state.work.awake)
        for (auto i = range.first; i < range.last; ++i)
            state.broad.outing[i] = (p.position[i] - state.broad.reference[i]).cast<Real>().norm() +
                                    p.displacement[i].norm();
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
    collectPairs(state);
    collectCandidates(state);
    measureSpares(state);
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
    noteOutings(state);
    state.statistics.broadPhases = state.broad.runs;
    state.statistics.fixedRebuilds = state.broad.fixedRuns;
    state.statistics.gridCells = coveredCells(state.broad);
    state.statistics.candidates = static_cast<std::uint32_t>(state.broad.candidates.size());
}

}  // namespace sulfur::detail
