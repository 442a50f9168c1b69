// How two surfaces that touch behave together.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

/// The surface that a contact's particle or capsule shows: its joint's own, or its body's.
const Material& surfaceOf(const State& state, std::uint32_t joint, std::uint32_t body);

/// Gives a contact's plan the constants that its two surfaces have together; see material.hpp.
void giveSurface(const State& state, ContactPlan& plan);

}  // namespace sulfur::detail
