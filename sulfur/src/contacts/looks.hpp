// Looking at a pair: which corners are near which sides, and what follows for its rows.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/math.hpp>

#include "model/contact_core.hpp"
#include "narrow_phase/convex.hpp"

namespace sulfur::detail {

struct State;

/// How surfaces meet.
struct Surfaces {
    Real staticFriction = 0, kineticFriction = 0, restitution = 0;
    Real speed = 0;    // m/s along the tangent
    Real rolling = 0;  // coefficient of the couple against rolling
    Real drag = 0;     // kg/s, with Friction::sliding, instead of the coefficients
};
/// Of a corner and a side, by their bodies' slots.
Surfaces surfacesOf(const State& state, std::uint32_t corner, std::uint32_t bodyA,
                    std::uint32_t side, std::uint32_t bodyB);

/// What a point of a row is about: particles of corner and side.
std::array<std::uint32_t, 3> particlesOf(const Shapes& shapes, std::uint32_t corner,
                                         std::uint32_t side);

/// Of a row about the same particles that went in this step, or null.
const Heir* findHeir(const ContactCore& core, const std::array<std::uint32_t, 3>& particles);
/// Leaves the impulses of a row that goes to whoever comes to stand for the same particles.
void leaveToHeirs(ContactCore& core, const std::array<std::uint32_t, 3>& particles, Real pressing,
                  Real rubbing);

/// Looks at the pairs that are listed in ContactCore::again. Where there are too many for a step,
/// at some, from another one on in each step: the others keep their rows and are due again.
void lookAtListed(State& state);
/// What a look at two convex chunks finds, if they still go like this when it is their turn: a row
/// that is made or changed may push them.
struct ForeseenManifold {
    bool isKnown = false;
    Motion3 a, b;  // how their frames go
    Manifold manifold;
};
Manifold manifoldOf(const ContactCore& core, const Pair& pair);
/// Both chunks are convex: one row of up to two points.
void lookAtManifold(State& state, std::uint32_t pair, const ForeseenManifold& foreseen);
/// Something of either may move by itself: a row for each corner that is near a side.
void lookAtTouches(State& state, std::uint32_t pair);
/// Takes a touch away that is in no list of a pair.
void dropTouch(ContactCore& core, std::uint32_t touch);

}  // namespace sulfur::detail
