// For processors with AVX2; compiled for nothing less.
#include "kernels/rows.hpp"

#include "kernels/rows.ipp"

namespace sulfur::detail {

const RowKernels avx2Rows = {sweepManifolds,  sweepTouches, refreshManifold,  refreshTouch,
                             meetingManifold, meetingTouch, pressingManifold, pressingTouch};

}  // namespace sulfur::detail
