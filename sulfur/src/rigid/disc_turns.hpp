// How the caller turns discs: at once where one is known, else when the next tick has found it.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// rad/s, of a disc, also one that the next tick finds.
double spinOf(const State& state, std::uint32_t particle);
/// As far as its rim stays below the limit of speed. For one that is not found yet room for it must
/// be in State::discTurns, as for a torque.
void setSpin(State& state, std::uint32_t particle, double spin);
void addTorque(State& state, std::uint32_t particle, double torque);

/// N m of the caller on a disc in this step, as far as its rim stays below the limit of speed.
double torqueOn(const State& state, const Cluster& disc);
/// Discs that have been found take the spins that they are to have.
void takeSpins(State& state);

}  // namespace sulfur::detail
