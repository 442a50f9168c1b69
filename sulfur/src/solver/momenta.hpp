// What bodies do to each other changes neither their momentum nor their angular momentum.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Notes where particles that move by themselves are before constraints push them.
void notePlaces(State& state);

/// Calls `takeUp`, by which velocities take up what constraints have changed of displacements.
///
/// Rows, joints and trees keep both momenta as far as impulses act at one point. But places are
/// moved without a velocity, where things overlap or would pass through each other, and constraints
/// act where they are right to first order. What that has changed of a group of bodies that push
/// nothing else is given back by moving the group as one rigid body, which disturbs no contact and
/// no joint. Where this would add to its energy, all motion within the group becomes slower by as
/// much. (Dinev et al. 2018, "FEPR", project on the same invariants.)
void keepMomenta(State& state, void (*takeUp)(State& state));

}  // namespace sulfur::detail
