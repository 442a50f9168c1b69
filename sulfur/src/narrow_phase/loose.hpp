// Corners before sides, where something of either may move by itself.
#pragma once

#include <cstdint>
#include <vector>

#include "model/look_results.hpp"
#include "model/shapes.hpp"

namespace sulfur::detail {

struct State;

/// Looks at all corners of both chunks; see loose.cpp. `known`: of corners that were near.
void lookLoosely(const State& state, const Chunk& a, const Chunk& b,
                 const std::vector<KnownSide>& known, LooseLook& result);

}  // namespace sulfur::detail
