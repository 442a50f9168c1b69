// Corners before sides, where something of either may move by itself.
#pragma once

#include <cstdint>
#include <vector>

#include "shape/movers.hpp"
#include "shape/shapes.hpp"

namespace sulfur::detail {

struct State;

/// A corner that is near a side, or (end 1 or 2) near one of its ends.
struct Nearness {
    std::uint32_t corner = none, side = none, end = 0;
    std::int32_t outward = 0;  // +1 or -1: the side of the way from a to b on which the corner is
    Real gap = 0;              // m
};

/// What a look at two chunks finds, and how far both may go until something else may come near.
struct LooseLook {
    std::vector<Nearness> near;
    Real slack = 0;  // m
};

/// Looks at all corners of both chunks; see loose.cpp.
void lookLoosely(const State& state, const Chunk& a, const Chunk& b, LooseLook& result);

}  // namespace sulfur::detail
