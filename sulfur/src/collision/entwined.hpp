// Bodies that were put into each other.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

/// Contacts keep things apart that come from outside. What the caller has put into each other has
/// no outside to be led back to: corners would leave through the nearest edges, in all directions.
/// Such a pair has no contacts until it is apart; meanwhile both bodies move as wholes, slowly and
/// without gaining velocity, along the shortest of the ways out that the edges of their outlines
/// offer (the separating axis test; exact for convex bodies), and do not close along it.
void partEntwined(State& state);

/// Whether two bodies, by dense indices, have no contacts because they are being parted.
bool isListedEntwined(const State& state, std::uint32_t a, std::uint32_t b);
inline bool areEntwined(const State& state, std::uint32_t a, std::uint32_t b) {
    return !state.entwined.empty() && isListedEntwined(state, a, b);
}

}  // namespace sulfur::detail
