// What the collision stages hand to each other.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>
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

/// What the narrow phase may look at: particle `particle` against collider `collider`.
struct Candidate {
    std::uint32_t particle = 0;
    std::uint32_t collider = 0;

    friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

/// A particle held off a point of a capsule, or of a disc or corner (then a == b).
struct Contact {
    std::uint32_t particle = 0;
    std::uint32_t a = 0, b = 0;  // the capsule's particles
    std::uint32_t joint = 0;     // the capsule's, or none for a disc
    std::uint32_t bodyA = 0, bodyB = 0;
    Real weightA = 0, weightB = 0;          // of the capsule's particles, adding up to 1
    Grip gripOfParticle, gripOfA, gripOfB;  // what they take hold of
    Real shareA = 0, shareB = 0;    // the weights; all in shareA when one cluster has both ends
    Vec2 normal{0, 0};              // unit, from the capsule towards the particle
    Real thickness = 0;             // m, of particle and capsule together
    Real gap = 0;                   // m at the start of the tick, negative when overlapping
    Real slack = 0;                 // m of the gap in which it only stops what closes it
    Real rise = 0;                  // m, the gap at the end of a tick in which it rebounds
    Real inverseEffectiveMass = 0;  // 1/kg along the normal
    Real tangentInverseMass = 0;    // 1/kg along the tangent
    Real staticFriction = 0, kineticFriction = 0;
    Real restitution = 0;
    Real conveyed = 0;      // m, by which its surfaces run along the tangent in this tick
    Real approach = 0;      // m/s at which the predicted motion closes the gap
    Real rebound = 0;       // m/s at which it must part after the tick, 0 for none
    Real normalLambda = 0;  // kg m, accumulated in this tick
    Real tangentLambda = 0;
    Real blow = 0;            // N s, beside normalLambda, with which restitution threw it back
    Real recoveryLambda = 0;  // kg m, of the correction that becomes no velocity
    Real drift = 0;           // m, along the tangent since it began to stick, up to this tick
    bool sliding = false;     // it slid in the last tick, so that kinetic friction counts
    bool inherited = false;   // it goes on from a contact of the last tick
    bool rough = false;       // has friction that can hold it
    bool fast = false;        // its sides move far past or towards each other in this tick
};

/// What a contact was in the last tick, with which its successor begins.
struct ContactMemory {
    std::uint32_t particle = 0, a = 0, b = 0;
    Vec2 normal{0, 0};
    Real normalLambda = 0, tangentLambda = 0;  // kg m
    Real sustained = 0;                        // kg m, what the normal begins with
    Real drift = 0;                            // m, from the place where it sticks
    Real step = 0;                             // s, that of the tick or part of it
    std::uint8_t sliding = 0;                  // it does not stick

    template <class Archive>
    void archive(Archive& archive) {
        archive(particle);
        archive(a);
        archive(b);
        archive(normal);
        archive(normalLambda);
        archive(tangentLambda);
        archive(sustained);
        archive(drift);
        archive(step);
        archive(sliding);
    }
};

}  // namespace sulfur::detail
