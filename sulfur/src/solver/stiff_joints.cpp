// Joints that are too stiff to be forces: compliant and rigid distance constraints.
#include <algorithm>
#include <cmath>

#include "solver/constraint_kinds.hpp"

namespace sulfur::detail {

namespace {

/// Moves the ends of a joint apart (positive impulse) along a direction from a to b.
void push(Particles& particles, std::uint32_t a, std::uint32_t b, Real impulse,
          const Vec2& direction) {
    particles.displacement[a] -= particles.inverseMass[a] * impulse * direction;
    particles.displacement[b] += particles.inverseMass[b] * impulse * direction;
}

/// Implicit Euler for a spring with a damper, as a constraint with compliance 1 / (k h^2) and an
/// accumulated multiplier (extended position based dynamics, Macklin et al. 2016, equations 18 and
/// 26): the same result for any number of sweeps once they have converged, stable for any k.
void solveImplicit(State& state, std::uint32_t j) {
    Joints& joints = state.joints;
    Particles& particles = state.particles;
    const auto a = joints.a[j], b = joints.b[j];
    const Real h = state.h, k = joints.stiffness[j];
    const Vec2 moved = particles.displacement[b] - particles.displacement[a];
    const Vec2 apart = (particles.position[b] - particles.position[a]).cast<Real>() + moved;
    const Real length = apart.norm();
    if (length == 0) return;
    const Vec2 direction = apart / length;
    const Real w = particles.inverseMass[a] + particles.inverseMass[b];
    // Numerator and denominator times k h^2, so that no stiffness divides by zero.
    const Real hk = k * h * h, hb = joints.damping[j] * h;
    const Real error = length - joints.restLength[j];
    const Real change =
        -(hk * error + hb * direction.dot(moved) + joints.lambda[j]) / ((hk + hb) * w + 1);
    joints.lambda[j] += change;
    push(particles, a, b, change, direction);
}

/// How strongly the tension of the last tick bends a joint's ends aside within a tick, when the
/// joint pulls along its direction at the tick's start: above about 1 that explodes.
Real whip(const State& state, std::uint32_t j, Real w) {
    const Joints& joints = state.joints;
    return 2 * w * std::abs(joints.force[j]) * state.h * state.h / joints.restLength[j];
}

/// A rigid joint pulls along its direction at the start of the tick (SHAKE, Ryckaert et al. 1977):
/// only so does a pendulum keep its energy. Light links under great tension would explode by that;
/// they pull along the mean of the directions at the tick's start and now, which brakes rotation
/// but is stable.
void solveRigid(State& state, std::uint32_t j) {
    Joints& joints = state.joints;
    Particles& particles = state.particles;
    const auto a = joints.a[j], b = joints.b[j];
    const Vec2 before = (particles.position[b] - particles.position[a]).cast<Real>();
    const Vec2 apart = before + particles.displacement[b] - particles.displacement[a];
    const Real rest = joints.restLength[j];
    const Real w = particles.inverseMass[a] + particles.inverseMass[b];
    const Real start = before.norm(), length = apart.norm();
    if (start == 0 || length == 0) return;
    const Vec2 now = apart / length;
    Vec2 direction = before / start;
    if (whip(state, j, w) > Real(0.2)) direction = (direction + now).normalized();
    if (direction.dot(now) < Real(0.5)) direction = now;
    const Real change = (rest * rest - length * length) / (2 * w * direction.dot(apart));
    joints.lambda[j] += change;
    push(particles, a, b, change, direction);
}

}  // namespace

void solveImplicitJoints(State& state) {
    for (const auto j : state.work.implicitJoints) solveImplicit(state, j);
}

void solveRigidJoints(State& state) {
    for (const auto j : state.work.rigidJoints) solveRigid(state, j);
}

void clearMultipliers(State& state) {
    for (const auto j : state.work.implicitJoints) state.joints.lambda[j] = 0;
    for (const auto j : state.work.rigidJoints) state.joints.lambda[j] = 0;
}

void recordForces(State& state) {
    Joints& joints = state.joints;
    const Real scale = -1 / (state.h * state.h);
    for (const auto j : state.work.implicitJoints) joints.force[j] = scale * joints.lambda[j];
    for (const auto j : state.work.rigidJoints) joints.force[j] = scale * joints.lambda[j];
}

}  // namespace sulfur::detail
