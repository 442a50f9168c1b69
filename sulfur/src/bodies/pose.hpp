// Where and how a body is: as a whole, and as if it were rigid.
#pragma once

#include <vector>

#include "model/state.hpp"

namespace sulfur::detail {

/// Where the blueprint's frame of a body is.
struct Frame {
    Point centre{0, 0};      // m, its centre of mass in the world
    Point restCentre{0, 0};  // m, and in the blueprint's frame
    Point heading{1, 0};     // (cos, sin) of the frame
};

/// The rigid motion of the blueprint that brings its particles nearest to where they are, weighted
/// by their masses: its angle is that of the sums of m q.x and m q x x over all particles, whose
/// places from the centre of mass are q in the blueprint and x now (the polar decomposition of the
/// matrix of m x q^T; Mueller et al. 2005, "Meshless deformations based on shape matching"). Where
/// both sums vanish, BodyRecord::turn tells.
Frame frameOf(const State& state, const BodyRecord& body);
/// The same when the last tick began.
Frame frameBefore(const State& state, const BodyRecord& body);
Pose poseOf(const Frame& frame);

/// The centre of mass of a body in its blueprint's frame, m, and its velocity, m/s.
Point restCentreOf(const State& state, const BodyRecord& body);
Point meanVelocityOf(const State& state, const BodyRecord& body);

/// What a body is and does as if it were rigid: as much as all of its particles together, pinned
/// ones too.
struct RigidMotion {
    double mass = 0;                   // kg
    double inertia = 0;                // kg m^2, about its centre of mass
    Point centre{0, 0};                // m, the centre of mass
    Point velocity{0, 0};              // m/s
    double spin = 0;                   // rad/s, 0 where nothing can turn
    std::vector<std::uint32_t> discs;  // of its particles, what turns by itself
};
RigidMotion rigidMotionOf(const State& state, std::uint32_t body);
/// kg m^2, of a disc about its own centre.
double inertiaOfDisc(const State& state, std::uint32_t particle);

}  // namespace sulfur::detail
