// Where particles and capsules meet, for several candidates at once.
//
// Compiled twice and chosen at run time like joint_sweep.hpp, with the same promise and the same
// ban on headers with functions.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

/// Candidates that are looked at at once.
inline constexpr std::size_t meetingLanes = 8;

/// Particles and capsules, and how each particle meets the side of its capsule: to the bit what
/// localise(), lookAt() and meetSide() (collision/) say. Behind the last candidate there may be any
/// numbers, of particles that there are.
struct alignas(8 * sizeof(SweepReal)) MeetingBlock {
    using Lane = SweepReal[meetingLanes];

    std::uint32_t particle[meetingLanes], a[meetingLanes], b[meetingLanes];  // the capsule's ends

    // What gather() looks up, relative to the capsules' first ends at the start of the tick.
    double beside[meetingLanes];  // m^2, twice the area to the left of the capsule, to the particle
    Lane x, y;                    // m, of the particle
    Lane endX, endY;              // m, of the capsule's second end
    Lane moveX, moveY;            // m, displacements of the particle in this tick
    Lane moveAX, moveAY;          // m, those of the capsule's ends
    Lane moveBX, moveBY;

    Lane reach;  // m, how near is near, without what the tick moves

    // What meet() finds out from these.
    Lane along;             // place on the axis that is nearest, 0..1
    Lane travel;            // m, by which the fastest part moves against the other
    Lane far;               // 1: this tick cannot bring them together; otherwise 0
    Lane normalX, normalY;  // unit, from the axis to the particle, across the axis
    Lane distance;          // m, along the normal, never negative
    Lane movedX, movedY;    // m, the displacement of the particle against the place `along`
    Lane closing;           // m, that displacement along the normal
};

/// Of all particles, x and y in turn.
struct MeetingView {
    const double* position;         // m
    const SweepReal* displacement;  // m
};

struct MeetingKernels {
    void (*gather)(const MeetingView& view, MeetingBlock* blocks, std::size_t count);
    void (*meet)(MeetingBlock* blocks, std::size_t count);
};

extern const MeetingKernels baselineMeetings;
#ifdef SULFUR_AVX2_KERNELS
extern const MeetingKernels avx2Meetings;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const MeetingKernels& meetingKernels();

}  // namespace sulfur::detail
