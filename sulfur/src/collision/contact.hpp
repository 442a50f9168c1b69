// What the collision stages hand to each other.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>
#include <tuple>
#include <vector>

#include "rigid/clusters.hpp"

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
    Real weightA = 0, weightB = 0;          // of the capsule's particles, adding up to 1
    Grip gripOfParticle, gripOfA, gripOfB;  // what they take hold of
    Real shareA = 0, shareB = 0;    // the weights; all in shareA when one cluster has both ends
    Vec2 normal{0, 0};              // unit, from the capsule towards the particle
    Real thickness = 0;             // m, of particle and capsule together
    Real gap = 0;                   // m at the start of the tick, negative when overlapping
    Real inverseEffectiveMass = 0;  // 1/kg along the normal
    Real tangentInverseMass = 0;    // 1/kg along the tangent
    Real friction = 0;
    Real restitution = 0;
    Real approach = 0;      // m/s at which the predicted motion closes the gap
    Real normalLambda = 0;  // kg m, accumulated in this tick
    Real tangentLambda = 0;
    Real drift = 0;  // m, along the tangent since it began to stick, up to this tick
};

/// What a contact pushed with in the last tick, with which its successor begins.
struct ContactMemory {
    std::uint32_t particle = 0, a = 0, b = 0;
    Real normalLambda = 0, tangentLambda = 0;  // kg m
    Real drift = 0;                            // m, from the place where it sticks

    template <class Archive>
    void archive(Archive& archive) {
        archive(particle);
        archive(a);
        archive(b);
        archive(normalLambda);
        archive(tangentLambda);
        archive(drift);
    }

    friend bool operator<(const ContactMemory& x, const ContactMemory& y) {
        return std::tie(x.particle, x.a, x.b) < std::tie(y.particle, y.a, y.b);
    }
};

}  // namespace sulfur::detail
