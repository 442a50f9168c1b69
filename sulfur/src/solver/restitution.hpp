// Rebounds.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

/// Slower impacts do not rebound, so that what lies comes to rest.
inline constexpr Real slowestRebound = Real(0.1);  // m/s

/// Whether the contact is elastic and closes too fast to come to rest.
inline bool mayRebound(const Contact& c) {
    return c.restitution > 0 && c.approach > slowestRebound;
}

/// Sees whether the contact closes within this tick fast enough to rebound, and if so, notes how
/// far apart its sides must be at the end of the tick and how fast they must part.
void planRebound(const State& state, Contact& c);

/// Gives rebounding contacts the velocities that were planned.
void rebound(State& state);

}  // namespace sulfur::detail
