// Which capsules are arcs, and what that asks of their bodies.
#pragma once

#include <algorithm>

#include "model/state.hpp"
#include "shape/arc.hpp"

namespace sulfur::detail {

/// rad, by which a capsule turns from its end a to its b: where these move as one, which of a
/// dynamic body is known when its rigid components are. 0 where it is straight.
inline double bendOf(const State& state, std::uint32_t joint) {
    const double bend = static_cast<double>(state.joints.bend[joint].angle);
    if (bend == 0) return 0;
    const Particles& p = state.particles;
    const auto a = state.joints.a[joint], b = state.joints.b[joint];
    const BodyRecord& body = state.bodies[p.body[a]];
    const bool asOne = body.kind != BodyKind::dynamic || body.clustersStale ||
                       (p.cluster[a] != none && p.cluster[a] == p.cluster[b]);
    return asOne ? bend : 0;
}

/// Calls f(from, to, share at from, share at to) for the straight pieces of a joint's axis from a
/// to b, its ends: one, or the chords of an arc.
template <class Function>
void forEachPieceOf(const State& state, std::uint32_t joint, const Point& a, const Point& b,
                    Function&& f) {
    const double bend = bendOf(state, joint);
    if (bend == 0) return f(a, b, 0.0, 1.0);
    forEachChord(arcBetween(a, b, bend),
                 chordsWithin * static_cast<double>(state.joints.radius[joint]), f);
}

/// Whether all of a kinematic body stands on one mover, as of a fixed one: where it has an arc.
/// Complexity: linear in its joints.
inline bool standsOnOneMover(const State& state, const BodyRecord& body) {
    return body.kind == BodyKind::kinematic &&
           std::any_of(body.joints.begin(), body.joints.end(), [&](JointId id) {
               return state.joints.bend[state.jointSlots.dense(id)].angle != 0;
           });
}

/// (cos, sin) of how such a body is turned against its blueprint, when the step begins: as its
/// first and last particles stand.
inline Point headingOfWhole(const State& state, const BodyRecord& body) {
    const auto first = body.firstParticle;
    const auto last = first + static_cast<std::uint32_t>(body.particles.size()) - 1;
    const Particles& p = state.particles;
    const Point made = (p.rest[last] - p.rest[first]).cast<double>();
    const Point now = p.position[last] - p.position[first];
    const Point heading(made.dot(now), cross(made, now));
    const double size = heading.norm();
    return size > 0 ? Point(heading / size) : Point(1, 0);
}

}  // namespace sulfur::detail
