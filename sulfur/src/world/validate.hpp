// The invariants of a world's state.
#pragma once

#include <string>

#include "model/state.hpp"

namespace sulfur::detail {

/// Names the first broken invariant, or returns an empty string. Safe on any state that an archive
/// has read, however damaged.
std::string findBroken(const State& state);

}  // namespace sulfur::detail
