// What contacts leave for their successors in the next tick.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/contact.hpp"

namespace sulfur::detail {

struct State;

/// What the contact of these particles was in the last tick; where there was none, one of the same
/// particle with a capsule that shares an end, over whose seam it may have come. `memory` is
/// sorted by particle.
const ContactMemory* recall(const std::vector<ContactMemory>& memory, std::uint32_t particle,
                            std::uint32_t a, std::uint32_t b);

/// Takes down the contacts of this tick, and keeps those of sleepers.
void rememberContacts(State& state);

}  // namespace sulfur::detail
