// Which cells of a grid a collider covers.
#pragma once

#include <algorithm>

#include "collision/rasterise.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

inline double cellSizeOf(const BroadPhase& broad, std::size_t level) {
    return level == 0 ? broad.cellSize : broad.coarse[level - 1].cellSize;
}

/// Places beyond 2^51 cells are further away than any that a caller may give.
inline Point inCells(const Point& p, double cellSize) {
    return (p / cellSize).cwiseMax(-2e15).cwiseMin(2e15);
}

/// How thick a collider is drawn, in m: as its ends, where a joint to another body makes them
/// thicker than what is their own. (That joint is a part of one of the bodies only, and does not
/// meet what the other one may.)
inline Real coverRadius(const State& state, const Collider& collider) {
    Real radius = collider.radius;
    for (const auto p : {collider.a, collider.b}) {
        const auto joint = state.broad.surface[p];
        if (joint != none && state.joints.body[joint] == none)
            radius = std::max(radius, state.particles.reach[p]);
    }
    return radius;
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
        rasteriseCapsule(from, to, static_cast<double>(coverRadius(state, collider) + skin) / size,
                         emit);
}

}  // namespace sulfur::detail
