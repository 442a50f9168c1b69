// Closed outlines of bodies: found in their blueprints, grown by their thickness.
#pragma once

#include <atlax/vec.hpp>
#include <sulfur/blueprint.hpp>
#include <vector>

namespace quaoar {

/// Indices of particles around a body: the loop made by its capsule joints, counter-clockwise.
/// Empty when the capsules do not form exactly one loop.
std::vector<std::uint32_t> outlineOf(const sulfur::Blueprint& blueprint);

/// Outward normals of unit length at the corners of a counter-clockwise loop.
std::vector<atlax::Vec2> cornerNormals(const std::vector<atlax::Vec2>& loop);

/// The loop moved outward along its corners by `distance` (inward when negative); at sharp corners
/// at most twice as far.
std::vector<atlax::Vec2> grown(const std::vector<atlax::Vec2>& loop, float distance);

}  // namespace quaoar
