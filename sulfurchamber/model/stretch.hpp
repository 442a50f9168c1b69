// Blueprints of another size.
#pragma once

#include <sulfur/scene.hpp>

namespace sulfurchamber {

/// Whether its width can change without its height.
bool canStretch(const sulfur::scene::Prefab& prefab);
/// Widths and heights along its frame by factors above 0: all lengths where they are equal;
/// otherwise, which canStretch() allows, capsules stay as thick as they are where they have room.
/// Masses go with the area, those of lines that are stretched with their length.
void stretchPlan(sulfur::scene::Prefab& prefab, const sulfur::Point& factors);

}  // namespace sulfurchamber
