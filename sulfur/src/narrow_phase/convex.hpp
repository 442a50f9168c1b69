// Two convex outlines with round corners: up to two points where they touch.
#pragma once

#include <array>
#include <cstdint>

#include "model/movers.hpp"
#include "model/shapes.hpp"

namespace sulfur::detail {

/// A point of a manifold: a corner of one outline before a side of the other.
struct Feature {
    std::uint32_t corner = none, side = none;  // of their chunks, in the pools
    bool cornerIsB = false;
    Real gap = 0;  // m
};

/// What a look at two convex chunks finds.
struct Manifold {
    std::array<Feature, 2> features;
    int count = 0;    // of features that are near
    Real gap = 0;     // m, between the outlines; negative where they overlap
    Real margin = 0;  // m, of relative motion until other features may come near
    Real x = 0, y = 0, cosine = 1, sine = 0;  // b in the frame of a
};

/// `closing`: how far the surfaces may come towards each other in this step, m. Two that are fast
/// are looked at where they come to touch in it.
Manifold findManifold(const Movers& movers, const Shapes& shapes, const Chunk& a, const Chunk& b,
                      Real closing);

/// How a body is turned, and how when it has turned on.
Heading headingNow(const Movers& movers, std::uint32_t mover);
Heading turnedBy(const Movers& movers, std::uint32_t mover, Real angle);

}  // namespace sulfur::detail
