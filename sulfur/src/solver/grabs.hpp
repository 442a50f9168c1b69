// Grabs, as the constraint stage sees them.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Whether all that a grab holds is still there.
bool holds(const State& state, const Grab& grab);

/// Before the sweeps: forgets what was removed, and the forces of the last tick.
void startGrabs(State& state);
/// One sweep.
void solveGrabs(State& state);

}  // namespace sulfur::detail
