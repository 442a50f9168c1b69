// Geometry of polygons whose corners are listed in either sense of rotation.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur::detail {

/// Twice the area, positive when the corners run counter-clockwise.
double twiceArea(const std::vector<Point>& corners);

/// Two edges that touch or cross without being neighbours, or the same edge twice when a corner
/// repeats its predecessor or its edges fold back; nothing when the outline is simple.
std::optional<std::array<std::size_t, 2>> tangle(const std::vector<Point>& corners);

/// The outline moved inwards by `distance` > 0, corner by corner; nothing when an edge would
/// vanish or edges would cross. `corners` are simple.
std::optional<std::vector<Point>> inset(const std::vector<Point>& corners, double distance);

/// Cuts a simple polygon into count - 2 triangles, none of them flat, by clipping ears, the
/// bluntest first. Complexity: cubic.
std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Point>& corners);

}  // namespace sulfur::detail
