// The last resort against passing through.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

/// Where the displacements that the sweeps have left would still carry something fast through a
/// surface on the way, both bodies stop at the time of impact and lose the way that is left of the
/// tick, but no velocity. Contacts see to it in nearly all cases: this is for those that the first
/// prediction did not show, or that four sweeps did not finish.
void holdBack(State& state);

/// After velocities followed from displacements: gives back what they have lost by holdBack() of
/// this tick.
void keepVelocities(State& state);

}  // namespace sulfur::detail
