// For processors with AVX-512; compiled for nothing less.
#include "kernels/chain_lanes.hpp"

#define CHAIN_BYTES 64
#include "kernels/chain_lanes.ipp"

namespace sulfur::detail {

const ChainKernels avx512Chains = {stepChains};

}  // namespace sulfur::detail
