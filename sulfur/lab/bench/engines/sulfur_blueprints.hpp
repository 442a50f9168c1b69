// Bodies of the comparison as blueprints of the library.
#pragma once

#include <sulfur/blueprint.hpp>

#include "bench/bodies.hpp"

namespace sulfur::lab::bench {

/// Sharp polygons get corners rounded by a hundredth of their shortest side, and have their outer
/// side where the plan says. A disc is one particle, which does not turn. What has sockets
/// is particle 0 in the middle, with the disc's radius and for a polygon without a surface, and
/// particle 1 + i at socket i. A capsule has its mass in its
/// ends.
Blueprint blueprintOf(const BodyPlan& plan);

}  // namespace sulfur::lab::bench
