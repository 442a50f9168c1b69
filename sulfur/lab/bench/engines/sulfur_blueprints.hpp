// Bodies of the comparison as blueprints of the library.
#pragma once

#include <sulfur/blueprint.hpp>

#include "bench/bodies.hpp"

namespace sulfur::lab::bench {

/// Sharp polygons get corners rounded by a hundredth of their shortest side, and have their outer
/// side where the plan says. A disc is one particle, which does not turn, unless it has sockets:
/// then particle 0 is its middle and particle 1 + i its socket i. A capsule has its mass in its
/// ends.
Blueprint blueprintOf(const BodyPlan& plan);

}  // namespace sulfur::lab::bench
