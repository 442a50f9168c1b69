// Areas with holes: what outlines of a body enclose, and how they fall into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfurchamber {

/// Three corners by their places in a list of points.
using CornerTriple = std::array<std::uint32_t, 3>;

/// Loops as places in a list of points: one around, and those of its holes.
struct LoopRegion {
    std::vector<std::uint32_t> outer;
    std::vector<std::vector<std::uint32_t>> holes;
};

/// Which loops are holes of which: one that lies inside of another is its hole, one in a hole is a
/// region of its own. Complexity: quadratic in the loops.
std::vector<LoopRegion> regionsOfLoops(const std::vector<std::vector<std::uint32_t>>& loops,
                              const std::vector<sulfur::Point>& points);

/// The region as one loop, anticlockwise, with bridges there and back to its holes: their ends come
/// twice. Empty where loops touch.
std::vector<std::uint32_t> oneLoop(const LoopRegion& region, const std::vector<sulfur::Point>& points);

/// Triangles that fill a region, between its corners alone (ears of an outline that bridges lead
/// to the holes of; Eberly 1998). Empty where loops touch. Complexity: cubic in the corners.
std::vector<CornerTriple> trianglesOf(const LoopRegion& region,
                                      const std::vector<sulfur::Point>& points);

/// Square metres of a region.
double areaOf(const LoopRegion& region, const std::vector<sulfur::Point>& points);

}  // namespace sulfurchamber
