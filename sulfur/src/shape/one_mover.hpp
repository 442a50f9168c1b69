// Kinematic bodies of which contacts see one mover, as of fixed ones.
#pragma once

#include <algorithm>

#include "model/state.hpp"

namespace sulfur::detail {

/// Whether all of a kinematic body stands on one mover, that of its first particle: where it has an
/// arc, whose ends cannot go by themselves. Complexity: linear in its joints.
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
