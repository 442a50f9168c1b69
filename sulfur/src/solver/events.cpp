// After the solver: which bodies began to touch, go on touching, no longer touch.
#include <algorithm>
#include <array>

#include "core/bucket_sort.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

BodyPair pairOf(const State& state, const Contact& c) {
    return BodyPair::of(state.bodyIds[c.bodyA], state.bodyIds[c.bodyB]);
}

/// All contacts of two bodies, as one.
struct FoundTouch {
    std::uint32_t strongest = none;  // contact
    Real most = 0;                   // N s, its impulse
    Real impulse = 0;                // N s, of all

    /// One contact more, in the order of contacts.
    void add(std::uint32_t contact, Real itsImpulse) {
        impulse += itsImpulse;
        if (strongest != none && !(itsImpulse > most)) return;
        strongest = contact;
        most = itsImpulse;
    }
};

/// Two bodies that did not touch in the last tick.
struct NewTouch {
    BodyPair pair;
    FoundTouch touch;

    friend bool operator<(const NewTouch& p, const NewTouch& q) {
        return p.pair != q.pair ? p.pair < q.pair : p.touch.strongest < q.touch.strongest;
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

/// Who touches in this tick: who did in the last one is found there, so that only new pairs must be
/// sorted. Holds scratch memory only.
class Touches {
public:
    std::vector<FoundTouch> old;  // of the pairs in State::touching; of none, who parted
    std::vector<NewTouch> begun;  // sorted
    bool any = false;
    bool same = false;  // the pairs are those in State::touching

    void collect(State& state) {
        begun.clear();
        start_.reserve(state.bodySlots.slots() + 2);  // not only when something new is first seen
        old.assign(state.touching.size(), {});
        hasStarts_ = false;
        asker_ = none;
        if (places_.size() < state.particles.size()) places_.resize(state.particles.size());
        std::size_t touched = 0;
        const Contact* before = nullptr;  // and, if it is an old one, its touch:
        FoundTouch* touch = nullptr;
        for (std::uint32_t i = 0; i < state.contacts.size(); ++i) {
            const Contact& c = state.contacts[i];
            if (c.normalLambda <= 0) continue;
            if (c.staticFriction > 0) ++state.statistics.rubbingContacts;
            const Real impulse = impulseOf(state, c);
            // Neighbours in the list are mostly of the same two bodies.
            if (!touch || before->bodyA != c.bodyA || before->bodyB != c.bodyB)
                touch = find(state, c);
            if (touch) {
                if (touch->strongest == none) ++touched;
                touch->add(i, impulse);
            } else {
                begun.push_back({pairOf(state, c), {i, impulse, impulse}});
            }
            before = &c;
        }
        any = before != nullptr;
        same = begun.empty() && touched == old.size();
        if (!begun.empty()) mergeBegun(state.bodySlots.slots());
    }

private:
    /// Where in State::touching the pairs of each smaller handle begin.
    void findStarts(const State& state) {
        start_.assign(state.bodySlots.slots() + 2, 0);
        for (const BodyPair& pair : state.touching) ++start_[pair.a.index + 1];
        for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
        hasStarts_ = true;
    }

    /// What lies goes on touching the same: a pair is looked for first where the one of the same
    /// particle was found last.
    FoundTouch* find(const State& state, const Contact& c) {
        const BodyPair pair = pairOf(state, c);
        // Most touch at most two bodies.
        const std::size_t which = asker_ == c.particle ? 1 : 0;
        asker_ = c.particle;
        std::uint32_t& place = places_[c.particle][which];
        if (place >= old.size() || state.touching[place] != pair) place = search(state, pair);
        return place < old.size() ? &old[place] : nullptr;
    }

    /// Its place in State::touching, or one past the last.
    std::uint32_t search(const State& state, const BodyPair& pair) {
        if (!hasStarts_) findStarts(state);
        const auto all = state.touching.begin();
        const auto end = all + start_[pair.a.index + 1];
        const auto found = std::lower_bound(all + start_[pair.a.index], end, pair);
        return static_cast<std::uint32_t>(found != end && *found == pair ? found - all
                                                                         : std::ssize(old));
    }

    void mergeBegun(std::size_t slots) {
        bucketSort(begun, scratch_, start_, slots + 1,
                   [](const NewTouch& t) { return t.pair.a.index; });
        std::size_t kept = 0;
        for (const NewTouch& next : begun) {
            if (kept > 0 && begun[kept - 1].pair == next.pair)
                begun[kept - 1].touch.add(next.touch.strongest, next.touch.impulse);
            else
                begun[kept++] = next;
        }
        begun.resize(kept);
    }

    std::vector<std::uint32_t> start_;
    bool hasStarts_ = false;
    std::vector<std::array<std::uint32_t, 2>> places_;  // by particle, where its pairs were found
    std::uint32_t asker_ = none;                        // the particle whose pair was sought last
    std::vector<NewTouch> scratch_;
};

void tellBegun(State& state, const FoundTouch& t) {
    const Contact& c = state.contacts[t.strongest];
    // A sleeper bears whatever lies on it as if it had no end of mass, so that it must not sleep on
    // when something new comes to lie on it, however gently.
    for (const auto body : {c.bodyA, c.bodyB})
        if (state.bodies[body].asleep) state.knocked.push_back(body);
    state.events.contactsBegun.push_back({state.bodies[c.bodyA].id, state.bodies[c.bodyB].id,
                                          placeOf(state, c), c.normal,
                                          std::max<Real>(c.approach, 0), t.impulse});
}

void tellPersisted(State& state, const FoundTouch& t) {
    const Contact& c = state.contacts[t.strongest];
    state.events.contactsPersisted.push_back({state.bodies[c.bodyA].id, state.bodies[c.bodyB].id,
                                              placeOf(state, c), c.normal, t.impulse});
}

/// Whether physics moves neither of two bodies, so that what touched still touches.
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
    thread_local Touches scratch;
    thread_local std::vector<BodyPair> now;
    Touches& touches = scratch;
    if (state.contacts.empty() && state.touchingFrozen && !state.structure.stale) return;
    touches.collect(state);
    if (!touches.any && state.touchingFrozen && !state.structure.stale) return;
    state.touchingFrozen = !touches.any;
    now.reserve(state.touching.size());  // likewise
    // What began in an earlier step of the tick goes on to push: mergeSteps() adds that up.
    const bool tellsPersisting =
        state.settings.tellPersisting || !state.events.contactsBegun.empty();
    if (touches.same) {
        if (tellsPersisting)
            for (const FoundTouch& touch : touches.old) tellPersisted(state, touch);
        return;
    }
    now.clear();
    // Both lists are sorted: one walk along both keeps the order.
    auto begun = touches.begun.cbegin();
    const auto beginUntil = [&](const BodyPair* next) {
        for (; begun != touches.begun.cend() && (!next || begun->pair < *next); ++begun) {
            now.push_back(begun->pair);
            tellBegun(state, begun->touch);
        }
    };
    for (std::size_t k = 0; k < state.touching.size(); ++k) {
        const BodyPair& pair = state.touching[k];
        const FoundTouch& touch = touches.old[k];
        beginUntil(&pair);
        if (touch.strongest == none && !isFrozen(state, pair)) {
            state.events.contactsEnded.push_back({pair.a, pair.b});
            continue;
        }
        now.push_back(pair);
        if (touch.strongest != none && tellsPersisting) tellPersisted(state, touch);
    }
    beginUntil(nullptr);
    std::swap(state.touching, now);
}

}  // namespace sulfur::detail
