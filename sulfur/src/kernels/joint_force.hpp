// The forces of many elastic joints that share no particle, several at once.
//
// Compiled twice and chosen at run time like joint_sweep.hpp, with the same promise and the same
// care: the same bits as one by one.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

/// Arrays of particles, x and y in turn, and of joints. Behind the last joint of a batch those of
/// joints go on to the next multiple of sweepLanes with numbers that can be computed with.
struct ForceView {
    const double* position;      // m
    const double* velocity;      // m/s
    double* force;               // N, to which they add
    SweepReal* pull;             // N, of all joints by their numbers
    const std::uint32_t* joint;  // their numbers
    const std::uint32_t *a, *b;  // twice the numbers of particles: the places of their x
    const SweepReal *rest, *stiffness, *damping;
};

/// Adds the forces of joints [first, first + count); with dampers along them, or without a look at
/// velocities.
struct ForceKernels {
    void (*elastic)(const ForceView& joints, std::size_t first, std::size_t count);
    void (*damped)(const ForceView& joints, std::size_t first, std::size_t count);
};

extern const ForceKernels baselineForces;
#ifdef SULFUR_AVX2_KERNELS
extern const ForceKernels avx2Forces;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const ForceKernels& forceKernels();

}  // namespace sulfur::detail
