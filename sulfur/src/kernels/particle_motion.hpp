// Predicting and moving particles, several at once.
//
// Compiled twice and chosen at run time like joint_sweep.hpp, with the same promise and the same
// ban on headers with functions.
#pragma once

#include <cstddef>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

/// The arrays of all particles, x and y in turn.
struct MotionView {
    double* position;              // m
    double* velocity;              // m/s
    double* force;                 // N
    SweepReal* displacement;       // m
    const SweepReal* inverseMass;  // 1/kg, one per particle; 0: it does not move
};

/// What a kick does: v' = keep v + push (gravity + w f), and d = duration v'.
struct Kick {
    double gravityX, gravityY;  // m/s^2
    double keep, push;          // push in s
    double duration;            // s
    double limit;               // m/s, of each component
};

/// Each works on the particles [first, last).
struct MotionKernels {
    /// Velocities and displacements after a kick; forgets the forces.
    void (*predict)(const MotionView&, const Kick&, std::size_t first, std::size_t last);
    /// What was changed of the displacements becomes velocity.
    void (*takeUp)(const MotionView&, const Kick&, std::size_t first, std::size_t last);
    /// Adds displacements to positions, whose components stay within +-limit.
    void (*move)(const MotionView&, double limit, std::size_t first, std::size_t last);
};

extern const MotionKernels baselineMotion;
#ifdef SULFUR_AVX2_KERNELS
extern const MotionKernels avx2Motion;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const MotionKernels& motionKernels();

}  // namespace sulfur::detail
