// Which particles might touch which capsules.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <sulfur/math.hpp>
#include <utility>
#include <vector>

#include "collision/contact.hpp"
#include "collision/contact_plan.hpp"
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

/// A candidate, and how far its sides may leave the places where they were rasterised, both
/// together, before they can make a contact.
struct Watch {
    Candidate candidate;
    std::uint32_t a = 0, b = 0;  // the collider's particles
    std::uint32_t body = 0;      // the collider's
    Real spare = 0;              // m
    Real thickness = 0;          // m, of particle and collider together
    std::uint32_t plan = none;   // of its contact, or none while it has never come near

    friend bool operator<(const Watch& p, const Watch& q) { return p.candidate < q.candidate; }
};

/// Two colliders, and how far they may leave the places where they were rasterised, both together,
/// before their axes can cross.
struct WatchedPair {
    std::uint32_t first = 0, second = 0;
    std::uint32_t one = 0, other = 0;  // their bodies
    Real spare = 0;                    // m

    friend bool operator<(const WatchedPair& p, const WatchedPair& q) {
        return p.first != q.first ? p.first < q.first : p.second < q.second;
    }
};

/// Neighbours in a list of candidates or pairs that have the bodies on both sides in common, with
/// the least spare of them: mostly one look is enough for all.
struct WatchRun {
    std::uint32_t first = 0, last = 0;  // in the list
    std::uint32_t one = 0, other = 0;   // bodies
    Real spare = 0;                     // m
};

/// What most looks at candidates need, as arrays; see Watch.
struct Looks {
    std::vector<std::uint32_t> particle, a, b;
    std::vector<Real> spare;          // m
    std::vector<Real> thickness;      // m
    std::vector<std::uint32_t> plan;  // or none

    template <class Function>
    void forEachArray(Function&& f) {
        f(particle), f(a), f(b), f(spare), f(thickness), f(plan);
    }
};

/// A collider as it was drawn, ready to be measured from.
struct Surroundings {
    Point start{0, 0}, along{0, 0};  // m, of its axis
    double scale = 0;                // 1/m^2: over its length, squared; 0 for a disc
    Real margin = 0;                 // m, round a box round that: what may make a contact with it
    Real skin = 0, leeway = 0;       // m
    std::uint32_t body = 0;
    bool meetsItself = false;  // its body
};

/// Moving colliders that hang together by their particles. When one leaves its skin, all of its
/// piece are rasterised again, and nothing else.
struct Pieces {
    std::vector<std::uint32_t> ofParticle;                // or none, where nothing collides
    std::vector<std::uint32_t> colliderStart, colliders;  // by pieces
    std::vector<std::uint32_t> particleStart, particles;  // by pieces

    std::uint32_t size() const {
        return colliderStart.empty() ? 0 : static_cast<std::uint32_t>(colliderStart.size()) - 1;
    }
};

/// How far everything is at most, or with this tick's displacement will be, from where it was
/// rasterised.
struct Outings {
    std::vector<Real> ofParticle;  // m
    std::vector<Real> ofBody;  // m, of its farthest particle; of bodies tied by capsules, of both
};

/// How many there were when something was derived from them.
struct Counts {
    std::uint32_t particles = 0, joints = 0, bodies = 0;
};

/// The grid and the candidates that came out of it. They stay valid until some collider has left
/// its skin: the margin by which it was rasterised larger than it is.
struct BroadPhase {
    std::vector<Collider> moving;  // of bodies that can move
    std::vector<Collider> fixed;   // of those that cannot; numbered after the moving ones
    std::vector<Real> fixedCover;  // m: how thick the fixed ones are drawn
    std::vector<Point> reference;  // per particle: where it was when rasterised
    std::vector<Real> step;        // m, per particle: for which it was drawn; -1: it never was
    Real baseSkin = Real(0.1);     // m, by which skins are measured
    /// Colliders that would cover too many cells of the grid, and in which coarser one each is.
    std::vector<std::uint32_t> largeMoving, largeFixed;
    std::vector<std::uint8_t> levelOfMoving, levelOfFixed;  // 0: the grid, k: coarse[k - 1]
    std::array<CoarseGrid, 4> coarse;
    Grid movingGrid;
    Grid fixedGrid;
    double cellSize = 1;             // m
    double reach = 0;                // m, the largest radius of any collider
    std::vector<Watch> watches;      // sorted by candidates, without duplicates
    std::vector<WatchedPair> pairs;  // of colliders, sorted, without duplicates; for crossings
    std::vector<WatchRun> watchRuns, pairRuns;
    bool watchRunsStale = false;             // they are listed when somebody asks for them
    Looks looks;                             // of the watches: what most looks need
    std::vector<ContactPlan> plans;          // of candidates that have come near, in no order
    std::vector<Surroundings> surroundings;  // of all colliders
    Pieces pieces;
    std::vector<std::uint32_t> left;     // pieces that have left their skins; scratch
    std::vector<std::uint8_t> hasLeft;   // the same, by pieces
    std::uint32_t drawnPieces = 0;       // those from here on have never been rasterised
    std::vector<std::uint32_t> cellsOf;  // that each moving collider covers in the grid
    std::size_t liveCells = 0;           // of these, all
    Outings outings;                     // by the predicted displacements
    std::vector<std::pair<std::uint32_t, std::uint32_t>> linked;  // (particle, body) sorted
    std::vector<std::pair<std::uint32_t, std::uint32_t>> tied;    // bodies, by joints between them
    Outlines outlines;
    Spokes spokes;
    std::vector<std::uint32_t> surface;  // per particle: the joint whose surface it shows, or none
    std::vector<Real> thinnest;          // m, per body: the least radius of its colliders
    Hollows hollows;                     // for queries, made when one needs it
    std::uint64_t runs = 0;
    std::uint64_t fixedRuns = 0;  // of rasterising fixed geometry
    Counts listed;                // of which colliders and what follows from them were listed
    bool collidersStale = true;   // bodies or joints changed
    bool onlyAdded = false;       // they did so by bodies that were added, and in no other way
    bool cellSizeStale = true;    // likewise, since the cell size was chosen
    bool fixedStale = true;
    bool pairsStale = true;
    bool plansStale = false;  // see dropStalePlans()
    /// The tick before which a query last found the grid valid.
    std::uint64_t queriedTick = ~std::uint64_t{0};

    /// With the sizes that follow from it.
    void setCellSize(double size) {
        cellSize = size;
        baseSkin = static_cast<Real>(0.1 * size);
        for (CoarseGrid& grid : coarse) grid.cellSize = size *= coarsening;
    }

    void bodyAdded() {
        onlyAdded = onlyAdded || !collidersStale;
        collidersStale = cellSizeStale = true;
    }
    void bodiesChanged() {
        onlyAdded = false;
        collidersStale = cellSizeStale = true;
    }

    /// How near things are kept as contacts although nothing predicts that they will touch: what
    /// happens to them within the sweeps may bring them together.
    Real watchedGap(Real thickness) const { return std::min(baseSkin / 4, thickness / 2); }

    const Collider& collider(std::uint32_t i) const {
        return i < moving.size() ? moving[i] : fixed[i - moving.size()];
    }
};

/// Calls f(const WatchedPair&), in their order, for all pairs of colliders that can have come to
/// cross each other.
template <class Function>
void forEachNearPair(const BroadPhase& broad, const Outings& outings, Function&& f) {
    const auto outingOf = [&](const Collider& c) {
        return std::max(outings.ofParticle[c.a], outings.ofParticle[c.b]);
    };
    for (const WatchRun& run : broad.pairRuns) {
        if (outings.ofBody[run.one] + outings.ofBody[run.other] < run.spare) continue;
        for (auto k = run.first; k < run.last; ++k) {
            const WatchedPair& pair = broad.pairs[k];
            const Collider &a = broad.collider(pair.first), &b = broad.collider(pair.second);
            if (outingOf(a) + outingOf(b) >= pair.spare) f(pair);
        }
    }
}

/// A place in units of cells. Cells are numbered by 32 bits; what is beyond shares the outermost.
inline Point inCells(const BroadPhase& broad, const Point& p) {
    const Point scaled = p / broad.cellSize;
    return scaled.cwiseMax(-1e9).cwiseMin(1e9);
}

}  // namespace sulfur::detail
