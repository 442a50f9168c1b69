// Looking from one corner at the sides or corners of a chunk, several at once.
//
// Compiled twice and chosen at run time like joint_sweep.hpp, with the same promise and the same
// care: the same bits as one by one, because where lanes meet they give a minimum.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

/// Most corners, and most sides, of a chunk.
inline constexpr std::size_t mostOfChunk = 32;

/// Where a corner is, from the origin of a look, and where it goes in this step.
struct CornerWay {
    SweepReal x = 0, y = 0;        // m
    SweepReal wayX = 0, wayY = 0;  // m
};

/// The same of up to 32 corners.
struct CornerLanes {
    SweepReal x[mostOfChunk]{}, y[mostOfChunk]{};        // m
    SweepReal wayX[mostOfChunk]{}, wayY[mostOfChunk]{};  // m
};

/// The sides of a chunk as a look sees them. Lanes behind the last hold what can be computed with.
struct SideLanes {
    CornerLanes a, b;
    SweepReal radius[mostOfChunk]{};   // m
    SweepReal outward[mostOfChunk]{};  // +1, -1, or 0: where it pushes is for the look to find
    std::uint32_t count = 0;
};

/// What one corner sees of sides. Bits and lanes are of sides.
struct SidesSeen {
    SweepReal far[mostOfChunk];     // m, from their axes
    SweepReal height[mostOfChunk];  // m, above the line of the axis, outwards
    SweepReal outward[mostOfChunk];
    SweepReal gap = 0;          // m, the least between surfaces
    SweepReal spare = 0;        // m, the least of those that are not near
    SweepReal enter = 0;        // m, until it comes before one that it is near and beside
    std::uint32_t nearest = 0;  // the first of the least `far`; mostOfChunk where none has a length
    std::uint32_t before = 0;   // that may count in this step and that it is before when the two
                                // come to touch
};

/// The corners of a chunk, and what their capsules lead to.
struct SpokedCorners {
    CornerLanes at;
    SweepReal radius[mostOfChunk]{};  // m
    /// Other ends of their capsules, the k-th of all of them at k; the corner itself where it has
    /// not so many.
    const CornerLanes* spokes = nullptr;
    std::uint32_t mostSpokes = 0;
    std::uint32_t count = 0;
};

/// What one corner sees of others; as SidesSeen.
struct CornersSeen {
    SweepReal far[mostOfChunk];    // m, between the centres
    SweepReal enter[mostOfChunk];  // m, of near ones
    SweepReal gap = 0, spare = 0;  // m
    std::uint32_t near = 0, before = 0;
};

struct LookKernels {
    /// What a corner of this radius sees of the sides whose bits are set.
    void (*sides)(const CornerWay&, SweepReal radius, const SideLanes&, std::uint32_t may,
                  SidesSeen&);
    /// What the corner `number` of `own` sees of the corners of `others` whose bits are set.
    void (*corners)(const SpokedCorners& own, std::uint32_t number, const SpokedCorners& others,
                    std::uint32_t may, CornersSeen&);
};

/// m, farther than anything that is looked at.
inline constexpr SweepReal lookedAway = SweepReal(1e30);

extern const LookKernels baselineLooks;
#ifdef SULFUR_AVX2_KERNELS
extern const LookKernels avx2Looks;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const LookKernels& lookKernels();

}  // namespace sulfur::detail
