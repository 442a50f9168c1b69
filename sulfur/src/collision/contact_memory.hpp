// What contacts leave for their successors in the next tick.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/contact.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

/// Finds out where the memories of each particle begin, for recall().
void indexMemory(State& state);

/// What the contact of these particles was in the last tick; where there was none, one of the same
/// particle with a capsule that shares an end, over whose seam it may have come; or null.
inline const ContactMemory* recall(const State& state, std::uint32_t particle, std::uint32_t a,
                                   std::uint32_t b) {
    if (state.contactMemory.empty()) return nullptr;
    const ContactMemory* neighbour = nullptr;
    for (auto k = state.memoryStart[particle]; k < state.memoryStart[particle + 1]; ++k) {
        const ContactMemory& m = state.contactMemory[k];
        if (m.a == a && m.b == b) return &m;
        const bool shares = m.a == a || m.a == b || m.b == a || m.b == b;
        if (shares && !neighbour) neighbour = &m;
    }
    return neighbour;
}

/// Takes down the contacts of this tick, and keeps those of sleepers.
void rememberContacts(State& state);

}  // namespace sulfur::detail
