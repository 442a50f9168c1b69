#include <quaoar/crumbling.hpp>

#include <algorithm>
#include <cmath>
#include <quaoar/session.hpp>

#include "hash.hpp"

namespace quaoar {

using sulfur::BodyId;

Crumbling::Crumbling(const Attempt& attempt) {
    std::vector<Plan> plans;
    for (const sulfur::scene::Placement& placement : attempt.level.scene.bodies) {
        const auto seconds = attempt.level.surface(placement.id).crumbles;
        if (!seconds) continue;
        const double ticks = std::max(1.0, *seconds * Session::tickRate);
        plans.push_back(
            {attempt.instance.body(placement.id), static_cast<int>(std::lround(ticks))});
    }
    touched_.resize(plans.size());
    plans_ = std::make_shared<const std::vector<Plan>>(std::move(plans));
}

bool Crumbling::wear(const Attempt& attempt) {
    bool loosened = false;
    const BodyId hooked = touched_.empty() ? BodyId{} : attempt.rope.hooked(attempt.world);
    for (std::size_t i = 0; i < touched_.size(); ++i) {
        const Plan& plan = (*plans_)[i];
        if (touched_[i] >= plan.ticks || !attempt.world.contains(plan.body)) continue;
        if (hooked != plan.body && !attempt.world.touches(attempt.hero, plan.body)) continue;
        if (++touched_[i] < plan.ticks) continue;
        loosen(attempt.world, plan.body);
        loosened = true;
    }
    return loosened;
}

void Crumbling::loosen(sulfur::World& world, BodyId body) {
    if (world.kind(body) != sulfur::BodyKind::dynamic) {
        world.setKind(body, sulfur::BodyKind::dynamic);
    }
    for (const sulfur::ParticleId particle : world.particles(body)) {
        if (world.info(particle).pinned) world.setPinned(particle, false);
    }
    world.wake(body);
}

double Crumbling::worn(BodyId body) const {
    for (std::size_t i = 0; i < touched_.size(); ++i) {
        const Plan& plan = (*plans_)[i];
        if (plan.body == body) return static_cast<double>(touched_[i]) / plan.ticks;
    }
    return 0;
}

std::uint64_t Crumbling::hash() const {
    Hash hash;
    for (const int ticks : touched_) hash.add(static_cast<std::uint64_t>(ticks));
    return hash.value();
}

}  // namespace quaoar
