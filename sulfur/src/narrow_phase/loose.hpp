// Corners before sides, where something of either may move by itself.
#pragma once

#include <cstdint>
#include <vector>

#include "model/look_results.hpp"
#include "model/shapes.hpp"

namespace sulfur::detail {

struct State;

/// Whether a corner and a side of a body (its slot) never touch: they are tied, or neighbours.
bool neverTouches(const State& state, std::uint32_t corner, const Side& side, std::uint32_t body);

/// Looks at all corners of both chunks; see loose.cpp. `known`: of corners that were near.
void lookLoosely(const State& state, const Chunk& a, const Chunk& b,
                 const std::vector<KnownSide>& known, LooseLook& result);

}  // namespace sulfur::detail
