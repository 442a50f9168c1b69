// Stage: velocities follow from displacements, restitution, and the particles move.
#include <algorithm>

#include "core/limits.hpp"
#include "rigid/cluster_motion.hpp"
#include "rigid/grip.hpp"
#include "solver/stages.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// Slower approaches do not rebound, so that what lies comes to rest.
constexpr Real reboundThreshold = Real(0.2);  // m/s

/// What the constraints have changed of the predicted displacement becomes velocity. Where they
/// changed nothing, not a bit of the velocity changes.
void velocitiesFromDisplacements(State& state) {
    Particles& particles = state.particles;
    const double h = static_cast<double>(state.h);
    for (const Range range : state.work.free) {
        for (std::uint32_t i = range.first; i < range.last; ++i) {
            if (particles.inverseMass[i] == 0) continue;
            const Vec2 predicted = (h * particles.velocity[i]).cast<Real>();
            const Vec2 change = particles.displacement[i] - predicted;
            particles.velocity[i] = limited(particles.velocity[i] + change.cast<double>() / h);
        }
    }
}

Vec2 relativeVelocity(const State& state, const Contact& c) {
    Vec2 v = velocityOf(state, c.gripOfParticle) - c.shareA * velocityOf(state, c.gripOfA);
    if (c.shareB != 0) v -= c.shareB * velocityOf(state, c.gripOfB);
    return v;
}

/// Newton's law of impact: the normal velocity after is minus restitution times that before.
void rebound(State& state, const Contact& c) {
    const Real wanted = c.restitution * c.approach - c.normal.dot(relativeVelocity(state, c));
    if (wanted <= 0) return;
    const Vec2 impulse = wanted / c.inverseEffectiveMass * c.normal;
    strike(state, c.gripOfParticle, impulse);
    strike(state, c.gripOfA, -c.shareA * impulse);
    if (c.shareB != 0) strike(state, c.gripOfB, -c.shareB * impulse);
}

void movePoints(State& state) {
    Particles& particles = state.particles;
    for (const Range range : state.work.points) {
        for (std::uint32_t i = range.first; i < range.last; ++i) {
            const Point moved = particles.position[i] + particles.displacement[i].cast<double>();
            particles.position[i] = moved.cwiseMax(-maxCoordinate).cwiseMin(maxCoordinate);
        }
    }
}

}  // namespace

void updateVelocities(State& state) {
    velocitiesFromDisplacements(state);
    updateTreeVelocities(state);
    updateClusterVelocities(state);
    for (const Contact& c : state.contacts)
        if (c.restitution > 0 && c.normalLambda > 0 && c.approach > reboundThreshold)
            rebound(state, c);
    movePoints(state);
    moveClusters(state);
}

}  // namespace sulfur::detail
