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

/// Two surfaces that would pass through each other in this step.
struct Passing {
    std::uint32_t one = 0, other = 0;  // bodies, slots
    Real moment = 0;                   // share of the step after which they are too near
    Vec2 normal{0, 0};                 // from the other to the one, at that moment
    Real depth = 0;                    // m, by which they end too near along that
};

/// Two convex chunks that end the step with less than `left` of their thickness between their axes.
/// Those that begin nearer keep as much of what is left, those that are in each other pass.
void findPassing(const ContactCore& core, const Chunk& a, const Chunk& b, Real left,
                 std::vector<Passing>& passings);

/// The same for corners before sides, each by itself.
void findPassings(const State& state, const Chunk& a, const Chunk& b, Real left,
                  std::vector<Passing>& passings);

}  // namespace sulfur::detail
