// Kinematic bodies, which their caller moves.
#pragma once

#include <algorithm>

#include "core/trigonometry.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

/// Whether somebody drives a body that physics does not move.
inline bool isDriven(const State& state, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    if (body.kind == BodyKind::dynamic) return false;
    if (body.kind != BodyKind::kinematic || body.moving || body.stopping) return true;
    const auto first = state.particles.velocity.begin() + body.firstParticle;
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(body.particles.size()),
                       [](const Point& v) { return v != Point(0, 0); });
}

/// Where a particle of a kinematic body is when the body is at its target.
inline Point goalOf(const State& state, const BodyRecord& body, std::uint32_t particle) {
    const Point turn = unitVector(body.target.angle);
    const Point rest = state.particles.rest[particle].cast<double>();
    return body.target.position +
           Point(turn[0] * rest[0] - turn[1] * rest[1], turn[1] * rest[0] + turn[0] * rest[1]);
}

}  // namespace sulfur::detail
