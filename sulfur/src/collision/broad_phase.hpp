// Which particles might touch which capsules.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <sulfur/math.hpp>
#include <utility>
#include <vector>

#include "collision/contact.hpp"
#include "collision/grid.hpp"
#include "collision/hollows.hpp"
#include "collision/outlines.hpp"
#include "collision/spokes.hpp"

namespace sulfur::detail {

/// A grid for colliders that would cover too many cells of the finer ones.
struct CoarseGrid {
    Grid moving, fixed;
    double cellSize = 1;  // m
};

/// How much larger the cells of each coarser grid are. What is just too large for a grid covers a
/// few tens of cells of the next.
inline constexpr double coarsening = 64;

/// How far the sides of a candidate were apart when they were rasterised, beyond where a contact
/// is made.
struct Watch {
    std::uint32_t particle = 0, a = 0, b = 0;
    Real spare = 0;  // m
};

/// The grid and the candidates that came out of it. They stay valid until some collider has left
/// its skin: the margin by which it was rasterised larger than it is.
struct BroadPhase {
    std::vector<Collider> moving;  // of bodies that can move
    std::vector<Collider> fixed;   // of those that cannot; numbered after the moving ones
    std::vector<Point> reference;  // per particle: where it was when rasterised
    std::vector<Real> skin;        // m, per particle
    Real baseSkin = Real(0.1);     // m
    /// Colliders that would cover too many cells of the grid, and in which coarser one each is.
    std::vector<std::uint32_t> largeMoving, largeFixed;
    std::vector<std::uint8_t> levelOfMoving, levelOfFixed;  // 0: the grid, k: coarse[k - 1]
    std::array<CoarseGrid, 4> coarse;
    Grid movingGrid;
    Grid fixedGrid;
    double cellSize = 1;                // m
    double reach = 0;                   // m, the largest radius of any collider
    std::vector<Candidate> candidates;  // sorted, without duplicates
    std::vector<std::uint64_t> pairs;   // of colliders, sorted; scratch and for crossings
    std::vector<Watch> watches;         // of each candidate
    std::vector<Real> spareOfPair;      // m, how far the two may come towards each other to cross
    /// How far each particle is, or with this tick's displacement will be, from where it was then,
    /// at most.
    std::vector<Real> outing;                                     // m
    std::vector<std::pair<std::uint32_t, std::uint32_t>> linked;  // (particle, body) sorted
    Outlines outlines;
    Spokes spokes;
    std::vector<std::uint32_t> surface;  // per particle: the joint whose surface it shows, or none
    Hollows hollows;                     // for queries, made when one needs it
    std::uint64_t runs = 0;
    std::uint64_t fixedRuns = 0;  // of rasterising fixed geometry
    bool collidersStale = true;   // bodies or joints changed
    bool cellSizeStale = true;    // likewise, since the cell size was chosen
    bool fixedStale = true;
    bool pairsStale = true;
    /// The tick before which a query last found the grid valid.
    std::uint64_t queriedTick = ~std::uint64_t{0};

    /// How near things are kept as contacts although nothing predicts that they will touch: what
    /// happens to them within the sweeps may bring them together.
    Real watchedGap(Real thickness) const { return std::min(baseSkin / 4, thickness / 2); }

    const Collider& collider(std::uint32_t i) const {
        return i < moving.size() ? moving[i] : fixed[i - moving.size()];
    }
};

/// Whether the two sides cannot have come near enough to each other. What moves by more than its
/// thickness is stopped up to half of that before it touches: hence twice.
inline bool staysApart(const std::vector<Real>& outing, const Watch& w) {
    return 2 * (outing[w.particle] + std::max(outing[w.a], outing[w.b])) < w.spare;
}

/// A place in units of cells. Cells are numbered by 32 bits; what is beyond shares the outermost.
inline Point inCells(const BroadPhase& broad, const Point& p) {
    const Point scaled = p / broad.cellSize;
    return scaled.cwiseMax(-1e9).cwiseMin(1e9);
}

}  // namespace sulfur::detail
