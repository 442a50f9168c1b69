// Makes a way quicker by leaving out and varying what is done on it.
#pragma once

#include "search.hpp"

namespace quaoar {

/// Tries changes of one step at a time for so many simulated seconds and keeps each with which the
/// rest of the way still finishes, and sooner. The same way if none is found.
Way shortened(Session& session, const Way& way, std::uint64_t seed, double budget);

}  // namespace quaoar
