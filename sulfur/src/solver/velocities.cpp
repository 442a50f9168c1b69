// Stage: velocities follow from displacements, restitution, and the particles move.
#include <algorithm>

#include "core/limits.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

/// Slower approaches do not rebound, so that what lies comes to rest.
constexpr Real reboundThreshold = Real(0.2);  // m/s

void velocitiesFromDisplacements(State& state) {
    Particles& particles = state.particles;
    const Real rate = 1 / state.h;
    for (const Range range : state.work.awake) {
        for (std::uint32_t i = range.first; i < range.last; ++i) {
            if (particles.inverseMass[i] == 0 &&
                state.bodies[particles.body[i]].kind == BodyKind::kinematic)
                continue;
            const Vec2 v = rate * particles.displacement[i];
            particles.velocity[i] = v.cwiseMax(-maxSpeed).cwiseMin(maxSpeed);
        }
    }
}

/// Newton's law of impact: the normal velocity after is minus restitution times that before.
void rebound(Particles& particles, const Contact& c) {
    auto& v = particles.velocity;
    const auto& w = particles.inverseMass;
    const Vec2 relative = v[c.particle] - c.weightA * v[c.a] - c.weightB * v[c.b];
    const Real wanted = c.restitution * c.approach - c.normal.dot(relative);
    if (wanted <= 0) return;
    const Vec2 impulse = wanted / c.inverseEffectiveMass * c.normal;
    v[c.particle] += w[c.particle] * impulse;
    v[c.a] -= c.weightA * w[c.a] * impulse;
    v[c.b] -= c.weightB * w[c.b] * impulse;
}

void move(State& state) {
    Particles& particles = state.particles;
    for (const Range range : state.work.awake) {
        for (std::uint32_t i = range.first; i < range.last; ++i) {
            const Point moved = particles.position[i] + particles.displacement[i].cast<double>();
            particles.position[i] = moved.cwiseMax(-maxCoordinate).cwiseMin(maxCoordinate);
        }
    }
}

}  // namespace

void updateVelocities(State& state) {
    velocitiesFromDisplacements(state);
    for (const Contact& c : state.contacts)
        if (c.restitution > 0 && c.normalLambda > 0 && c.approach > reboundThreshold)
            rebound(state.particles, c);
    move(state);
}

}  // namespace sulfur::detail
