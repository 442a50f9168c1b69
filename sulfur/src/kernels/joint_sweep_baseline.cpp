// For every x86-64, and as plain code for anything else.
#include "kernels/joint_sweep.hpp"

#define LANE_BYTES 16
#include "kernels/joint_sweep.ipp"

namespace sulfur::detail {

const SweepKernels baselineSweep = {startImplicit, startRigid, sweepImplicit, sweepRigid};

}  // namespace sulfur::detail
