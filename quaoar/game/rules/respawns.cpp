#include <quaoar/respawns.hpp>

#include <cmath>
#include <quaoar/session.hpp>

#include "hash.hpp"

namespace quaoar {

Respawns::Respawns(const Attempt& attempt) : clocks_(attempt.level.respawns.size()) {
    std::vector<Plan> plans;
    for (const Respawn& respawn : attempt.level.respawns) {
        const auto ticks = [](double seconds) {
            return static_cast<int>(std::lround(seconds * Session::tickRate));
        };
        plans.push_back({attempt.instance.body(respawn.body),
                         Signals::place(attempt.level, respawn.needs), ticks(respawn.every),
                         ticks(respawn.phase)});
        if (respawn.phase > 0 || !respawn.needs.empty()) {
            attempt.world.setEnabled(plans.back().body, false);
        }
    }
    plans_ = std::make_shared<const std::vector<Plan>>(std::move(plans));
}

bool Respawns::act(const Attempt& attempt, const Signals& signals) {
    bool any = false;
    for (std::size_t i = 0; i < clocks_.size(); ++i) {
        const Plan& plan = (*plans_)[i];
        if (!signals.met(plan.need) || !attempt.world.contains(plan.body)) continue;
        const auto now = static_cast<std::int64_t>(clocks_[i]++) - plan.phase;
        if (now < 0 || now % plan.every != 0) continue;
        bringBack(attempt, plan, attempt.level.respawns[i]);
        any = true;
    }
    return any;
}

/// A rope that is tied to it stays behind: it is let go.
void Respawns::bringBack(const Attempt& attempt, const Plan& plan, const Respawn& respawn) {
    sulfur::World& world = attempt.world;
    const sulfur::scene::Placement& placement = *attempt.level.scene.body(respawn.body);
    if (attempt.rope.hooked(world) == plan.body) attempt.rope.release(world);
    world.setPose(plan.body, placement.pose);
    world.setVelocity(plan.body, placement.velocity, 0);
    if (!world.isEnabled(plan.body)) world.setEnabled(plan.body, true);
}

std::uint64_t Respawns::hash() const {
    Hash hash;
    for (const std::uint64_t clock : clocks_) hash.add(clock);
    return hash.value();
}

}  // namespace quaoar
