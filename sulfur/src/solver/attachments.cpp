// Attachments and hinges that no tree has taken: a place of one thing held at a place of another.
#include "core/limits.hpp"
#include "particles/motion.hpp"
#include "rigid/held_point.hpp"
#include "solver/constraint_kinds.hpp"

namespace sulfur::detail {

namespace {

/// What this tick closes of a gap at its start, at a speed in m/s.
Vec2 toClose(const State& state, const Vec2& gap, double speed) {
    const double size = static_cast<double>(gap.norm());
    const double left = errorLeft(size, static_cast<double>(state.h), speed);
    return left > 0 ? Vec2((1 - static_cast<Real>(left / size)) * gap) : gap;
}

/// C = x_p - sum of weight_i x_i = 0 in both axes at once.
void solve(State& state, Attachment& held) {
    const auto& x = state.particles.position;
    HeldPoint point;
    point.add(gripOf(state, held.particle), 1);
    Vec2 error(0, 0);
    for (std::uint32_t k = 0; k < held.count; ++k) {
        point.add(gripOf(state, held.support[k]), -held.weight[k]);
        error += held.weight[k] * (x[held.particle] - x[held.support[k]]).cast<Real>();
    }
    error = toClose(state, error, attachingSpeed) + point.displacement(state);
    const Vec2 impulse = -solve2(point.mobility(state), error);
    held.force += newtonsPerMultiplier(state) * impulse;
    point.push(state, impulse);
}

void solve(State& state, Hinge& hinge) {
    const Cluster& c = state.clusters.list[hinge.cluster];
    const Point arm = turned(c.heading, hinge.place);
    HeldPoint point;
    point.add({none, hinge.cluster, arm.cast<Real>()}, 1);
    point.add(gripOf(state, hinge.particle), -1);
    const Vec2 apart = (c.centre + arm - state.particles.position[hinge.particle]).cast<Real>();
    const Vec2 error = toClose(state, apart, closingSpeed) + point.displacement(state);
    const Vec2 impulse = -solve2(point.mobility(state), error);
    hinge.force += newtonsPerMultiplier(state) * impulse;
    point.push(state, impulse);
}

}  // namespace

void solveAttachments(State& state) {
    for (const auto i : state.work.attachments) solve(state, state.attachments[i]);
    for (const auto i : state.work.hinges) solve(state, state.clusters.hinges[i]);
}

}  // namespace sulfur::detail
