// Looking at many triangles, several at once, for those that displacements press too flat.
//
// Compiled twice and chosen at run time like joint_sweep.hpp, with the same promise and the same
// care: the same bits as one by one.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

/// Arrays of particles, x and y in turn, and of triangles. Behind the last triangle the arrays go
/// on to the next multiple of sweepLanes with numbers that can be computed with.
struct AreaView {
    const double* position;          // m, when the tick began
    const SweepReal* displacement;   // m, so far
    const std::uint32_t *a, *b, *c;  // twice the numbers of particles: the places of their x
    const SweepReal* rest;           // m^2, twice the area at rest
    std::uint8_t* flat;              // a bit for each triangle, set or cleared
};

struct AreaKernels {
    /// Notes which triangles of [8 first, 8 last) the displacements lead to less than this share of
    /// their area at rest.
    void (*look)(const AreaView&, SweepReal share, std::size_t first, std::size_t last);
};

extern const AreaKernels baselineAreas;
#ifdef SULFUR_AVX2_KERNELS
extern const AreaKernels avx2Areas;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const AreaKernels& areaKernels();

}  // namespace sulfur::detail
