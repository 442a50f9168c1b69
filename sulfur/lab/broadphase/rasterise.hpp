// Which cells of the grid a thick segment covers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sulfur/math.hpp>

#include "broadphase/grid.hpp"

namespace sulfur::detail {

/// Calls emit(Cell) once for each cell of a cover of the capsule from `from` to `to` (in units of
/// cells, up to 2^51 either way) with radius `radius` (likewise). No cell that the capsule touches
/// is left out, so that two capsules that touch always share a cell: the one that holds the point
/// where they touch.
///
/// It is Bresenham's line, widened. As he does, it walks the major axis, along which the line is
/// longer, column by column, with the slope |m| <= 1 of the minor coordinate; but it emits all of
/// a column that the capsule can reach, not the one cell that is nearest to the line. A point q of
/// the capsule is at most r away from the line, measured across it. Measured along the minor axis
/// that is at most r sqrt(1 + m^2), and in the column [c, c+1] the line itself runs from
/// y(c) to y(c+1) = y(c) + m. Also, q is at most r beyond the ends. So in this column
///
///     min(y(c), y(c+1)) - r sqrt(1 + m^2)  <=  y(q)  <=  max(y(c), y(c+1)) + r sqrt(1 + m^2)
///     min(y(from), y(to)) - r              <=  y(q)  <=  max(y(from), y(to)) + r
///
/// and the columns are those from floor(x(from) - r) to floor(x(to) + r). The rows that are
/// emitted are exactly those of both intervals: 1 + |m| + 2 r sqrt(1 + m^2) of them and at most
/// one more in a column, where the capsule itself is 2 r sqrt(1 + m^2) high.
///
/// The computation rounds: y(c) to within 4 epsilon of the coordinates, the rest to less. A radius
/// that is larger by 8 epsilon of them covers that, so that the claim holds to the last bit.
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
    const double farthest = from.cwiseAbs().cwiseMax(to.cwiseAbs()).maxCoeff() + radius;
    radius += 8 * std::numeric_limits<double>::epsilon() * farthest;
    const double slope = along[major] > 0 ? along[minor] / along[major] : 0.0;
    const double reach = radius * std::sqrt(1 + slope * slope);
    const double lowest = std::min(from[minor], to[minor]) - radius;
    const double highest = std::max(from[minor], to[minor]) + radius;
    const auto first = static_cast<std::int64_t>(std::floor(from[major] - radius));
    const auto last = static_cast<std::int64_t>(std::floor(to[major] + radius));
    for (std::int64_t column = first; column <= last; ++column) {
        const double enter = from[minor] + slope * (static_cast<double>(column) - from[major]);
        const double leave = enter + slope;
        const double low = std::max(std::min(enter, leave) - reach, lowest);
        const double high = std::min(std::max(enter, leave) + reach, highest);
        const auto bottom = static_cast<std::int64_t>(std::floor(low));
        const auto top = static_cast<std::int64_t>(std::floor(high));
        for (std::int64_t row = bottom; row <= top; ++row)
            emit(steep ? cellAt(row, column) : cellAt(column, row));
    }
}

/// Calls emit(Cell) for each step of the line between the cells of both ends: Bresenham's line
/// (1965) as he gave it, one cell in a column and no thickness, which is what section 3.3 of the
/// paper uses. It misses pairs that touch; see Rasterisation::bresenham.
template <class Emit>
void rasteriseLine(const Point& from, const Point& to, Emit&& emit) {
    auto x = static_cast<std::int64_t>(std::floor(from[0]));
    auto y = static_cast<std::int64_t>(std::floor(from[1]));
    const auto lastX = static_cast<std::int64_t>(std::floor(to[0]));
    const auto lastY = static_cast<std::int64_t>(std::floor(to[1]));
    const std::int64_t width = std::abs(lastX - x), height = std::abs(lastY - y);
    const int stepX = x < lastX ? 1 : -1, stepY = y < lastY ? 1 : -1;
    std::int64_t error = width - height;
    emit(cellAt(x, y));
    while (x != lastX || y != lastY) {
        const std::int64_t twice = 2 * error;
        if (twice >= -height) {
            error -= height;
            x += stepX;
        }
        if (twice <= width) {
            error += width;
            y += stepY;
        }
        emit(cellAt(x, y));
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
