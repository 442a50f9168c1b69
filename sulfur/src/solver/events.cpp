// After the stages: which bodies began to touch.
#include <algorithm>

#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

/// Slots, not dense indices: they stay the same when other bodies go.
std::uint64_t pairOf(const State& state, const Contact& c) {
    const auto a = state.bodies[c.bodyA].id.index, b = state.bodies[c.bodyB].id.index;
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

}  // namespace

void collectEvents(State& state) {
    auto& begun = state.events.contactsBegun;
    begun.clear();
    auto& now = state.touchingNow;
    auto& reported = state.touchingReported;
    now.clear();
    reported.clear();
    for (const Contact& c : state.contacts) {
        if (c.normalLambda <= 0) continue;
        const auto pair = pairOf(state, c);
        now.push_back(pair);
        if (std::binary_search(state.touching.begin(), state.touching.end(), pair)) continue;
        if (std::find(reported.begin(), reported.end(), pair) != reported.end()) continue;
        reported.push_back(pair);
        begun.push_back({state.bodies[c.bodyA].id, state.bodies[c.bodyB].id,
                         state.particles.position[c.particle], c.normal,
                         std::max<Real>(c.approach, 0)});
    }
    std::sort(now.begin(), now.end());
    now.erase(std::unique(now.begin(), now.end()), now.end());
    std::swap(state.touching, now);
}

}  // namespace sulfur::detail
