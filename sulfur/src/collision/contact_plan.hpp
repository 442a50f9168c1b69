// What of a contact does not depend on where things are.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>

namespace sulfur::detail {

struct BroadPhase;
struct Collider;
struct State;

/// Who takes part in a contact, and the constants that they have together. What lies on something
/// touches it in the same way for many ticks: the broad phase keeps the plans of candidates that
/// have come near, so that the narrow phase asks bodies, joints and materials only once. What
/// depends on places, even whether there is a contact at all, is decided in every tick; that is why
/// no margin guards a plan, and why it changes no bit of what is found.
struct ContactPlan {
    std::uint32_t particle = 0, a = 0, b = 0;  // a == b: a disc or a corner
    std::uint32_t joint = 0;                   // the capsule's, or none for a disc
    std::uint32_t bodyA = 0, bodyB = 0;
    std::uint32_t clusterOfParticle = 0, clusterOfA = 0, clusterOfB = 0;  // or none
    Real thickness = 0;                                                   // m
    Real staticFriction = 0, kineticFriction = 0, restitution = 0;
    Real surfaceSpeed = 0;    // m/s along the tangent, of both surfaces together
    int outward = 0;          // the side of the capsule that pushes, see Outlines; 0: both
    bool rough = false;       // has friction that can hold it
    bool movesAsOne = false;  // one rigid component has all of it, so that it never touches
};

/// For a particle against a capsule, a disc, or (then a == b) the corner `a` of a capsule.
ContactPlan planContact(const State& state, std::uint32_t particle, std::uint32_t a,
                        std::uint32_t b, const Collider& collider);

/// Parts of one rigid component never move against each other. (Asked when contacts are found, not
/// where candidates are: a query may look for these before the components are up to date.)
bool moveAsOne(const State& state, std::uint32_t particle, const Collider& collider);

/// Drops the plans that are no longer true, if there are any. They are written for candidates, for
/// clusters, and for materials; who changes these sets `plansStale`.
void dropStalePlans(BroadPhase& broad);

}  // namespace sulfur::detail
