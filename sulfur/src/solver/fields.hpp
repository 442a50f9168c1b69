// Force fields, as the stage that applies them and the wake rule see them, and damping.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Whether a field acts on any particle of a body, awake or not.
bool actsOn(const State& state, const Field& field, std::uint32_t body);
/// Adds to Particles::force what slows down bodies that are damped, and brakes their discs. Comes
/// last: it asks for all other forces.
void dampBodies(State& state);

}  // namespace sulfur::detail
