// When two chunks that move along straight ways in a step come too near.
#pragma once

#include <cstdint>
#include <vector>

#include "narrow_phase/loose.hpp"
#include "shape/movers.hpp"
#include "shape/shapes.hpp"

namespace sulfur::detail {

struct State;
struct ContactCore;

/// A corner that would pass through a side, and when it is to stop.
struct Passing {
    std::uint32_t corner = 0, a = 0, b = 0;  // corners: it and the ends of the side
    Real moment = 0;                         // share of the step
};

/// Two convex chunks: the share of the step after which less than `left` of their thickness keeps
/// their axes apart, or 1. Those that are nearer already keep as much of what is left.
Real timeOfImpact(const ContactCore& core, const Chunk& a, const Chunk& b, Real left);

/// The same for corners before sides, each by itself.
void findPassings(const State& state, const Chunk& a, const Chunk& b, Real left,
                  std::vector<Passing>& passings);

}  // namespace sulfur::detail
