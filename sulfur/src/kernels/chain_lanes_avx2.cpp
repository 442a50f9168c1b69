// For processors with AVX2; compiled for nothing less.
#include "kernels/chain_lanes.hpp"

#define CHAIN_BYTES 32
#include "kernels/chain_lanes.ipp"

namespace sulfur::detail {

const ChainKernels avx2Chains = {stepChains};

}  // namespace sulfur::detail
