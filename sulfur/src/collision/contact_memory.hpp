// What contacts leave for their successors in the next tick.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/contact.hpp"

namespace sulfur::detail {

struct State;

/// Finds out where the memories of each particle begin, for recall().
void indexMemory(State& state);

/// What the contact of these particles was in the last tick; where there was none, one of the same
/// particle with a capsule that shares an end, over whose seam it may have come; or null.
const ContactMemory* recall(const State& state, std::uint32_t particle, std::uint32_t a,
                            std::uint32_t b);

/// Takes down the contacts of this tick, and keeps those of sleepers.
void rememberContacts(State& state);

}  // namespace sulfur::detail
