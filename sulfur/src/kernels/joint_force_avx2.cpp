// For processors with AVX2; compiled for nothing less.
#include "kernels/joint_force.hpp"

#define LANE_BYTES 32
#include "kernels/joint_force.ipp"

namespace sulfur::detail {

const ForceKernels avx2Forces = {addForces<false>, addForces<true>};

}  // namespace sulfur::detail
