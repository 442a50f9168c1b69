// For processors with AVX2; compiled for nothing less.
#include "kernels/joint_sweep.hpp"

#define LANE_BYTES 32
#include "kernels/joint_sweep.ipp"

namespace sulfur::detail {

const SweepKernels avx2Sweep = {startImplicit, startRigid, sweepImplicit, sweepRigid};

}  // namespace sulfur::detail
