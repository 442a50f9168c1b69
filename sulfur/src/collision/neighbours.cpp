#include "collision/neighbours.hpp"

#include "collision/covering.hpp"
#include "collision/skins.hpp"
#include "core/bucket_sort.hpp"

namespace sulfur::detail {

namespace {

/// The thickest part of a collider: of its ends, where other capsules end too.
Real reachOf(const State& state, const Collider& c) {
    return std::max({c.radius, state.particles.reach[c.a], state.particles.reach[c.b]});
}

/// Writes down a pair that shares a cell, if it is near enough.
struct Keep {
    void operator()(std::uint32_t i, std::uint32_t j) {
        if (areNear(broad.surroundings[i], broad.surroundings[j])) found.emplace_back(i, j);
    }
    const BroadPhase& broad;
    std::vector<Found>& found;
};

/// What finer colliders share cells of a coarse grid with. Each is rasterised there too, which for
/// most gives a cell or two.
void collectCoarsePairs(const State& state, std::size_t level, Keep& keep) {
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
        rasterise(state, broad.fixed[i], skinOf(broad, Real(-1)), level, [&](Cell cell) {
            grid.moving.forEachIn(cell, [&](std::uint32_t large) { keep(large, offset + i); });
        });
    }
}

}  // namespace

Surroundings surroundingsOf(const State& state, const Collider& c) {
    const BroadPhase& broad = state.broad;
    const auto& x = broad.reference;
    const Point &a = x[c.a], along = x[c.b] - a;
    const double length2 = along.squaredNorm();
    Surroundings s{a, along, length2 > 0 ? 1 / length2 : 0};
    const Real step = stepOf(broad, c);
    s.leeway = step < 0 ? 0 : leewayFor(broad, step);
    s.skin = skinOf(broad, c);
    s.margin = Real(1.001) * reachOf(state, c) + s.skin + static_cast<Real>(rounding);
    s.body = c.body;
    s.meetsItself = state.bodies[c.body].selfCollision;
    return s;
}

void FoundList::sort(std::size_t colliders) {
    bucketSort(pairs, scratch, start, colliders, [](const Found& pair) { return pair.first(); });
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

void collectCoarsePairs(const State& state, FoundList& list) {
    const BroadPhase& broad = state.broad;
    list.pairs.clear();
    Keep keep{broad, list.pairs};
    for (std::size_t level = 1; level <= broad.coarse.size(); ++level)
        collectCoarsePairs(state, level, keep);
    if (!list.pairs.empty()) list.sort(broad.moving.size());
}

void collectPairsOfLeft(const State& state, Neighbours& scratch, FoundList& list) {
    const BroadPhase& broad = state.broad;
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    list.pairs.clear();
    scratch.begin(broad.surroundings.size());
    const auto look = [&](const Collider& c, const Grid& moving, const Grid& fixed,
                          std::size_t level) {
        if (moving.entries().empty() && fixed.entries().empty()) return;
        rasterise(state, c, skinOf(broad, c), level, [&](Cell cell) {
            moving.forEachIn(cell, [&](std::uint32_t j) { scratch.see(broad, j); });
            fixed.forEachIn(cell, [&](std::uint32_t j) { scratch.see(broad, offset + j); });
        });
    };
    const Pieces& pieces = broad.pieces;
    for (const auto piece : broad.left)
        for (auto k = pieces.colliderStart[piece]; k < pieces.colliderStart[piece + 1]; ++k) {
            const auto i = pieces.colliders[k];
            scratch.beginOf(i);
            look(broad.moving[i], broad.movingGrid, broad.fixedGrid, 0);
            for (std::size_t level = 1; level <= broad.coarse.size(); ++level)
                look(broad.moving[i], broad.coarse[level - 1].moving, broad.coarse[level - 1].fixed,
                     level);
            for (const auto j : scratch.unsorted()) list.pairs.emplace_back(i, j);
        }
    list.sort(broad.moving.size());
}

void findEntries(const BroadPhase& broad, std::vector<std::uint32_t>& start) {
    start.resize(broad.moving.size() + 1);
    std::uint32_t entries = 0;
    for (std::size_t i = 0; i < broad.moving.size(); ++i) {
        start[i] = entries;
        if (broad.levelOfMoving[i] == 0) entries += broad.cellsOf[i];
    }
    start.back() = entries;
}

}  // namespace sulfur::detail
