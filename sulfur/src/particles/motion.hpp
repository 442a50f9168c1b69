// What the kernels of particle motion are given.
#pragma once

#include "core/limits.hpp"
#include "kernels/particle_motion.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

inline MotionView motionOf(Particles& p) {
    static_assert(sizeof(Point) == 2 * sizeof(double) && sizeof(Vec2) == 2 * sizeof(Real));
    if (p.size() == 0) return {};
    return {p.position.data()->data(), p.velocity.data()->data(), p.force.data()->data(),
            p.displacement.data()->data(), p.inverseMass.data()};
}

/// The kick from the middle of the last tick to the middle of this one, with air friction by the
/// trapezoidal rule: v' - v = k a - k c (v + v') / 2.
inline Kick kickOf(const State& state) {
    const double h = static_cast<double>(state.h), duration = (state.lastStep + h) / 2;
    const double half = duration * static_cast<double>(state.settings.airFriction) / 2;
    const Point gravity = state.settings.gravity.cast<double>();
    return {gravity[0], gravity[1], (1 - half) / (1 + half), duration / (1 + half), h, maxSpeed};
}

/// How much more force it takes in a step of h seconds to change a displacement than it would
/// without air friction: all forces, those of constraints too, act against it by the trapezoidal
/// rule.
inline double resistance(const State& state, double h) {
    return 1 + h * static_cast<double>(state.settings.airFriction) / 2;
}

/// N that a multiplier of 1 kg m stands for, in a step of h seconds or in the present one.
inline Real newtonsPerMultiplier(const State& state, Real h) {
    return static_cast<Real>(resistance(state, static_cast<double>(h))) / (h * h);
}
inline Real newtonsPerMultiplier(const State& state) {
    return newtonsPerMultiplier(state, state.h);
}

}  // namespace sulfur::detail
