// Finding the rigid components of bodies.
#pragma once

#include <vector>

#include "model/state.hpp"

namespace sulfur::detail {

/// Finds the rigid components of all bodies whose `clustersStale` is set, keeps those of the
/// others, and marks the joints that need no solving because they are inside one. Where bodies were
/// added to what was there `before`, and nothing else changed, only theirs are looked for.
void updateClusters(State& state, const Counts& before);

/// A body of a single particle that is no disc any more keeps how it was turned.
void keepTurn(BodyRecord& body, const Cluster& cluster);

/// The particles of a body that turn by themselves, or will from the next tick on.
std::vector<std::uint32_t> discsOf(const State& state, std::uint32_t body);

/// Whether a body was too strained to have its rigid components found, and no longer is.
bool strainIsGone(const State& state, std::uint32_t body);

/// Inverse masses of a body's clusters, as it is awake or asleep.
void restoreClusterMasses(State& state, std::uint32_t body);

/// The body's clusters take their motion from its particles' velocities again.
void stirClusters(State& state, std::uint32_t particle);

}  // namespace sulfur::detail
