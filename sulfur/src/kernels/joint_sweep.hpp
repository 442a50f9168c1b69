// Sweeping many joints that share no particle, several at once.
//
// The same source, joint_sweep.ipp, is compiled once for every x86-64 and once for AVX2; which of
// the two runs is found out when the program does. Both give the same bits: lanes do not meet,
// roots and divisions are exact, and no product is fused with a sum. Nothing here may include a
// header with functions: the linker could keep the copy that needs AVX2 and use it everywhere.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sulfur::detail {

#ifdef SULFUR_REAL_DOUBLE
using SweepReal = double;
#else
using SweepReal = float;
#endif

/// Batches begin at multiples of this many joints, the widest that a kernel takes at once.
inline constexpr std::size_t sweepLanes = 8;

/// Arrays of joints as the kernels see them. Behind the last joint of a batch the arrays go on to
/// the next multiple of sweepLanes with numbers that can be computed with.
struct StartView {
    const double* position;          // m, x and y in turn, of every particle
    const SweepReal* pulled;         // N in the last tick, of all joints by their numbers
    const std::uint32_t* joint;      // their numbers
    const std::uint32_t *a, *b;      // twice the numbers of particles: the places of their x
    const SweepReal *massA, *massB;  // 1/kg
    const SweepReal* length;         // m, at rest
    const SweepReal *hk, *hb;        // of implicit joints, see below
    // What is found.
    SweepReal *startX, *startY, *directionX, *directionY, *whips, *lambda, *gain;
    SweepReal* rest;  // of rigid joints
    // What all have in common.
    SweepReal h;         // s
    SweepReal mostWhip;  // of a joint that pulls along its direction when the tick began
    double closing;      // m, by which what was torn apart comes together in this tick
};

/// The same joints in a sweep.
struct SweepView {
    SweepReal* displacement;                   // m, x and y in turn, of every particle
    const std::uint32_t *a, *b;                // as above
    const SweepReal *startX, *startY;          // m, from a to b when the tick began
    const SweepReal *massA, *massB;            // 1/kg
    const SweepReal* rest;                     // m
    SweepReal* lambda;                         // kg m
    const SweepReal *directionX, *directionY;  // when the tick began
    const SweepReal* whips;                    // 1: pulls along the mean direction
    // Of implicit joints.
    const SweepReal *hk, *hb;  // kg: stiffness h^2 and damping h
    /// Of implicit joints 1 / ((hk + hb) w + 1), of rigid ones 1 / 2w (kg); 0 where it had no
    /// length or nothing can move.
    const SweepReal* gain;
};

struct SweepKernels {
    /// What all sweeps of a tick have in common.
    void (*startImplicit)(const StartView& joints, std::size_t first, std::size_t count);
    void (*startRigid)(const StartView& joints, std::size_t first, std::size_t count);
    /// Each sweeps once over the joints [first, first + count), which share no particle that moves.
    void (*implicit)(const SweepView& joints, std::size_t first, std::size_t count);
    void (*rigid)(const SweepView& joints, std::size_t first, std::size_t count);
};

extern const SweepKernels baselineSweep;
#ifdef SULFUR_AVX2_KERNELS
extern const SweepKernels avx2Sweep;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const SweepKernels& sweepKernels();

/// What processors differ in, from less to more; not every kernel has a version for each.
enum class Instructions : std::uint8_t { baseline, avx2, avx512 };

/// What this processor has.
Instructions widestInstructions();
/// For tests: nothing more is used from now on, by any thread, whatever the processor has.
void useKernelsUpTo(Instructions most);

}  // namespace sulfur::detail
