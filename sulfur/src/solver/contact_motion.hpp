// How the two sides of a contact move against each other, and how they are pushed.
#pragma once

#include <algorithm>

#include "rigid/grip.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

/// Whether the grip holds a particle that joints hold to others.
inline bool isSoft(const State& state, const Grip& grip) {
    if (grip.cluster != none || state.particles.inverseMass[grip.particle] == 0) return false;
    return state.bodies[state.particles.body[grip.particle]].particles.size() > 1;
}

/// The coefficient that counts in this tick.
inline Real frictionOf(const Contact& c) {
    return c.sliding ? c.kineticFriction : c.staticFriction;
}

inline Vec2 tangentOf(const Contact& c) {
    return {-c.normal[1], c.normal[0]};
}

[[gnu::always_inline]] inline Vec2 relativeDisplacement(const State& state, const Contact& c) {
    Vec2 moved =
        displacementOf(state, c.gripOfParticle) - c.shareA * displacementOf(state, c.gripOfA);
    if (c.shareB != 0) moved -= c.shareB * displacementOf(state, c.gripOfB);
    return moved;
}

[[gnu::always_inline]] inline void push(State& state, const Contact& c, const Vec2& impulse) {
    push(state, c.gripOfParticle, impulse);
    push(state, c.gripOfA, -c.shareA * impulse);
    if (c.shareB != 0) push(state, c.gripOfB, -c.shareB * impulse);
}

inline Vec2 relativeShift(const State& state, const Contact& c) {
    Vec2 moved = shiftOf(state, c.gripOfParticle) - c.shareA * shiftOf(state, c.gripOfA);
    if (c.shareB != 0) moved -= c.shareB * shiftOf(state, c.gripOfB);
    return moved;
}

inline void shift(State& state, const Contact& c, const Vec2& impulse) {
    shift(state, c.gripOfParticle, impulse);
    shift(state, c.gripOfA, -c.shareA * impulse);
    if (c.shareB != 0) shift(state, c.gripOfB, -c.shareB * impulse);
}

/// m: more than what rests can gain of slip in a tick.
[[gnu::always_inline]] inline Real slipOfRest(const State& state) {
    return 2 * std::max<Real>(state.settings.gravity.norm(), 1) * state.h * state.h;
}

/// By how much the gap at the end of the tick is more than it must be, when the sides move so
/// against each other; what was negative at its start is taken back by the recovery.
[[gnu::always_inline]] inline Real gapLeft(const Contact& c, const Vec2& moved) {
    const Real start = std::max<Real>(c.gap - c.slack, 0);
    return start - c.rise + c.normal.dot(moved);
}
[[gnu::always_inline]] inline Real gapLeft(const State& state, const Contact& c) {
    return gapLeft(c, relativeDisplacement(state, c));
}

/// m, below which the sweeps must not leave the gap: this share of the thickness.
inline Real deepestOf(const Contact& c) {
    constexpr Real guardedDepth = Real(0.25);
    return -guardedDepth * c.thickness;
}

/// How far the surfaces slide along the tangent in this tick.
[[gnu::always_inline]] inline Real slipOf(const Contact& c, const Vec2& moved) {
    return c.conveyed + tangentOf(c).dot(moved);
}
[[gnu::always_inline]] inline Real slipOf(const State& state, const Contact& c) {
    return slipOf(c, relativeDisplacement(state, c));
}

}  // namespace sulfur::detail
