// For every processor.
#include "kernels/rows.hpp"

#include "kernels/rows.ipp"

namespace sulfur::detail {

const RowKernels baselineRows = {sweepManifolds,  sweepTouches, refreshManifold,  refreshTouch,
                                 meetingManifold, meetingTouch, pressingManifold, pressingTouch};

}  // namespace sulfur::detail
