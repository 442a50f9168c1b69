// How deep bodies are in each other, by geometry alone: no word of the solver is asked.
#pragma once

#include <functional>
#include <sulfur/sulfur.hpp>
#include <vector>

namespace sulfur::lab {

/// The deepest overlap of two bodies, of which at least one is dynamic.
struct Overlap {
    double depth = 0;  ///< m, 0 when nothing overlaps
    double share = 0;  ///< depth over the smaller capsule radius of the two
    BodyId a = {}, b = {};
    Point place{0, 0};
};

/// Which pairs count.
using PairFilter = std::function<bool(BodyId, BodyId)>;
inline bool allPairs(BodyId, BodyId) {
    return true;
}

/// The overlap of two capsules is the sum of their radii less the distance of their axes; of two
/// whose axes cross, it is the sum of the radii plus the distance of the nearest end from the other
/// axis. An end within the outline of a dynamic body is as deep as the outline's nearest axis is
/// away, plus both radii. Pairs whose filters keep them apart do not count. The two results are
/// those of the pair with the largest share, or 0; NaN when a place is not finite.
///
/// Complexity: n log n for n capsules that lie apart.
Overlap deepestOverlap(const World& world, const PairFilter& counts = allPairs);

/// How often a closed line goes round a point, counter-clockwise. While both move it changes only
/// when the one passes over the other, whatever knots the line makes.
int windingNumber(const std::vector<Point>& line, const Point& p);

/// The overlap of two bodies.
double overlapOf(const World& world, BodyId a, BodyId b);

}  // namespace sulfur::lab
