// Stage: velocities and displacements that forces alone would give.
#include <algorithm>
#include <cmath>

#include "bodies/driven.hpp"
#include "bodies/pose.hpp"
#include "contacts/stages.hpp"
#include "core/limits.hpp"
#include "core/trigonometry.hpp"
#include "particles/motion.hpp"
#include "rigid/cluster_motion.hpp"
#include "rigid/disc_turns.hpp"
#include "rigid/find_clusters.hpp"
#include "rigid/loads.hpp"
#include "solver/mechanisms.hpp"
#include "solver/stages.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// Displaces the particles of a kinematic body so that they arrive at its target after so many
/// steps. Each of these goes its share of the way that is left.
void driveTowardsTarget(State& state, const BodyRecord& body, double steps) {
    Particles& particles = state.particles;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        const Point way = (goalOf(state, body, i) - particles.position[i]) / steps;
        particles.displacement[i] = way.cast<Real>();
        // Not of what has just been rounded: GCC 12 leaves that rounding out, other builds do not.
        particles.velocity[i] = way / static_cast<double>(state.h);
    }
}

/// The target of a kinematic body that turns by itself goes on by a step.
void advanceTarget(const State& state, BodyRecord& body) {
    const double h = static_cast<double>(state.h);
    const Point middle = restCentreOf(state, body);
    Pose& target = body.target;
    const Point centre = target.position + turned(unitVector(target.angle), middle);
    target.angle = std::remainder(target.angle + h * body.spin, fullTurn);
    target.position = centre + h * body.drift - turned(unitVector(target.angle), middle);
    target.position = target.position.cwiseMax(-maxCoordinate / 2).cwiseMin(maxCoordinate / 2);
}

/// Kinematic bodies follow their target, turn by themselves, stop after it, or move on as their
/// velocities say.
void driveKinematicBodies(State& state) {
    Particles& particles = state.particles;
    for (const auto index : state.work.kinematic) {
        BodyRecord& body = state.bodies[index];
        if (isFirstStep(state)) body.turnBefore = body.turn;
        if (body.moving) {
            driveTowardsTarget(state, body, state.stepsLeft);
        } else if (body.spin != 0) {
            advanceTarget(state, body);
            driveTowardsTarget(state, body, 1);
        } else {
            for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
                const auto i = body.firstParticle + k;
                if (body.stopping) particles.velocity[i] = Point(0, 0);
                particles.displacement[i] =
                    (static_cast<double>(state.h) * particles.velocity[i]).cast<Real>();
            }
        }
        if (body.moving || body.spin != 0) body.turn = unitVector(body.target.angle);
        if (state.stepsLeft > 1) continue;
        body.stopping = body.moving;
        body.moving = false;
    }
}

/// A particle whose velocity was set at the start of this tick gets half a kick, so that its
/// velocity then stands for the middle of the tick, as the scheme wants it (without it a fall
/// would be wrong by g h t / 2). The other half is taken off here, before the full kick.
void startFreshParticles(State& state) {
    Particles& particles = state.particles;
    std::sort(state.fresh.begin(), state.fresh.end());
    state.fresh.erase(std::unique(state.fresh.begin(), state.fresh.end()), state.fresh.end());
    state.young.swap(state.fresh);
    state.fresh.clear();
    for (const auto i : state.young) {
        const double w = static_cast<double>(particles.inverseMass[i]);
        if (w == 0) continue;
        const Point gravity = gravityOf(state, particles.body[i]);
        const Point rest = state.settings.gravity.cast<double>() - gravity + w * particles.force[i];
        particles.velocity[i] -= lastStepOf(state, i) / 2 * gravity + state.lastStep / 2 * rest;
        stirClusters(state, i);
        if (state.discTurns.empty() || particles.cluster[i] == none) continue;
        Cluster& c = state.clusters.list[particles.cluster[i]];
        if (isDisc(c)) c.spin -= state.lastStep / 2 * torqueOn(state, c) * c.freeInverseInertia;
    }
}

/// v += h (g + w f) and d = h v for the particles that move by themselves.
void predictParticles(State& state) {
    const MotionView view = motionOf(state.particles);
    const Kick kick = kickOf(state);
    for (const Range range : state.work.free) {
        state.looked(Stage::predict, range.last - range.first);
        motionKernels().predict(view, kick, range.first, range.last);
    }
    for (const auto i : state.work.heldNodes) state.particles.displacement[i] = Vec2(0, 0);
}

}  // namespace

void predict(State& state) {
    state.looked(Stage::predict, state.work.kinematic.size() + state.work.awakeClusters.size() +
                                     state.work.lonelyTrees.size());
    if (!state.discTurns.empty()) takeSpins(state);
    startFreshParticles(state);
    adoptStirredClusters(state);
    startMechanisms(state);
    resistRolling(state);
    predictParticles(state);
    driveKinematicBodies(state);
    predictClusters(state);
    stepTrees(state);
    noteLoads(state);
    spreadDisplacements(state);
}

}  // namespace sulfur::detail
