// Force fields, as the stage that applies them and the wake rule see them.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Whether a field acts on any particle of a body, awake or not.
bool actsOn(const State& state, const Field& field, std::uint32_t body);

}  // namespace sulfur::detail
