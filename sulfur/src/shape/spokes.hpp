// Which corners the capsules of each corner lead to.
#pragma once

#include <cstdint>
#include <map>

#include "model/shapes.hpp"

namespace sulfur::detail {

/// Corner::owned of what only bounds an arc, until all corners of its body are made.
inline constexpr std::uint32_t cornerOfHull = 2;

/// Gives the corners of a body their spokes. Where a particle is a corner of several chunks, the
/// first of them has the spokes, and it alone is held off others as a corner. From the ends of an
/// arc its tangents lead to its hull: `hulls`, the first of its two corners by the joint's slot.
void giveSpokes(Shapes& shapes, std::uint32_t bodySlot,
                const std::map<std::uint32_t, std::uint32_t>& hulls);

}  // namespace sulfur::detail
