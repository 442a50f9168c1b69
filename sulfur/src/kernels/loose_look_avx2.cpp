// For processors with AVX2; compiled for nothing less.
#include "kernels/loose_look.hpp"

#define LANE_BYTES 32
#include "kernels/loose_look.ipp"

namespace sulfur::detail {

const LookKernels avx2Looks = {sides, corners};

}  // namespace sulfur::detail
