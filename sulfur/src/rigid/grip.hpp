// Where a constraint takes hold: a particle that moves by itself, or a point of a rigid component.
//
// A joint, contact or attachment acts on grips, so that what touches or hangs on a rigid component
// feels its effective mass at that point.
//
// What every sweep calls for every contact is always inlined: that is worth a fifth of their time.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/trigonometry.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

inline Grip gripOf(const State& state, std::uint32_t particle) {
    return {particle, state.particles.cluster[particle], state.particles.arm[particle]};
}

/// Where the grip goes in this tick, so far.
[[gnu::always_inline]] inline Vec2 displacementOf(const State& state, const Grip& grip) {
    if (grip.cluster == none) return state.particles.displacement[grip.particle];
    const Cluster& c = state.clusters.list[grip.cluster];
    return c.displacement + c.sine * perpendicular(grip.arm) - c.versine * grip.arm;
}

/// 1/kg that a push along `direction` (unit length) meets.
inline Real inverseMassAlong(const State& state, const Grip& grip, const Vec2& direction) {
    if (grip.cluster == none) return state.particles.inverseMass[grip.particle];
    const Cluster& c = state.clusters.list[grip.cluster];
    const Real lever = cross(grip.arm, direction);
    return c.inverseMass + c.inverseInertia * lever * lever;
}

/// The inverse masses along and across the axes: the displacement per impulse (kg m) there.
inline Eigen::Matrix<Real, 2, 2> mobilityOf(const State& state, const Grip& grip) {
    Eigen::Matrix<Real, 2, 2> m = Eigen::Matrix<Real, 2, 2>::Identity();
    if (grip.cluster == none) return m * state.particles.inverseMass[grip.particle];
    const Cluster& c = state.clusters.list[grip.cluster];
    const Vec2 across = perpendicular(grip.arm);
    return m * c.inverseMass + c.inverseInertia * across * across.transpose();
}

/// After `angle` was set: its sine and versine.
inline void updateTurn(Cluster& c) {
    // 1 - cos = 2 sin^2 of half the angle, which loses nothing when the angle is small.
    const Point half = unitVector(c.angle / 2);
    c.sine = static_cast<Real>(2 * half[0] * half[1]);
    c.versine = static_cast<Real>(2 * half[1] * half[1]);
}

/// Turns the cluster's motion of this tick by `by` radians more. Small turns, as the sweeps make
/// them, to third order; the exact sine is taken when the tick ends.
[[gnu::always_inline]] inline void turnBy(Cluster& c, double by) {
    constexpr double most = 1e5;  // rad in a tick: as good as any larger one
    c.angle = std::clamp(c.angle + by, -most, most);
    if (std::abs(by) > 0.05) {
        updateTurn(c);
        return;
    }
    const Real delta = static_cast<Real>(by), half = delta * delta / 2;
    const Real sine = c.sine, cosine = 1 - c.versine;
    c.sine = sine + delta * cosine - half * sine;
    c.versine += delta * sine + half * cosine;
}

/// Changes displacements by a push of `impulse` (kg m: impulse times the tick).
[[gnu::always_inline]] inline void push(State& state, const Grip& grip, const Vec2& impulse) {
    if (grip.cluster == none) {
        state.particles.displacement[grip.particle] +=
            state.particles.inverseMass[grip.particle] * impulse;
        return;
    }
    Cluster& c = state.clusters.list[grip.cluster];
    c.displacement += c.inverseMass * impulse;
    turnBy(c, static_cast<double>(c.inverseInertia * cross(grip.arm, impulse)));
}

/// What shift() has added up for the grip in this tick.
inline Vec2 shiftOf(const State& state, const Grip& grip) {
    if (grip.cluster == none) return state.particles.shift[grip.particle];
    const Cluster& c = state.clusters.list[grip.cluster];
    return c.shift + static_cast<Real>(c.twist) * perpendicular(grip.arm);
}

/// Moves positions, not displacements, so that it becomes no velocity.
inline void shift(State& state, const Grip& grip, const Vec2& impulse) {
    if (grip.cluster == none) {
        state.particles.shift[grip.particle] +=
            state.particles.inverseMass[grip.particle] * impulse;
        return;
    }
    Cluster& c = state.clusters.list[grip.cluster];
    c.shift += c.inverseMass * impulse;
    c.twist += static_cast<double>(c.inverseInertia * cross(grip.arm, impulse));
}

/// Velocity and its change by an impulse (N s), after the tick.
inline Vec2 velocityOf(const State& state, const Grip& grip) {
    if (grip.cluster == none) return state.particles.velocity[grip.particle].cast<Real>();
    const Cluster& c = state.clusters.list[grip.cluster];
    return c.velocity.cast<Real>() + static_cast<Real>(c.spin) * perpendicular(grip.arm);
}
inline void strike(State& state, const Grip& grip, const Vec2& impulse) {
    if (grip.cluster == none) {
        state.particles.velocity[grip.particle] +=
            (state.particles.inverseMass[grip.particle] * impulse).cast<double>();
        return;
    }
    Cluster& c = state.clusters.list[grip.cluster];
    c.velocity += (c.inverseMass * impulse).cast<double>();
    c.spin += static_cast<double>(c.inverseInertia * cross(grip.arm, impulse));
}

}  // namespace sulfur::detail
