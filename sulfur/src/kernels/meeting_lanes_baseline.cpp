// For every processor.
#include "kernels/meeting_lanes.hpp"

#define SWEEP_BYTES 16
#include "kernels/meeting_lanes.ipp"

namespace sulfur::detail {

const MeetingKernels baselineMeetings = {gatherAll, meetAll};

}  // namespace sulfur::detail
