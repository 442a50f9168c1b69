// No impact gains energy.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

/// Contacts hold along directions of the tick's start. For what turns by half a radian or runs
/// through its own width within a tick, their pushes may do more work than they take, and springs
/// that four sweeps have not brought to rest may end up with more than the impact had.
///
/// These look at groups of bodies that fast contacts join. Where the motion of a group has more
/// energy than it would have had without contacts, the part of it that momentum and angular
/// momentum do not demand is scaled down until it has not.
///
/// After the displacements are found: finds the groups and limits their displacements.
void limitImpacts(State& state);

/// After rebounds: limits velocities in the groups that limitImpacts() found in this tick.
void limitRebounds(State& state);

}  // namespace sulfur::detail
