// How deep unit squares are in each other, and in the walls of their arena.
#pragma once

#include <sulfur/math.hpp>
#include <utility>
#include <vector>

namespace sulfur::lab::bench {

/// A square of 1 m: its centre and its angle.
using Square = std::pair<Point, double>;

/// The overlaps of all pairs that overlap, m, by the outlines that they have in their engine: their
/// corners are round, with a radius in metres from 0 to 0.5. Complexity: n log n for squares that
/// lie apart.
std::vector<double> overlaps(const std::vector<Square>& squares, double cornerRadius);

/// How far the deepest corner of any square is below y = 0 or beyond |x| = `halfWidth`, m; 0 when
/// none is.
double wallOverlap(const std::vector<Square>& squares, double halfWidth, double cornerRadius);

}  // namespace sulfur::lab::bench
