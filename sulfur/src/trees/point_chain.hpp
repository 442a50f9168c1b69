// The fast path for a rope: a chain of points, joint after joint.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Leads a chain (Tree::chain) through the tick as TreeStepper would, some times faster, and clears
/// the forces on its particles. Returns false, with the particles and joints as they were, where
/// the chain needs what only TreeStepper can do: its fallback, links without length, numbers that
/// are no longer finite. Tree::steps then says how many steps to begin with.
bool stepChain(State& state, Tree& tree);

}  // namespace sulfur::detail
