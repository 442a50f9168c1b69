// What is tied, or so near in the blueprint that it belongs together.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>

namespace sulfur::detail {

struct State;

/// Whether a corner never touches a side of a body (its slot) that ends in two corners (or, where
/// both are the same, a corner) and has a radius, m.
bool neverTouches(const State& state, std::uint32_t corner, std::uint32_t sideA,
                  std::uint32_t sideB, std::uint32_t body, Real radius);

}  // namespace sulfur::detail
