// For every x86-64, and as plain code for anything else.
#include "kernels/joint_force.hpp"

#define LANE_BYTES 16
#include "kernels/joint_force.ipp"

namespace sulfur::detail {

const ForceKernels baselineForces = {addForces<false>, addForces<true>};

}  // namespace sulfur::detail
