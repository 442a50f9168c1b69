#include "solver/tell.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace sulfur::detail {

namespace {

template <class Event>
void append(std::vector<Event>& events, const std::vector<Event>& more) {
    events.insert(events.end(), more.begin(), more.end());
}

/// Who touched in an earlier step of the tick may be gone since.
template <class Event>
void dropGone(const State& state, std::vector<Event>& events) {
    const auto exists = [&](BodyId id) { return state.bodySlots.contains(id); };
    std::erase_if(events, [&](const Event& e) { return !exists(e.a) || !exists(e.b); });
}

/// In the order of pairs, those of one pair in the order in which they were told. (A stable sort
/// would take memory.)
template <class Event>
void orderPairs(std::vector<Event>& events) {
    thread_local std::vector<std::pair<BodyPair, std::uint32_t>> order;
    thread_local std::vector<Event> ordered;
    order.clear();
    ordered.clear();
    for (const Event& e : events)
        order.emplace_back(BodyPair::of(e.a, e.b), static_cast<std::uint32_t>(order.size()));
    std::sort(order.begin(), order.end());
    for (const auto& [pair, i] : order) ordered.push_back(events[i]);
    std::swap(events, ordered);
}

template <class Event>
bool comesBefore(const Event& e, const BodyPair& pair) {
    return BodyPair::of(e.a, e.b) < pair;
}

/// The events of a pair in an ordered list.
template <class Event>
std::span<Event> eventsOf(std::vector<Event>& events, const BodyPair& pair) {
    const auto first = std::lower_bound(events.begin(), events.end(), pair, comesBefore<Event>);
    auto last = first;
    while (last != events.end() && BodyPair::of(last->a, last->b) == pair) ++last;
    return {first, last};
}

bool touches(const State& state, const BodyPair& pair) {
    return std::binary_search(state.touching.begin(), state.touching.end(), pair);
}

/// How often pairs began to touch less how often they parted tells from how they are now how they
/// were at the start of the tick. Who touched then has not begun, who touches now has not ended.
/// Who did neither has met and parted within the tick, and both is told.
void tellNet(State& state) {
    auto& begun = state.events.contactsBegun;
    auto& ended = state.events.contactsEnded;
    const auto touchedBefore = [&](const BodyPair& pair) {
        const auto began = std::ssize(eventsOf(begun, pair));
        const auto parted = std::ssize(eventsOf(ended, pair));
        return (touches(state, pair) ? 1 : 0) - began + parted > 0;
    };
    thread_local std::vector<ContactBegun> keptBegun;
    keptBegun.clear();
    for (std::size_t i = 0; i < begun.size(); ++i) {
        const BodyPair pair = BodyPair::of(begun[i].a, begun[i].b);
        const bool first = i == 0 || BodyPair::of(begun[i - 1].a, begun[i - 1].b) != pair;
        if (first && !touchedBefore(pair)) keptBegun.push_back(begun[i]);
    }
    const auto partsWithin = [&](const ContactEnded& e) {
        return touches(state, BodyPair::of(e.a, e.b));
    };
    std::erase_if(ended, partsWithin);
    const auto samePair = [](const ContactEnded& p, const ContactEnded& q) {
        return BodyPair::of(p.a, p.b) == BodyPair::of(q.a, q.b);
    };
    ended.erase(std::unique(ended.begin(), ended.end(), samePair), ended.end());
    std::swap(begun, keptBegun);
}

/// Each pair that still touches once, with the last place and all that was pushed in the tick. To
/// who began to touch in it the rest of the push is added there.
void tellPersisting(State& state) {
    auto& begun = state.events.contactsBegun;
    auto& persisted = state.events.contactsPersisted;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < persisted.size();) {
        const BodyPair pair = BodyPair::of(persisted[i].a, persisted[i].b);
        Real impulse = 0;
        std::size_t next = i;
        for (;
             next < persisted.size() && BodyPair::of(persisted[next].a, persisted[next].b) == pair;
             ++next)
            impulse += persisted[next].impulse;
        if (const auto beginning = eventsOf(begun, pair); !beginning.empty()) {
            beginning.front().impulse += impulse;
        } else if (touches(state, pair)) {
            persisted[kept] = persisted[next - 1];
            persisted[kept++].impulse = impulse;
        }
        i = next;
    }
    persisted.resize(state.settings.tellPersisting ? kept : 0);
}

}  // namespace

void clear(Events& events) {
    events.contactsBegun.clear();
    events.contactsPersisted.clear();
    events.contactsEnded.clear();
    events.jointsBroken.clear();
    events.bodiesSplit.clear();
    events.particlesLost.clear();
    events.sensorsEntered.clear();
    events.sensorsLeft.clear();
}

void startTelling(State& state) {
    clear(state.told);
}

void tellStep(State& state) {
    Events& told = state.told;
    const Events& more = state.events;
    append(told.contactsBegun, more.contactsBegun);
    append(told.contactsPersisted, more.contactsPersisted);
    append(told.contactsEnded, more.contactsEnded);
    append(told.jointsBroken, more.jointsBroken);
    append(told.bodiesSplit, more.bodiesSplit);
    append(told.particlesLost, more.particlesLost);
    append(told.sensorsEntered, more.sensorsEntered);
    append(told.sensorsLeft, more.sensorsLeft);
}

void tellTick(State& state) {
    Events& events = state.events;
    std::swap(events, state.told);
    dropGone(state, events.contactsBegun);
    dropGone(state, events.contactsPersisted);
    orderPairs(events.contactsBegun);
    orderPairs(events.contactsPersisted);
    orderPairs(events.contactsEnded);
    tellNet(state);
    tellPersisting(state);
}

bool tellsPersisting(const State& state, const BodyPair& pair) {
    if (state.settings.tellPersisting) return true;
    const auto& begun = state.told.contactsBegun;
    return state.steps.done > 0 &&
           std::any_of(begun.begin(), begun.end(),
                       [&](const ContactBegun& e) { return BodyPair::of(e.a, e.b) == pair; });
}

}  // namespace sulfur::detail
