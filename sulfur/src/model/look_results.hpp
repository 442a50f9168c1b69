// What looks at two chunks find.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "core/slots.hpp"
#include "kernels/loose_look.hpp"

namespace sulfur::detail {

/// A corner that is near a side, or (end 1 or 2) near one of its ends.
struct Nearness {
    std::uint32_t corner = none, side = none, end = 0;
    std::int32_t outward = 0;  // +1 or -1: the side of the way from a to b on which the corner is
    Real far = 0;              // m, from its line or end when the step begins
};

/// A chunk as a look sees it: its corners, the ends of their capsules, and its sides.
struct ChunkLanes {
    SpokedCorners corners;
    std::vector<CornerLanes> spokes;
    SideLanes sides;
    std::uint32_t owned = 0;     // bits of corners that are held off others
    std::uint32_t discs = 0;     // bits of sides that are a disc, and no side
    std::uint32_t arcs = 0;      // bits of sides that are bent
    std::uint32_t twoSided = 0;  // bits of sides that push both ways
};

/// What a look at two chunks finds, and how far both may go until something else may come near.
struct LooseLook {
    std::vector<Nearness> near;
    Real slack = 0;  // m
    Real gap = 0;    // m, between what may touch, as it is
    // Scratch: both chunks, and what one corner sees.
    ChunkLanes a, b;
    SidesSeen sidesSeen;
    CornersSeen cornersSeen;
};

/// On which side of a two-sided capsule a corner has been so far: +1, -1, or 0 where it is new.
struct KnownSide {
    std::uint32_t corner = none, side = none;
    std::int32_t outward = 0;
};

/// A corner and a side that would pass through each other in this step, or two outlines.
struct Passing {
    std::uint32_t one = 0;                  // mover of the corner
    std::array<std::uint32_t, 2> others{};  // movers of the side's ends
    Real share = 0;                         // of the way from the first of them to the second
    Real moment = 0;                        // share of the step after which they are too near
    Vec2 normal{0, 0};                      // from the others to the one, at that moment
    Real depth = 0;                         // m, by which they end too near along that
    Real gap = 0;                           // m, between the surfaces when the step begins
    Point at{0, 0};                         // m, on the surface of the one, when they meet
};

}  // namespace sulfur::detail
