// For every x86-64, and as plain code for anything else.
#include "kernels/area_look.hpp"

#define LANE_BYTES 16
#include "kernels/area_look.ipp"

namespace sulfur::detail {

const AreaKernels baselineAreas = {look};

}  // namespace sulfur::detail
