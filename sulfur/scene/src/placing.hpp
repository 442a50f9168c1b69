// Where the particles of a placed body are.
#pragma once

#include <sulfur/scene/scene.hpp>
#include <vector>

namespace sulfur::scene {

/// The particles of a blueprint at a pose, in the world.
std::vector<Point> placed(const Blueprint& blueprint, const Pose& pose);

}  // namespace sulfur::scene
