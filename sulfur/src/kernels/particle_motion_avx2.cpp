// For processors with AVX2; compiled for nothing less.
#include "kernels/particle_motion.hpp"

#define MOTION_BYTES 32
#include "kernels/particle_motion.ipp"

namespace sulfur::detail {

const MotionKernels avx2Motion = {predictMany, takeUpMany, moveMany};

}  // namespace sulfur::detail
