#include "collision/contact_memory.hpp"

#include <algorithm>
#include <cmath>

#include "core/bucket_sort.hpp"
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

/// m/s: no blow stops an approach that is slower, that of what falls onto its support in a tick.
Real slowestBlow(const State& state) {
    return 2 * state.h * state.settings.gravity.norm();
}

/// What the contact goes on to carry: all but the blow that stopped an approach, which the next
/// tick does not need.
Real sustained(const Contact& c, Real h, Real slowest) {
    const Real blow = c.approach - slowest;
    if (!(blow > 0)) return std::max<Real>(c.normalLambda, 0);
    return std::max<Real>(c.normalLambda - blow * h / c.inverseEffectiveMass, 0);
}

}  // namespace

void indexMemory(State& state) {
    if (state.contactMemory.empty()) return;
    auto& start = state.memoryStart;
    start.assign(state.particles.size() + 1, 0);
    for (const ContactMemory& m : state.contactMemory) ++start[m.particle + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
}

void rememberContacts(State& state) {
    auto& memory = state.contactMemory;
    if (state.work.sleepers == 0)
        memory.clear();
    else
        std::erase_if(memory, [&](const ContactMemory& m) { return !isFrozen(state, m); });
    const Real h = state.h, slowest = slowestBlow(state);
    for (const Contact& c : state.contacts)
        if (isWorthRemembering(c))
            memory.push_back({c.particle, c.a, c.b, c.normal, c.normalLambda, c.tangentLambda,
                              sustained(c, h, slowest), c.drift, h,
                              static_cast<std::uint8_t>(c.sliding)});
    if (std::is_sorted(memory.begin(), memory.end(), byParticle)) return;
    // What was kept came first. (A stable sort would take memory.)
    thread_local std::vector<ContactMemory> scratch;
    thread_local std::vector<std::uint32_t> start;
    countingSort(memory, scratch, start, state.particles.size(),
                 [](const ContactMemory& m) { return m.particle; });
}

}  // namespace sulfur::detail
