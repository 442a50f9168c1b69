// Angular joints, as far as they are forces.
#include "joints/turn.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

/// s, from a step's start to the mean moment at which its forces act on a particle: what moves in
/// steps of its own is kicked in each of them. A force that lags behind would feed the angle.
double delayAt(const State& state, std::uint32_t particle) {
    const Trees& trees = state.trees;
    const auto cluster = state.particles.cluster[particle];
    const auto tree = cluster != none ? trees.ofCluster[cluster] : trees.ofParticle[particle];
    if (tree == none) return 0;
    return static_cast<double>(state.h) / 2 * (1 - 1 / static_cast<double>(trees.list[tree].steps));
}

/// Arms that have become shorter than in the blueprint would make it stiffer than it may be: there
/// it pulls less.
double softened(double torque, double steep, double steepest) {
    return steep > steepest ? torque * (steepest / steep) : torque;
}

void addTorque(State& state, std::uint32_t i) {
    Angles& angles = state.angles;
    Particles& p = state.particles;
    const auto a = angles.a[i], b = angles.b[i], c = angles.c[i];
    const Point before = p.position[b] - p.position[a], after = p.position[c] - p.position[b];
    angles.torque[i] = 0;
    if (!hasTurn(before, after)) return;
    const Turn turn = turnOf(before, after);
    const double rate = turn.slopes[0].dot(p.velocity[a]) + turn.slopes[1].dot(p.velocity[b]) +
                        turn.slopes[2].dot(p.velocity[c]);
    const double stiffness = static_cast<double>(angles.explicitStiffness[i]);
    const double damping =
        static_cast<double>(angles.explicitDamping[i]) + stiffness * delayAt(state, b);
    const double bent = withoutTurns(turn.angle - static_cast<double>(angles.restAngle[i]));
    const double torque = softened(-stiffness * bent - damping * rate,
                                   turn.slopes[0].squaredNorm() + turn.slopes[2].squaredNorm(),
                                   static_cast<double>(angles.steepest[i]));
    angles.torque[i] = static_cast<Real>(torque);
    p.force[a] += torque * turn.slopes[0];
    p.force[b] += torque * turn.slopes[1];
    p.force[c] += torque * turn.slopes[2];
}

}  // namespace

void gatherAngles(State& state) {
    for (const auto i : state.work.explicitAngles) addTorque(state, i);
}

}  // namespace sulfur::detail
