// Joints that are too stiff to be forces: compliant and rigid distance constraints.
#include <algorithm>
#include <cmath>

#include "core/limits.hpp"
#include "rigid/grip.hpp"
#include "solver/constraint_kinds.hpp"

namespace sulfur::detail {

namespace {

/// The two ends of a joint, as it takes hold of them.
struct Ends {
    Ends(const State& state, std::uint32_t j)
        : a(gripOf(state, state.joints.a[j])), b(gripOf(state, state.joints.b[j])) {}

    Vec2 moved(const State& state) const {
        return displacementOf(state, b) - displacementOf(state, a);
    }
    Real inverseMass(const State& state, const Vec2& direction) const {
        return inverseMassAlong(state, a, direction) + inverseMassAlong(state, b, direction);
    }
    /// Apart for a positive impulse.
    void push(State& state, const Vec2& impulse) const {
        detail::push(state, a, -impulse);
        detail::push(state, b, impulse);
    }

    Grip a, b;
};

Vec2 apartAtStart(const State& state, std::uint32_t j) {
    const auto& x = state.particles.position;
    return (x[state.joints.b[j]] - x[state.joints.a[j]]).cast<Real>();
}

/// Implicit Euler for the part of a spring with a damper that is no force, as a constraint with
/// compliance 1 / (k h^2) and an accumulated multiplier (extended position based dynamics, Macklin
/// et al. 2016, equations 18 and 26): the same result for any number of sweeps once they have
/// converged, stable for any k.
void solveImplicit(State& state, std::uint32_t j) {
    Joints& joints = state.joints;
    const Ends ends(state, j);
    const Real h = state.h;
    const Vec2 moved = ends.moved(state);
    const Vec2 apart = apartAtStart(state, j) + moved;
    const Real length = apart.norm();
    if (length == 0) return;
    const Vec2 direction = apart / length;
    const Real w = ends.inverseMass(state, direction);
    // Numerator and denominator times k h^2, so that no stiffness divides by zero.
    const Real hk = (joints.stiffness[j] - joints.explicitStiffness[j]) * h * h;
    const Real hb = (joints.damping[j] - joints.explicitDamping[j]) * h;
    const Real error = length - joints.restLength[j];
    const Real change =
        -(hk * error + hb * direction.dot(moved) + joints.lambda[j]) / ((hk + hb) * w + 1);
    joints.lambda[j] += change;
    ends.push(state, change * direction);
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
    const Ends ends(state, j);
    const Vec2 before = apartAtStart(state, j);
    const Vec2 apart = before + ends.moved(state);
    const Real start = before.norm(), length = apart.norm();
    if (start == 0 || length == 0) return;
    const double torn = static_cast<double>(start - joints.restLength[j]);
    const Real rest =
        joints.restLength[j] + static_cast<Real>(errorLeft(torn, static_cast<double>(state.h)));
    const Vec2 now = apart / length;
    Vec2 direction = before / start;
    const Real w = ends.inverseMass(state, direction);
    if (w == 0) return;
    if (whip(state, j, w) > Real(0.2)) direction = (direction + now).normalized();
    if (direction.dot(now) < Real(0.5)) direction = now;
    const Real change = (rest * rest - length * length) / (2 * w * direction.dot(apart));
    joints.lambda[j] += change;
    ends.push(state, change * direction);
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
    for (const auto i : state.work.attachments) state.attachments[i].force = Vec2(0, 0);
    for (const auto i : state.work.hinges) state.clusters.hinges[i].force = Vec2(0, 0);
}

void recordForces(State& state) {
    Joints& joints = state.joints;
    const Real scale = -1 / (state.h * state.h);
    for (const auto j : state.work.stiffJoints) {
        // What is a force as well has been recorded as one already.
        const bool both = joints.explicitStiffness[j] > 0 || joints.explicitDamping[j] > 0;
        joints.force[j] = (both ? joints.force[j] : 0) + scale * joints.lambda[j];
    }
}

}  // namespace sulfur::detail
