// How deep unit squares are in each other, exactly, and in the walls of their arena.
#pragma once

#include <sulfur/math.hpp>
#include <utility>
#include <vector>

namespace sulfur::lab::bench {

/// A square of 1 m: its centre and its angle.
using Square = std::pair<Point, double>;

/// The overlap of two squares along the separating axis on which it is least, m; below 0 when
/// they are apart.
double overlapOf(const Square& a, const Square& b);

/// The overlaps of all pairs that overlap, m. Complexity: n log n for squares that lie apart.
std::vector<double> overlaps(const std::vector<Square>& squares);

/// How far the deepest corner of any square is below y = 0 or beyond |x| = `halfWidth`, m; 0 when
/// none is.
double wallOverlap(const std::vector<Square>& squares, double halfWidth);

}  // namespace sulfur::lab::bench
