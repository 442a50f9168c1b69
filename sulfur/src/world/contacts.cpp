// World: who touches whom.
#include "contacts/encounters.hpp"
#include "contacts/stages.hpp"
#include "world/impl.hpp"

namespace sulfur {

using detail::indexOf;
using detail::State;

namespace {

/// With impulses of the whole tick, for which its last step stands.
ContactInfo infoOf(const State& state, const detail::ContactLoad& c, Real ofTick) {
    const auto& p = state.particles;
    return {state.bodies[c.bodyA].id,
            state.bodies[c.bodyB].id,
            p.position[c.particle] - (p.reach[c.particle] * c.normal).cast<double>(),
            c.normal,
            c.normalLambda * ofTick,
            c.tangentLambda * ofTick};
}

}  // namespace

std::vector<ContactInfo> World::contacts() const {
    const State& state = impl_->state();
    std::vector<ContactInfo> found;
    std::vector<detail::ContactLoad> points;
    detail::exportContacts(state, points, true);
    const Real ofTick = tickDuration() / (state.h * state.h);
    for (const auto& c : points) found.push_back(infoOf(state, c, ofTick));
    return found;
}

std::size_t World::contacts(BodyId id, std::span<ContactInfo> out) const {
    State& state = impl_->state();
    detail::exportContactsOf(state, indexOf(state, id), state.asked);
    const Real ofTick = tickDuration() / (state.h * state.h);
    const std::size_t told = std::min(out.size(), state.asked.size());
    for (std::size_t k = 0; k < told; ++k) out[k] = infoOf(state, state.asked[k], ofTick);
    return state.asked.size();
}

bool World::touches(BodyId a, BodyId b) const {
    const State& state = impl_->known();
    indexOf(state, a);
    indexOf(state, b);
    return detail::areTouching(state.core, a, b);
}

}  // namespace sulfur
