// After the stages: which bodies began to touch, go on touching, no longer touch.
#include <algorithm>

#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

BodyPair pairOf(const State& state, const Contact& c) {
    return BodyPair::of(state.bodies[c.bodyA].id, state.bodies[c.bodyB].id);
}

/// All contacts of two bodies, as one.
struct Touching {
    BodyPair pair;
    std::uint32_t strongest = 0;  // contact
    Real lambda = 0;              // kg m, of all
};

/// Contacts that push, by pairs of bodies, sorted.
void collectTouching(const State& state, std::vector<Touching>& found) {
    found.clear();
    for (std::uint32_t i = 0; i < state.contacts.size(); ++i)
        if (state.contacts[i].normalLambda > 0)
            found.push_back(
                {pairOf(state, state.contacts[i]), i, state.contacts[i].normalLambda});
    std::sort(found.begin(), found.end(), [](const Touching& p, const Touching& q) {
        return p.pair != q.pair ? p.pair < q.pair : p.strongest < q.strongest;
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (kept == 0 || found[kept - 1].pair != found[i].pair) {
            found[kept++] = found[i];
            continue;
        }
        Touching& pair = found[kept - 1];
        pair.lambda += found[i].lambda;
        const auto lambdaOf = [&](std::uint32_t c) { return state.contacts[c].normalLambda; };
        if (lambdaOf(found[i].strongest) > lambdaOf(pair.strongest))
            pair.strongest = found[i].strongest;
    }
    found.resize(kept);
}

void tellBegun(State& state, const Touching& t) {
    const Contact& c = state.contacts[t.strongest];
    state.events.contactsBegun.push_back(
        {state.bodies[c.bodyA].id, state.bodies[c.bodyB].id, state.particles.position[c.particle],
         c.normal, std::max<Real>(c.approach, 0), t.lambda / state.h});
}

void tellPersisted(State& state, const Touching& t) {
    const Contact& c = state.contacts[t.strongest];
    state.events.contactsPersisted.push_back(
        {state.bodies[c.bodyA].id, state.bodies[c.bodyB].id, state.particles.position[c.particle],
         c.normal, t.lambda / state.h});
}

/// Whether neither of two bodies takes part, so that what touched still touches.
bool isFrozen(const State& state, const BodyPair& pair) {
    for (const BodyId id : {pair.a, pair.b}) {
        if (!state.bodySlots.contains(id)) return false;
        const BodyRecord& body = state.bodies[state.bodySlots.dense(id)];
        if (body.kind == BodyKind::dynamic && !body.asleep) return false;
    }
    return true;
}

}  // namespace

void collectEvents(State& state) {
    state.events.contactsBegun.clear();
    state.events.contactsPersisted.clear();
    state.events.contactsEnded.clear();
    thread_local std::vector<Touching> found;
    thread_local std::vector<BodyPair> now;
    collectTouching(state, found);
    now.clear();
    for (const Touching& t : found) {
        now.push_back(t.pair);
        if (!std::binary_search(state.touching.begin(), state.touching.end(), t.pair))
            tellBegun(state, t);
        else if (state.settings.tellPersisting)
            tellPersisted(state, t);
    }
    const auto awake = static_cast<std::ptrdiff_t>(now.size());
    for (const BodyPair& pair : state.touching) {
        if (std::binary_search(now.begin(), now.begin() + awake, pair)) continue;
        if (isFrozen(state, pair))
            now.push_back(pair);
        else
            state.events.contactsEnded.push_back({pair.a, pair.b});
    }
    std::sort(now.begin(), now.end());
    std::swap(state.touching, now);
}

}  // namespace sulfur::detail
