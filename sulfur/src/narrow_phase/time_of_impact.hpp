// When two chunks that move along straight ways in a step come too near.
#pragma once

#include <cstdint>
#include <vector>

#include "model/contact_core.hpp"

namespace sulfur::detail {

struct State;

/// Two convex chunks that end the step with less than `left` of their thickness between their axes.
/// Those that begin nearer come no nearer; those whose axes are in each other pass.
void findPassing(const ContactCore& core, const Chunk& a, const Chunk& b, Real left,
                 std::vector<Passing>& passings);

/// The same for corners before sides, each by itself.
void findPassings(const State& state, const Chunk& a, const Chunk& b, Real left,
                  std::vector<Passing>& passings);

}  // namespace sulfur::detail
