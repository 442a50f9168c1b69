#include "bench/squares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace sulfur::lab::bench {

namespace {

/// The distance from the centre to a corner.
constexpr double reach = std::numbers::sqrt2 / 2;

std::array<Point, 2> axesOf(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {Point(c, s), Point(-s, c)};
}

}  // namespace

double overlapOf(const Square& a, const Square& b) {
    const auto axesA = axesOf(a.second), axesB = axesOf(b.second);
    const Point apart = b.first - a.first;
    // Half the extent of a square along a direction that makes a known angle with its sides.
    const double turned = std::abs(axesA[0].dot(axesB[0])) + std::abs(axesA[0].dot(axesB[1]));
    const double extents = 0.5 + 0.5 * turned;
    double least = std::numeric_limits<double>::max();
    for (const auto& axes : {axesA, axesB})
        for (const Point& axis : axes) least = std::min(least, extents - std::abs(apart.dot(axis)));
    return least;
}

std::vector<double> overlaps(const std::vector<Square>& squares) {
    std::vector<Square> sorted = squares;
    std::sort(sorted.begin(), sorted.end(),
              [](const Square& a, const Square& b) { return a.first.x() < b.first.x(); });
    std::vector<double> depths;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        for (std::size_t j = i + 1; j < sorted.size(); ++j) {
            if (sorted[j].first.x() - sorted[i].first.x() > 2 * reach) break;
            if (std::abs(sorted[j].first.y() - sorted[i].first.y()) > 2 * reach) continue;
            const double depth = overlapOf(sorted[i], sorted[j]);
            if (depth > 0) depths.push_back(depth);
        }
    }
    return depths;
}

double wallOverlap(const std::vector<Square>& squares, double halfWidth) {
    double deepest = 0;
    for (const Square& square : squares) {
        const auto axes = axesOf(square.second);
        const double half = 0.5 * (std::abs(axes[0].x()) + std::abs(axes[0].y()));
        deepest = std::max(
            {deepest, half - square.first.y(), std::abs(square.first.x()) + half - halfWidth});
    }
    return deepest;
}

}  // namespace sulfur::lab::bench
