// Which material a surface is of.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// The surface that a contact's particle or capsule shows: its joint's own, or its body's.
const Material& surfaceOf(const State& state, std::uint32_t joint, std::uint32_t body);

}  // namespace sulfur::detail
