// Finding the rigid components of bodies.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

/// Finds the rigid components of all bodies whose `clustersStale` is set, keeps those of the
/// others, and marks the joints that need no solving because they are inside one.
void updateClusters(State& state);

/// Whether a body was too strained to have its rigid components found, and no longer is.
bool strainIsGone(const State& state, std::uint32_t body);

/// Inverse masses of a body's clusters, as it is awake or asleep.
void restoreClusterMasses(State& state, std::uint32_t body);

/// The body's clusters take their motion from its particles' velocities again.
void stirClusters(State& state, std::uint32_t particle);

}  // namespace sulfur::detail
