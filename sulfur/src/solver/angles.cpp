// Angular joints, as far as they are forces.
#include "core/settings.hpp"
#include "joints/turn.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

/// How many steps the tick has for a particle: more than one for trees under great tension.
std::uint32_t stepsOf(const State& state, std::uint32_t particle) {
    const Trees& trees = state.trees;
    const auto tree = trees.of(state.particles.cluster[particle], particle);
    return tree == none ? 1 : trees.list[tree].steps;
}

/// What moves in many steps swings within the tick. Held all the time, a force that was found at
/// its start would feed that; as a blow at the start it only takes (r-RESPA: Tuckerman et al.
/// 1992).
void push(State& state, std::uint32_t particle, const Point& newtons) {
    Particles& p = state.particles;
    if (stepsOf(state, particle) == 1) {
        p.force[particle] += newtons;
        return;
    }
    const double h = static_cast<double>(state.h);
    if (p.cluster[particle] == none) {
        p.velocity[particle] += h * static_cast<double>(p.inverseMass[particle]) * newtons;
        return;
    }
    Cluster& c = state.clusters.list[p.cluster[particle]];
    const Point arm = p.position[particle] - c.centre;
    c.velocity += h * static_cast<double>(c.inverseMass) * newtons;
    c.spin += h * static_cast<double>(c.inverseInertia) * cross(arm, newtons);
}

/// Arms that are short make it steeper than forces may be: a damper brakes less there. (An elastic
/// torque that did would be no gradient of an energy.)
double softened(double torque, const Angles& angles, std::uint32_t i, const Turn& turn) {
    const auto squareOf = [](Real arm) {
        return static_cast<double>(arm) * static_cast<double>(arm);
    };
    const double most = tuned::mostSteepened *
                        (1 / squareOf(angles.armBefore[i]) + 1 / squareOf(angles.armAfter[i]));
    const double steep = turn.slopes[0].squaredNorm() + turn.slopes[2].squaredNorm();
    return steep > most ? torque * (most / steep) : torque;
}

void addTorque(State& state, std::uint32_t i) {
    Angles& angles = state.angles;
    Particles& p = state.particles;
    const auto a = angles.a[i], b = angles.b[i], c = angles.c[i];
    const Point before = p.position[b] - p.position[a], after = p.position[c] - p.position[b];
    angles.torque[i] = 0;
    if (!hasTurn(before, after)) return;
    const Turn turn = turnOf(angles, i, before, after);
    const double rate = turn.slopes[0].dot(p.velocity[a]) + turn.slopes[1].dot(p.velocity[b]) +
                        turn.slopes[2].dot(p.velocity[c]);
    const double stiffness = static_cast<double>(angles.explicitStiffness[i]);
    const double damping = static_cast<double>(angles.explicitDamping[i]);
    const double torque = -stiffness * turn.bend - softened(damping * rate, angles, i, turn);
    angles.torque[i] = static_cast<Real>(torque);
    push(state, a, torque * turn.slopes[0]);
    push(state, b, torque * turn.slopes[1]);
    push(state, c, torque * turn.slopes[2]);
}

}  // namespace

void gatherAngles(State& state) {
    for (const auto i : state.work.explicitAngles) addTorque(state, i);
}

}  // namespace sulfur::detail
