// For processors with AVX2; compiled for nothing less.
#include "kernels/area_look.hpp"

#define LANE_BYTES 32
#include "kernels/area_look.ipp"

namespace sulfur::detail {

const AreaKernels avx2Areas = {look};

}  // namespace sulfur::detail
