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

/// Particles and capsules, relative to the capsules' first ends at the start of the tick, and how
/// each particle meets the side of its capsule: to the bit what lookAt() and meetSide()
/// (collision/) say. Behind the last candidate there may be any numbers.
struct alignas(8 * sizeof(SweepReal)) MeetingBlock {
    using Lane = SweepReal[meetingLanes];

    Lane x, y;            // m, of the particle
    Lane endX, endY;      // m, of the capsule's second end
    Lane moveX, moveY;    // m, displacements of the particle in this tick
    Lane moveAX, moveAY;  // m, those of the capsule's ends
    Lane moveBX, moveBY;
    Lane reach;  // m, how near is near, without what the tick moves

    // What follows from these.
    Lane along;             // place on the axis that is nearest, 0..1
    Lane travel;            // m, by which the fastest part moves against the other
    Lane far;               // 1: this tick cannot bring them together; otherwise 0
    Lane normalX, normalY;  // unit, from the axis to the particle, across the axis
    Lane distance;          // m, along the normal, never negative
    Lane movedX, movedY;    // m, the displacement of the particle against the place `along`
    Lane closing;           // m, that displacement along the normal
};

struct MeetingKernels {
    void (*meet)(MeetingBlock* blocks, std::size_t count);
};

extern const MeetingKernels baselineMeetings;
#ifdef SULFUR_AVX2_KERNELS
extern const MeetingKernels avx2Meetings;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const MeetingKernels& meetingKernels();

}  // namespace sulfur::detail
