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
    if (body.kind != BodyKind::kinematic || body.moving || body.stopping || body.spin != 0)
        return true;
    const auto first = state.particles.velocity.begin() + body.firstParticle;
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(body.particles.size()),
                       [](const Point& v) { return v != Point(0, 0); });
}

/// Where a particle of a kinematic body is when the body is at its target.
inline Point goalOf(const State& state, const BodyRecord& body, std::uint32_t particle) {
    return body.target.position +
           turned(unitVector(body.target.angle), state.particles.rest[particle].cast<double>());
}

/// rad, by which a kinematic body turns in this step, to first order, as its first and last
/// particle go.
inline double turnOf(const State& state, const BodyRecord& body) {
    const auto first = body.firstParticle;
    const auto last = first + static_cast<std::uint32_t>(body.particles.size()) - 1;
    const Particles& p = state.particles;
    const Point apart = p.position[last] - p.position[first];
    const Point goes = (p.displacement[last] - p.displacement[first]).cast<double>();
    const double size = apart.squaredNorm();
    return size > 0 ? cross(apart, goes) / size : 0;
}

}  // namespace sulfur::detail
