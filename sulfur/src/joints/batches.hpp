// Joints in batches that the kernels take as a whole.
#pragma once

#include <cstdint>
#include <vector>

#include "model/state.hpp"

namespace sulfur::detail {

/// Orders the list of explicit joints so that joints that share a particle stay in their order, and
/// with that the sums of forces the same to the last bit; and divides it into batches.
void batchExplicitJoints(State& state);

/// Divides a list, which stands in the order of its joints' colours, into batches.
void batchJoints(State& state, const std::vector<std::uint32_t>& list, SweptJoints& swept);

}  // namespace sulfur::detail
