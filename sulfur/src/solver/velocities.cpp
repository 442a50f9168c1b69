// Stage: velocities follow from displacements, restitution, and the particles move.
#include <algorithm>

#include "core/limits.hpp"
#include "rigid/cluster_motion.hpp"
#include "rigid/grip.hpp"
#include "solver/motion.hpp"
#include "solver/stages.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// Slower approaches do not rebound, so that what lies comes to rest.
constexpr Real reboundThreshold = Real(0.2);  // m/s

/// What the constraints have changed of the predicted displacement becomes velocity. Where they
/// changed nothing, not a bit of the velocity changes.
void velocitiesFromDisplacements(State& state) {
    const MotionView view = motionOf(state.particles);
    const Kick kick = kickOf(state);
    for (const Range range : state.work.free)
        motionKernels().takeUp(view, kick, range.first, range.last);
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
    const MotionView view = motionOf(state.particles);
    for (const Range range : state.work.points)
        motionKernels().move(view, maxCoordinate, range.first, range.last);
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
