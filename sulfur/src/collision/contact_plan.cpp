#include "collision/contact_plan.hpp"

#include "collision/materials.hpp"

namespace sulfur::detail {

namespace {

/// What is inside of its own body leaves by no side.
int outwardFor(const State& state, std::uint32_t body, const Collider& collider) {
    if (collider.joint == none || body == collider.body) return 0;
    return state.broad.outlines.outwardOf(collider.joint);
}

}  // namespace

ContactPlan planContact(const State& state, std::uint32_t particle, std::uint32_t a,
                        std::uint32_t b, const Collider& collider) {
    const auto& cluster = state.particles.cluster;
    ContactPlan plan;
    plan.particle = particle;
    plan.a = a;
    plan.b = b;
    plan.joint = collider.joint;
    plan.bodyA = state.particles.body[particle];
    plan.bodyB = collider.body;
    plan.clusterOfParticle = cluster[particle];
    plan.clusterOfA = cluster[a];
    plan.clusterOfB = cluster[b];
    plan.thickness = state.particles.reach[particle] + collider.radius;
    plan.outward = outwardFor(state, plan.bodyA, collider);
    plan.movesAsOne = moveAsOne(state, particle, collider);
    giveSurface(state, plan);
    return plan;
}

bool moveAsOne(const State& state, std::uint32_t particle, const Collider& c) {
    const auto& cluster = state.particles.cluster;
    return cluster[particle] != none && cluster[particle] == cluster[c.a] &&
           cluster[particle] == cluster[c.b];
}

void dropStalePlans(BroadPhase& broad) {
    if (!broad.plansStale) return;
    for (Watch& w : broad.watches) w.plan = none;
    std::fill(broad.looks.plan.begin(), broad.looks.plan.end(), none);
    broad.plans.clear();
    broad.plansStale = false;
}

}  // namespace sulfur::detail
