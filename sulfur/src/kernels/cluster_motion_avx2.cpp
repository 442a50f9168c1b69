// For processors with AVX2; compiled for nothing less.
#include "kernels/cluster_motion.hpp"

#define CLUSTER_BYTES 32
#include "kernels/cluster_motion.ipp"

namespace sulfur::detail {

const ClusterKernels avx2Clusters = {turnMany, sineMany, placeMany, spreadMany};

}  // namespace sulfur::detail
