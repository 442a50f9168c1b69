// Joints in batches that the kernels take as a whole.
#pragma once

#include <cstdint>
#include <vector>

#include "model/state.hpp"

namespace sulfur::detail {

/// Orders the list of explicit joints so that joints that share a particle stay in their order, and
/// with that the sums of forces the same to the last bit; and divides it into batches.
void batchExplicitJoints(State& state);
/// Gives its batches the numbers that the joints have now.
void fillExplicitBatches(State& state);

/// Divides the lists of implicit and rigid joints, which stand in the order of their colours, into
/// batches.
void batchSweptJoints(State& state);
/// Gives these the numbers that the joints have now.
void fillSweptBatches(State& state);

}  // namespace sulfur::detail
