// For processors with AVX2; compiled for nothing less.
#include "kernels/meeting_lanes.hpp"

#define SWEEP_BYTES 32
#include "kernels/meeting_lanes.ipp"

namespace sulfur::detail {

const MeetingKernels avx2Meetings = {gatherAll, meetAll};

}  // namespace sulfur::detail
