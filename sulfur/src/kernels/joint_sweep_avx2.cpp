// For processors with AVX2; compiled for nothing less.
#include "kernels/joint_sweep.hpp"

#define SWEEP_BYTES 32
#include "kernels/joint_sweep.ipp"

namespace sulfur::detail {

const SweepKernels avx2Sweep = {sweepImplicit, sweepRigid};

}  // namespace sulfur::detail
