// The contacts that the steps of a tick have told, told as those of one tick.
#include <algorithm>
#include <utility>

#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

template <class Event>
BodyPair pairOf(const Event& e) {
    return BodyPair::of(e.a, e.b);
}

/// Leaves one event of each pair, in the order of pairs. `add` gives an event what a later step
/// told of the same pair. (A stable sort would take memory.)
template <class Event, class Add>
void joinPairs(std::vector<Event>& events, Add&& add) {
    thread_local std::vector<std::pair<BodyPair, std::size_t>> order;
    thread_local std::vector<Event> joined;
    order.clear();
    joined.clear();
    for (const Event& e : events) order.emplace_back(pairOf(e), order.size());
    std::sort(order.begin(), order.end());
    for (const auto& [pair, i] : order) {
        if (!joined.empty() && pairOf(joined.back()) == pair)
            add(joined.back(), events[i]);
        else
            joined.push_back(events[i]);
    }
    std::swap(events, joined);
}

}  // namespace

void mergeSteps(State& state) {
    auto& begun = state.events.contactsBegun;
    auto& persisted = state.events.contactsPersisted;
    auto& ended = state.events.contactsEnded;
    const auto touched = [&](const auto& e) {
        return std::binary_search(state.touchedBefore.begin(), state.touchedBefore.end(),
                                  pairOf(e));
    };
    const auto touches = [&](const auto& e) {
        return std::binary_search(state.touching.begin(), state.touching.end(), pairOf(e));
    };
    const auto isGone = [&](const auto& e) {
        return !state.bodySlots.contains(e.a) || !state.bodySlots.contains(e.b);
    };
    // Who touched before the tick goes on touching. All others begin, with all that they push.
    for (const ContactBegun& e : begun)
        if (touched(e)) persisted.push_back({e.a, e.b, e.point, e.normal, e.impulse});
    std::erase_if(begun, [&](const auto& e) { return touched(e) || isGone(e); });
    for (const ContactPersisted& e : persisted)
        if (!touched(e) && !isGone(e)) begun.push_back({e.a, e.b, e.point, e.normal, 0, e.impulse});
    std::erase_if(persisted, [&](const auto& e) { return !touched(e) || !touches(e); });
    // Who touches now has not ended. Who came and is gone has never been told of.
    std::erase_if(ended, [&](const auto& e) { return touches(e) || (!touched(e) && isGone(e)); });
    joinPairs(begun, [](auto& first, const auto& next) { first.impulse += next.impulse; });
    joinPairs(persisted, [](auto& sum, const auto& next) {
        const Real before = sum.impulse;
        sum = next;
        sum.impulse += before;
    });
    joinPairs(ended, [](auto&, const auto&) {});
    if (!state.settings.tellPersisting) persisted.clear();
}

}  // namespace sulfur::detail
