// For every processor.
#include "kernels/rows.hpp"

#include "kernels/rows.ipp"

namespace sulfur::detail {

const RowKernels baselineRows = {sweepManifolds,   pushManifolds,    sweepTouches,
                             pushTouches,      refreshManifold,  refreshTouch,
                             pressingManifold, pressingTouch};

}  // namespace sulfur::detail
