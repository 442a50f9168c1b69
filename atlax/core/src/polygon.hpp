#pragma once

#include <array>
#include <atlax/vec.hpp>
#include <cstdint>
#include <span>
#include <vector>

namespace atlax::detail {

/// Twice the signed area, positive when counter-clockwise with y up.
float doubleArea(std::span<const Vec2> points);

/// Removes points that repeat their predecessor (the first follows the last) or are not finite.
void removeRepeats(std::vector<Vec2>& points);

/// Cuts a simple polygon of counter-clockwise points into triangles: a fan when it is convex, else
/// by clipping ears (O(n^2) in the usual case). Always n - 2 triangles, whatever the points are.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec2> points);

}  // namespace atlax::detail
