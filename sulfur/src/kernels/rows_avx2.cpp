// For processors with AVX2; compiled for nothing less.
#include "kernels/rows.hpp"

#include "kernels/rows.ipp"

namespace sulfur::detail {

const RowKernels avx2Rows = {sweepBlocks<ManifoldBlock>,
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
