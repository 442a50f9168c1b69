// Where the particles of a placed body are.
#pragma once

#include <sulfur/scene/scene.hpp>
#include <vector>

namespace sulfur::scene {

/// The particles of a blueprint at a pose, in the world.
std::vector<Point> placed(const Blueprint& blueprint, const Pose& pose);

/// Puts the particles of a body where the state of its placement says. Throws ReadError when that
/// has another number of them.
void applyState(const Scene& scene, const Placement& placement, World& world, BodyId body);

}  // namespace sulfur::scene
