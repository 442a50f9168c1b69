// Turning rigid components and placing their members, several at once.
//
// Compiled twice and chosen at run time like joint_sweep.hpp, with the same promise and the same
// ban on headers with functions. A lane computes what unitVector() (core/trigonometry.hpp) does, in
// the same order.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

/// At most so many are turned at once. Arrays of them are as long, with numbers behind the last one
/// that can be computed with.
inline constexpr std::size_t clusterBlock = 32;

/// The arrays of particles, x and y in turn, and the lists of members.
struct MemberView {
    double *position, *velocity;     // m, m/s
    double* force;                   // N
    SweepReal *displacement, *arm;   // m
    const std::uint32_t* particles;  // members, cluster by cluster
    const double* places;            // m, of the members in the frames of their clusters
};

/// Where a cluster is when a step ends, and where it was when that began.
struct ClusterPose {
    std::uint32_t first, last;              // members
    double centreX, centreY;                // m
    double headingX, headingY;              // unit
    double centreBeforeX, centreBeforeY;    // m
    double headingBeforeX, headingBeforeY;  // unit
    double velocityX, velocityY;            // m/s
    double spin;                            // rad/s
};

/// Where a cluster goes in a tick.
struct ClusterWay {
    std::uint32_t first, last;  // members
    SweepReal x, y;             // m
    SweepReal sine, versine;    // of the angle by which it turns
};

struct ClusterKernels {
    /// Turns unit vectors by angles (rad). An angle of 0 changes no bit.
    void (*turn)(const double* angle, double* headingX, double* headingY, std::size_t count);
    /// Of angles, from their halves (rad).
    void (*sines)(const double* half, SweepReal* sine, SweepReal* versine, std::size_t count);
    /// Position, displacement, arm and velocity of all members; no component of a velocity is
    /// beyond +-maxSpeed.
    void (*place)(const MemberView&, const ClusterPose*, std::size_t count, double maxSpeed);
    /// Displacements of all members; forgets their forces.
    void (*spread)(const MemberView&, const ClusterWay*, std::size_t count);
};

extern const ClusterKernels baselineClusters;
#ifdef SULFUR_AVX2_KERNELS
extern const ClusterKernels avx2Clusters;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const ClusterKernels& clusterKernels();

}  // namespace sulfur::detail
