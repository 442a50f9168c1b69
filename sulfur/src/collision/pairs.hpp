// What of the grid's neighbours may touch.
#pragma once

#include "kernels/outings.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

/// Finds the pairs of colliders, and from them the candidates, that can touch or cross before
/// anything leaves its skin. Needs the grids and skins of BroadPhase; fills `pairs`, `watches` and
/// their runs.
void findPairs(State& state);

/// The same for what has changed: `left` and `hasLeft` tell which pieces have been rasterised
/// again.
void renewPairs(State& state);

/// All candidates by the bodies of both sides.
const std::vector<WatchRun>& watchRuns(State& state);

/// For kernels, valid while particles stay where they are in their lists. `displacements`: m, by
/// particle.
OutingView outingsOf(const State& state, const std::vector<Vec2>& displacements);

/// Writes down how far everything awake is, with the given displacements (m, by particle), from
/// where it was rasterised. Sleepers are where they were: when a body falls asleep, everything is
/// rasterised again.
void measureOutings(const State& state, const std::vector<Vec2>& displacements, Outings& outings);

}  // namespace sulfur::detail
