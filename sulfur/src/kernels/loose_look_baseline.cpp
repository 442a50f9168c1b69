// For every x86-64, and as plain code for anything else.
#include "kernels/loose_look.hpp"

#define LANE_BYTES 16
#include "kernels/loose_look.ipp"

namespace sulfur::detail {

const LookKernels baselineLooks = {sides, corners};

}  // namespace sulfur::detail
