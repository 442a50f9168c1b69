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
};

/// Where a corner is, from the origin of a look, and where it goes in this step.
struct CornerWay {
    Real x = 0, y = 0;        // m
    Real wayX = 0, wayY = 0;  // m
};

/// What a look at two chunks finds, and how far both may go until something else may come near.
struct LooseLook {
    std::vector<Nearness> near;
    Real slack = 0;  // m
    Real gap = 0;    // m, between what may touch, as it is
    // Scratch: the corners of both chunks.
    std::vector<CornerWay> cornersA, cornersB;
    std::vector<Nearness> before;
};

/// On which side of a two-sided capsule a corner has been so far: +1, -1, or 0 where it is new.
struct KnownSide {
    std::uint32_t corner = none, side = none;
    std::int32_t outward = 0;
};

/// Whether a corner and a side of a body (its slot) never touch: they are tied, or neighbours.
bool neverTouches(const State& state, std::uint32_t corner, const Side& side, std::uint32_t body);

/// Looks at all corners of both chunks; see loose.cpp. `known`: of corners that were near.
void lookLoosely(const State& state, const Chunk& a, const Chunk& b,
                 const std::vector<KnownSide>& known, LooseLook& result);

}  // namespace sulfur::detail
