// For processors with AVX2; compiled for nothing less.
#include "kernels/outings.hpp"

#define LANE_BYTES 32
#include "kernels/outings.ipp"

namespace sulfur::detail {

const OutingKernels avx2Outings = {measureMany, anyBeyondMany, findNearMany};

}  // namespace sulfur::detail
