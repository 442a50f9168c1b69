// For every processor.
#include "kernels/rows.hpp"

#include "kernels/rows.ipp"

namespace sulfur::detail {

const RowKernels baselineRows = {sweepBlocks<ManifoldBlock>,
                                 sweepBlocks<TouchBlock>,
                                 {refreshManifold<false>, refreshManifold<true>},
                                 {refreshTouch<false>, refreshTouch<true>},
                                 giveManifold,
                                 giveTouch,
                                 meetingManifold,
                                 meetingTouch,
                                 pressingManifold,
                                 pressingTouch};

}  // namespace sulfur::detail
