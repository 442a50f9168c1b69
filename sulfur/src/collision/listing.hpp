// What collides, and what else the broad phase derives from bodies and joints.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

/// Lists the colliders and all that follows from bodies and joints alone.
void listAnew(State& state);

/// Takes in bodies that were added after all others since, and were all that changed: their pieces
/// are not drawn yet, what is already in the grids stays there, and so do pairs and candidates, in
/// the same order under new numbers. Returns false, and changes nothing, where that is not so, or
/// where what was added never moves.
bool listAdded(State& state);

}  // namespace sulfur::detail
