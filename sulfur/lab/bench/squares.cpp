#include "bench/squares.hpp"

#include <algorithm>
#include <cmath>

#include "bench/bodies.hpp"

namespace sulfur::lab::bench {

std::vector<double> overlaps(const std::vector<Square>& squares, double cornerRadius) {
    const double half = 0.5 - cornerRadius;
    const Outline outline = rectangle(Point(half, half), cornerRadius);
    std::vector<Piece> pieces;
    for (const Square& square : squares)
        pieces.push_back(
            {placed(outline, {.place = square.first, .angle = square.second}), pieces.size()});
    return overlaps(pieces);
}

double wallOverlap(const std::vector<Square>& squares, double halfWidth, double cornerRadius) {
    double deepest = 0;
    for (const Square& square : squares) {
        const double c = std::abs(std::cos(square.second)), s = std::abs(std::sin(square.second));
        const double half = (0.5 - cornerRadius) * (c + s) + cornerRadius;
        deepest = std::max(
            {deepest, half - square.first.y(), std::abs(square.first.x()) + half - halfWidth});
    }
    return deepest;
}

}  // namespace sulfur::lab::bench
