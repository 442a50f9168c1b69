// After the solver: which bodies began to touch, go on touching, no longer touch.
#include <algorithm>

#include "core/bucket_sort.hpp"
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
    Real impulse = 0;             // N s, of all

    friend bool operator<(const Touching& p, const Touching& q) {
        return p.pair != q.pair ? p.pair < q.pair : p.strongest < q.strongest;
    }
};

/// N s with which a contact pushed in this tick.
Real impulseOf(const State& state, const Contact& c) {
    return c.normalLambda / state.h + c.blow;
}

/// On the surface of the body whose particle touches.
Point placeOf(const State& state, const Contact& c) {
    const auto& p = state.particles;
    return p.position[c.particle] - (p.reach[c.particle] * c.normal).cast<double>();
}

/// Contacts that push, by pairs of bodies, sorted.
void collectTouching(State& state, std::vector<Touching>& found) {
    found.clear();
    for (std::uint32_t i = 0; i < state.contacts.size(); ++i) {
        const Contact& c = state.contacts[i];
        if (c.normalLambda <= 0) continue;
        found.push_back({pairOf(state, c), i, impulseOf(state, c)});
        if (c.staticFriction > 0) ++state.statistics.rubbingContacts;
    }
    thread_local std::vector<Touching> scratch;
    thread_local std::vector<std::uint32_t> start;
    bucketSort(found, scratch, start, state.bodySlots.slots() + 1,
               [](const Touching& t) { return t.pair.a.index; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (kept == 0 || found[kept - 1].pair != found[i].pair) {
            found[kept++] = found[i];
            continue;
        }
        Touching& pair = found[kept - 1];
        pair.impulse += found[i].impulse;
        const auto of = [&](std::uint32_t c) { return impulseOf(state, state.contacts[c]); };
        if (of(found[i].strongest) > of(pair.strongest)) pair.strongest = found[i].strongest;
    }
    found.resize(kept);
}

void tellBegun(State& state, const Touching& t) {
    const Contact& c = state.contacts[t.strongest];
    state.events.contactsBegun.push_back({state.bodies[c.bodyA].id, state.bodies[c.bodyB].id,
                                          placeOf(state, c), c.normal,
                                          std::max<Real>(c.approach, 0), t.impulse});
}

void tellPersisted(State& state, const Touching& t) {
    const Contact& c = state.contacts[t.strongest];
    state.events.contactsPersisted.push_back({state.bodies[c.bodyA].id, state.bodies[c.bodyB].id,
                                              placeOf(state, c), c.normal, t.impulse});
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
    if (found.empty() && state.touchingFrozen && !state.structure.stale) return;
    now.clear();
    // Both lists are sorted: one walk along both tells what is new and what is gone.
    auto before = state.touching.cbegin();
    const auto passUntil = [&](const Touching* next) {
        for (; before != state.touching.cend() && (!next || *before < next->pair); ++before)
            if (isFrozen(state, *before))
                now.push_back(*before);
            else
                state.events.contactsEnded.push_back({before->a, before->b});
    };
    for (const Touching& t : found) {
        passUntil(&t);
        now.push_back(t.pair);
        if (before == state.touching.cend() || *before != t.pair) {
            tellBegun(state, t);
            continue;
        }
        ++before;
        if (state.settings.tellPersisting) tellPersisted(state, t);
    }
    passUntil(nullptr);
    std::swap(state.touching, now);
    state.touchingFrozen = found.empty();
}

}  // namespace sulfur::detail
