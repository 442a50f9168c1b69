// Which cells of the grid a thick segment covers.
#pragma once

#include <algorithm>
#include <cmath>
#include <sulfur/math.hpp>

#include "collision/grid.hpp"

namespace sulfur::detail {

/// Calls emit(Cell) once for each cell of a cover of the capsule from `from` to `to` (in units of
/// cells) with radius `radius` (likewise). No cell that the capsule touches is left out.
///
/// Bresenham's line, widened: it walks the major axis cell by cell and keeps the minor coordinate
/// of the line incrementally, as Bresenham does, but emits every cell of the column that the
/// thick line can reach. Within the column [c, c+1] the centre line's minor coordinate runs over
/// an interval of width |slope| <= 1, and the capsule reaches radius * sqrt(1 + slope^2) further on
/// each side (the vertical extent of a strip of half width radius). Plain Bresenham emits one cell
/// a column and so misses what the line's thickness and its rounding leave out.
template <class Emit>
void rasteriseCapsule(Point from, Point to, double radius, Emit&& emit) {
    Point along = to - from;
    const bool steep = std::abs(along[1]) > std::abs(along[0]);
    const int major = steep ? 1 : 0;
    const int minor = 1 - major;
    if (along[major] < 0) {
        std::swap(from, to);
        along = -along;
    }
    const double slope = along[major] > 0 ? along[minor] / along[major] : 0.0;
    const double reach = radius * std::sqrt(1 + slope * slope);
    const double lowest = std::min(from[minor], to[minor]) - radius;
    const double highest = std::max(from[minor], to[minor]) + radius;
    const auto first = static_cast<std::int32_t>(std::floor(from[major] - radius));
    const auto last = static_cast<std::int32_t>(std::floor(to[major] + radius));
    for (std::int32_t column = first; column <= last; ++column) {
        const double enter = from[minor] + slope * (column - from[major]);
        const double leave = enter + slope;
        const double low = std::max(std::min(enter, leave) - reach, lowest);
        const double high = std::min(std::max(enter, leave) + reach, highest);
        const auto bottom = static_cast<std::int32_t>(std::floor(low));
        const auto top = static_cast<std::int32_t>(std::floor(high));
        for (std::int32_t row = bottom; row <= top; ++row)
            emit(steep ? Cell{row, column} : Cell{column, row});
    }
}

/// An upper bound of the number of cells that rasteriseCapsule emits; may exceed any integer.
inline double cellsCovered(const Point& from, const Point& to, double radius) {
    const Point along = (to - from).cwiseAbs();
    const double columns = along.maxCoeff() + 2 * radius + 2;
    const double rows = 1 + 2 * radius * 1.4143 + 2;
    return columns * rows;
}

}  // namespace sulfur::detail
