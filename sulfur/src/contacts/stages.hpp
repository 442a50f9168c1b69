// The stages of contact: from the motion that forces alone predict to the one that contacts allow.
#pragma once

#include <cstdint>

namespace sulfur::detail {

struct State;

/// Shapes, pairs and lists follow bodies that were made, changed, fell asleep or woke.
void updateShapes(State& state);
/// Solver bodies take up the predicted motion, and what rows gave in the last step.
void takeMotion(State& state);
/// Boxes that something leaves in this step are made anew, with their pairs.
void updateBoxes(State& state);
/// Pairs that may have come to touch are looked at; rows are made, changed and taken away.
void lookAtPairs(State& state);
/// Rows take up how their bodies have moved and turned.
void refreshRows(State& state);
/// All rows are swept, `last`: places too.
void sweepRows(State& state, bool last);
/// Bodies take up what the rows have given.
void giveMotion(State& state);

/// Takes away pairs, rows and chunks of a body, by its slot; impulses are kept for heirs.
void removeShape(State& state, std::uint32_t bodySlot);
/// The shape of a body, by its slot, is made anew before the next step.
void shapeIsStale(State& state, std::uint32_t bodySlot);

}  // namespace sulfur::detail
