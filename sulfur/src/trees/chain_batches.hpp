// Chains of rigid links that go through the tick side by side, in SIMD lanes.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "model/state.hpp"

namespace sulfur::detail {

/// Finds the batches among WorkLists::lonelyTrees.
void listChainBatches(State& state);

/// Leads the chains of all batches through the tick. Those that need more steps than they had
/// before have not moved; their trees are added to `left`.
void stepChainBatches(State& state, std::pmr::vector<std::uint32_t>& left);

}  // namespace sulfur::detail
