// Whether a proof holds in a process that has not searched for it.
#pragma once

#include <quaoar/recording.hpp>
#include <string>

namespace quaoar {

/// Starts this program again to replay the proof: nothing that the search left in memory can
/// help it. The disk sees no proof that has not been accepted.
bool acceptedByFreshProcess(const std::string& level, const Recording& proof);

}  // namespace quaoar
