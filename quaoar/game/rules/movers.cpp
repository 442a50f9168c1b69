#include <quaoar/movers.hpp>

#include <algorithm>
#include <cmath>
#include <quaoar/session.hpp>

#include "hash.hpp"

namespace quaoar {

using sulfur::Point;

namespace {

constexpr double tick = 1.0 / Session::tickRate;

/// How far it is, 0 to 1, at a time of its rounds: rests at the start, goes, rests, comes back.
double alongAt(const Mover& mover, double time) {
    if (mover.mode == Mover::Mode::once) {
        return std::clamp((time - mover.pauseStart) / mover.seconds, 0.0, 1.0);
    }
    const bool loop = mover.mode == Mover::Mode::loop;
    const double there = mover.pauseStart + mover.seconds;
    const double round = loop ? there : there + mover.pauseEnd + mover.secondsBack;
    const double now = std::fmod(time, round);
    if (now < there) return std::max(0.0, (now - mover.pauseStart) / mover.seconds);
    return 1 - std::max(0.0, (now - there - mover.pauseEnd) / mover.secondsBack);
}

double eased(const Mover& mover, double along) {
    if (!mover.ease || mover.mode == Mover::Mode::loop) return along;
    return along * along * (3 - 2 * along);
}

}  // namespace

Movers::Plan Movers::planOf(const Attempt& attempt, const Mover& mover) {
    const sulfur::Pose& start = attempt.level.scene.body(mover.body)->pose;
    Plan plan;
    plan.body = attempt.instance.body(mover.body);
    plan.need = Signals::place(attempt.level, mover.needs);
    plan.angle = start.angle;
    plan.places = {start.position};
    plan.places.insert(plan.places.end(), mover.path.begin(), mover.path.end());
    if (mover.mode == Mover::Mode::loop) plan.places.push_back(start.position);
    plan.lengths = {0};
    for (std::size_t i = 1; i < plan.places.size(); ++i) {
        const double way = (plan.places[i] - plan.places[i - 1]).norm();
        plan.lengths.push_back(plan.lengths.back() + way);
    }
    return plan;
}

Movers::Movers(const Attempt& attempt) {
    std::vector<Plan> plans;
    for (const Mover& mover : attempt.level.movers) {
        plans.push_back(planOf(attempt, mover));
        State state;
        state.clock = static_cast<std::uint64_t>(std::lround(mover.phase * Session::tickRate));
        if (mover.mode != Mover::Mode::door) {
            state.along = alongAt(mover, static_cast<double>(state.clock) * tick);
        }
        if (state.clock > 0) {
            attempt.world.setPose(plans.back().body, poseOf(mover, plans.back(), state));
        }
        states_.push_back(state);
    }
    plans_ = std::make_shared<const std::vector<Plan>>(std::move(plans));
}

void Movers::advance(const Mover& mover, bool on, State& state) {
    state.begun = state.begun || on;
    if (mover.mode == Mover::Mode::door) {
        state.along += on ? tick / mover.seconds : -tick / mover.secondsBack;
        state.along = std::clamp(state.along, 0.0, 1.0);
        if (on) ++state.clock;
        return;
    }
    if (!(mover.mode == Mover::Mode::once ? state.begun : on)) return;
    ++state.clock;
    state.along = alongAt(mover, static_cast<double>(state.clock) * tick);
}

sulfur::Pose Movers::poseOf(const Mover& mover, const Plan& plan, const State& state) {
    const double along = eased(mover, state.along);
    const double spun =
        std::fmod(mover.spin * static_cast<double>(state.clock) * tick, 2 * 3.14159265358979323846);
    sulfur::Pose pose{plan.places.front(), plan.angle + mover.turn * along + spun};
    const double whole = plan.lengths.back();
    if (whole <= 0) return pose;
    const double way = along * whole;
    std::size_t next = 1;
    while (next + 1 < plan.lengths.size() && plan.lengths[next] < way) ++next;
    const double piece = plan.lengths[next] - plan.lengths[next - 1];
    const double part = piece > 0 ? (way - plan.lengths[next - 1]) / piece : 0;
    pose.position = plan.places[next - 1] + (plan.places[next] - plan.places[next - 1]) * part;
    return pose;
}

/// What does not change its place is not told to: it stands still and lets things sleep.
void Movers::move(const Attempt& attempt, const Signals& signals) {
    for (std::size_t i = 0; i < states_.size(); ++i) {
        const Mover& mover = attempt.level.movers[i];
        const Plan& plan = (*plans_)[i];
        const State before = states_[i];
        advance(mover, signals.met(plan.need), states_[i]);
        const bool spins = mover.spin != 0 && states_[i].clock != before.clock;
        if (states_[i].along == before.along && !spins) continue;
        if (attempt.world.kind(plan.body) != sulfur::BodyKind::kinematic) continue;  // it crumbled
        attempt.world.moveTo(plan.body, poseOf(mover, plan, states_[i]));
    }
}

std::uint64_t Movers::hash() const {
    Hash hash;
    for (const State& state : states_) {
        hash.add(state.clock).add(static_cast<std::uint64_t>(state.begun ? 1 : 0)).add(state.along);
    }
    return hash.value();
}

}  // namespace quaoar
