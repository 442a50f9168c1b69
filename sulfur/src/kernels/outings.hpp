// How far particles are from where the broad phase last drew them, several at once.
//
// Compiled twice and chosen at run time like joint_sweep.hpp, with the same promise and the same
// ban on headers with functions.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

/// The arrays of all particles, x and y in turn.
struct OutingView {
    const double* position;         // m
    const double* reference;        // m, where they were drawn
    const SweepReal* displacement;  // m
};

/// What skins, leeways and strides are made of: shares of the base skin, and steps of a tick. See
/// collision/skins.hpp, which needs leeway <= skin - base / 8 - sqrt 2 stride.
inline constexpr SweepReal leastSkin = SweepReal(1.25), skinSteps = 3, moreSteps = 14;
inline constexpr SweepReal leastStride = SweepReal(0.25), strideSteps = SweepReal(1.1);
inline constexpr SweepReal leastLeeway = SweepReal(0.771), leewaySteps = SweepReal(1.444);

/// How far particles may go.
struct SkinBound {
    const SweepReal* step;   // m, of each particle: for which it was drawn
    const SweepReal* reach;  // m, of each particle; 0: it has no surface
    SweepReal base;          // m, what skins are measured by
    SweepReal cell;          // m
    SweepReal lookAhead;     // ticks of displacement that count too
    SweepReal share;         // of its leeway that it may use; it may always go as far as its stride
};

/// The arrays of all candidates.
struct CandidateView {
    const std::uint32_t* particle;
    const std::uint32_t *a, *b;  // the collider's particles
    const SweepReal* spare;      // m, that the two sides may be off, together
};

/// Each works on the particles, or candidates, [first, last).
struct OutingKernels {
    /// How far each will be from its reference at most, in m.
    void (*measure)(const OutingView&, SweepReal* outings, std::size_t first, std::size_t last);
    /// Whether any that has a surface is, or will be, further off than it may be, or goes too far.
    bool (*anyBeyond)(const OutingView&, const SkinBound&, std::size_t first, std::size_t last);
    /// Writes down, in their order, the candidates whose sides are off by as much as they may be;
    /// returns how many. There is room for all of them.
    std::size_t (*findNear)(const CandidateView&, const SweepReal* outings, std::uint32_t* near,
                            std::size_t first, std::size_t last);
};

extern const OutingKernels baselineOutings;
#ifdef SULFUR_AVX2_KERNELS
extern const OutingKernels avx2Outings;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const OutingKernels& outingKernels();

}  // namespace sulfur::detail
