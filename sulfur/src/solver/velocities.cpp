// Stage: velocities follow from displacements, and the particles move.
#include <algorithm>

#include "core/limits.hpp"
#include "particles/motion.hpp"
#include "rigid/cluster_motion.hpp"
#include "solver/momenta.hpp"
#include "solver/stages.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// What the constraints have changed of the predicted displacement becomes velocity. Where they
/// changed nothing, not a bit of the velocity changes.
void velocitiesFromDisplacements(State& state) {
    const MotionView view = motionOf(state.particles);
    const Kick kick = kickOf(state);
    for (const Range range : state.work.free)
        motionKernels().takeUp(view, kick, range.first, range.last);
}

void takeUpDisplacements(State& state) {
    velocitiesFromDisplacements(state);
    updateTreeVelocities(state);
    updateClusterVelocities(state);
}

void movePoints(State& state) {
    const MotionView view = motionOf(state.particles);
    for (const Range range : state.work.points) {
        state.looked(Stage::velocities, range.last - range.first);
        motionKernels().move(view, maxCoordinate, range.first, range.last);
    }
}

}  // namespace

void updateVelocities(State& state) {
    keepMomenta(state, takeUpDisplacements);
    movePoints(state);
    moveClusters(state);
    state.looked(Stage::velocities, state.work.awakeClusters.size());
}

}  // namespace sulfur::detail
