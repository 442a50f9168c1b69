// For every x86-64, and as plain code for anything else.
#include "kernels/chain_lanes.hpp"

#define CHAIN_BYTES 16
#include "kernels/chain_lanes.ipp"

namespace sulfur::detail {

const ChainKernels baselineChains = {stepChains};

}  // namespace sulfur::detail
