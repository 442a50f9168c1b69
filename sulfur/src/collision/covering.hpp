// Which cells of a grid a collider covers.
#pragma once

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

}  // namespace sulfur::detail
