// For processors with AVX2: the only file of the library that is compiled for them.
#include "kernels/joint_sweep.hpp"

#define SWEEP_BYTES 32
#include "kernels/joint_sweep.ipp"

namespace sulfur::detail {

const SweepKernels avx2Sweep = {sweepImplicit, sweepRigid};

}  // namespace sulfur::detail
