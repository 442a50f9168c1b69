// For every x86-64, and as plain code for anything else.
#include "kernels/cluster_motion.hpp"

#define CLUSTER_BYTES 16
#include "kernels/cluster_motion.ipp"

namespace sulfur::detail {

const ClusterKernels baselineClusters = {turnMany, sineMany, placeMany, spreadMany};

}  // namespace sulfur::detail
