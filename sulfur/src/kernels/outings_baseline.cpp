// For every processor.
#include "kernels/outings.hpp"

#define LANE_BYTES 16
#include "kernels/outings.ipp"

namespace sulfur::detail {

const OutingKernels baselineOutings = {measureMany, anyBeyondMany, findNearMany};

}  // namespace sulfur::detail
