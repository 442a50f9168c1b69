// Areas with holes: what a drawing or a picture encloses.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice.hpp"

namespace sulfurchamber {

inline constexpr double outlineMassPerArea = 4;  ///< kg/m^2 of what is drawn, as of boxes

/// One piece of area: inside of its outer outline and outside of its holes, all in metres. The
/// outer one runs anticlockwise, holes clockwise: the area is to the left of each edge.
struct Region {
    Outline outer;
    std::vector<Outline> holes = {};
};

enum class FillRule : std::uint8_t { nonzero, evenOdd };

/// The regions that closed outlines, which may lie in each other but do not cross, enclose by a
/// rule. Outlines inside of an area, and those of less than three points, count for nothing.
/// Complexity: quadratic in the outlines, each time linear in their points.
std::vector<Region> regionsOf(const std::vector<Outline>& outlines, FillRule rule);

/// Area, its centre, and the second moment about that, of a region of 1 kg/m^2.
struct AreaMoments {
    double area = 0;             ///< m^2
    sulfur::Point centre{0, 0};  ///< m
    double polar = 0;            ///< m^4
};
AreaMoments momentsOf(const Region& region);

/// Whether outlines of a region cross or touch themselves or each other.
bool tangled(const Region& region);
/// Fewer points, none of which is missed by more than `error` metres.
Region simplified(const Region& region, double error);
/// The same area as one outline: a slit of this width, metres, leads to each hole, because a body
/// is what its outline goes round. Throws std::runtime_error when a hole cannot be reached.
Outline keyholed(const Region& region, double width);

}  // namespace sulfurchamber
