#include "collision/contact_memory.hpp"

#include <algorithm>
#include <cmath>

#include "world/state.hpp"

namespace sulfur::detail {

namespace {

bool byParticle(const ContactMemory& x, const ContactMemory& y) {
    return x.particle < y.particle;
}

/// A contact between sleepers, or of a sleeper with what physics does not move.
bool isFrozen(const State& state, const ContactMemory& m) {
    const auto& bodyOf = state.particles.body;
    bool anyAsleep = false;
    for (const auto p : {m.particle, m.a, m.b}) {
        const BodyRecord& body = state.bodies[bodyOf[p]];
        if (body.kind == BodyKind::dynamic && !body.asleep) return false;
        anyAsleep |= body.asleep;
    }
    return anyAsleep;
}

/// Where a contact does not even touch, there is nothing to remember but the side.
bool isWorthRemembering(const Contact& c) {
    return c.normalLambda > 0 || c.gap < c.thickness / 2;
}

/// What the contact goes on to carry: all but the blow that stopped an approach faster than what
/// falls onto its support in a tick, which the next tick does not need.
Real sustained(const State& state, const Contact& c) {
    const Real h = state.h;
    const Real blow = c.approach - 2 * h * state.settings.gravity.norm();
    return std::max<Real>(c.normalLambda - std::max<Real>(blow, 0) * h / c.inverseEffectiveMass, 0);
}

}  // namespace

const ContactMemory* recall(const std::vector<ContactMemory>& memory, std::uint32_t particle,
                            std::uint32_t a, std::uint32_t b) {
    const ContactMemory* neighbour = nullptr;
    auto at = std::lower_bound(
        memory.begin(), memory.end(), particle,
        [](const ContactMemory& m, std::uint32_t wanted) { return m.particle < wanted; });
    for (; at != memory.end() && at->particle == particle; ++at) {
        if (at->a == a && at->b == b) return &*at;
        const bool shares = at->a == a || at->a == b || at->b == a || at->b == b;
        if (shares && !neighbour) neighbour = &*at;
    }
    return neighbour;
}

void rememberContacts(State& state) {
    auto& memory = state.contactMemory;
    std::erase_if(memory, [&](const ContactMemory& m) { return !isFrozen(state, m); });
    for (const Contact& c : state.contacts)
        if (isWorthRemembering(c))
            memory.push_back({c.particle, c.a, c.b, c.normal, c.normalLambda, c.tangentLambda,
                              sustained(state, c), c.drift, static_cast<std::uint8_t>(c.sliding)});
    if (!std::is_sorted(memory.begin(), memory.end(), byParticle))
        std::stable_sort(memory.begin(), memory.end(), byParticle);
}

}  // namespace sulfur::detail
