// From bodies to what collides of them.
#pragma once

#include <cstdint>

namespace sulfur::detail {

struct State;

/// Makes chunks and movers of a body (dense index) that has none. Needs rigid components that are
/// up to date.
void makeShape(State& state, std::uint32_t body);
/// The shape of a body, by its slot, is made anew before the next step.
void shapeIsStale(State& state, std::uint32_t bodySlot);
/// Takes away chunks and movers of a body by its slot; they must be in no pair and no grid.
void dropShape(State& state, std::uint32_t bodySlot);
/// It can then be done without taking memory.
void makeRoomToDrop(State& state, std::uint32_t bodySlot);

}  // namespace sulfur::detail
