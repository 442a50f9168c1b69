// For every x86-64, and as plain code for anything else.
#include "kernels/particle_motion.hpp"

#define MOTION_BYTES 16
#include "kernels/particle_motion.ipp"

namespace sulfur::detail {

const MotionKernels baselineMotion = {predictMany, takeUpMany, moveMany};

}  // namespace sulfur::detail
