// Finding the rigid components of bodies.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Finds the rigid components of all bodies whose `clustersStale` is set, keeps those of the
/// others, and marks the joints that need no solving because they are inside one. Where bodies were
/// added to what was there `before`, and nothing else changed, only theirs are looked for.
void updateClusters(State& state, const Counts& before);

/// Whether a body was too strained to have its rigid components found, and no longer is.
bool strainIsGone(const State& state, std::uint32_t body);

/// Inverse masses of a body's clusters, as it is awake or asleep.
void restoreClusterMasses(State& state, std::uint32_t body);

/// The body's clusters take their motion from its particles' velocities again.
void stirClusters(State& state, std::uint32_t particle);

}  // namespace sulfur::detail
