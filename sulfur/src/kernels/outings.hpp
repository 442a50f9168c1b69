// How far particles are from where the broad phase last drew them, several at once.
//
// Compiled twice and chosen at run time like joint_sweep.hpp, with the same promise and the same
// ban on headers with functions.
#pragma once

#include <cstddef>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

/// The arrays of all particles, x and y in turn.
struct OutingView {
    const double* position;         // m
    const double* reference;        // m, where they were drawn
    const SweepReal* displacement;  // m
};

/// How much of its skin a particle may use.
struct SkinBound {
    const SweepReal* skin;   // m, of each particle
    const SweepReal* reach;  // m, of each particle; 0: it has no surface
    SweepReal margin;        // m, of a skin that must be left
    SweepReal lookAhead;     // ticks of displacement that count too
    SweepReal share;         // of the rest
};

/// Each works on the particles [first, last).
struct OutingKernels {
    /// How far each will be from its reference at most, in m.
    void (*measure)(const OutingView&, SweepReal* outings, std::size_t first, std::size_t last);
    /// Whether any that has a surface is further off than it may be.
    bool (*anyBeyond)(const OutingView&, const SkinBound&, std::size_t first, std::size_t last);
};

extern const OutingKernels baselineOutings;
#ifdef SULFUR_AVX2_KERNELS
extern const OutingKernels avx2Outings;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const OutingKernels& outingKernels();

}  // namespace sulfur::detail
