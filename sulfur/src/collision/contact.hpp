// What the collision stages hand to each other.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur::detail {

/// A thick segment between two particles; a disc when both are the same particle.
struct Collider {
    std::uint32_t a = 0, b = 0;  // particles, dense indices
    std::uint32_t body = 0;      // dense index; the body of a for a joint between bodies
    std::uint32_t joint = 0;     // dense index, or none for a disc
    Real radius = 0;             // m

    friend bool operator==(const Collider&, const Collider&) = default;
};

/// A pair that the broad phase found: particle `particle` against collider `collider`.
struct Candidate {
    std::uint32_t particle = 0;
    std::uint32_t collider = 0;

    friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

/// A particle held off a point of a capsule.
struct Contact {
    std::uint32_t particle = 0;
    std::uint32_t a = 0, b = 0;  // the capsule's particles
    std::uint32_t bodyA = 0, bodyB = 0;
    Real weightA = 0, weightB = 0;  // of the capsule's particles, adding up to 1
    Vec2 normal{0, 0};              // unit, from the capsule towards the particle
    Real thickness = 0;             // m, of particle and capsule together
    Real gap = 0;                   // m at the start of the tick, negative when overlapping
    Real inverseEffectiveMass = 0;
    Real friction = 0;
    Real restitution = 0;
    Real approach = 0;      // m/s at which the predicted motion closes the gap
    Real normalLambda = 0;  // kg m, accumulated in this tick
    Real tangentLambda = 0;
};

}  // namespace sulfur::detail
