// Whom a blow moves.
#pragma once

#include <cstdint>

namespace sulfur::detail {

struct State;

/// Whether a mover is all of its body and tied to no other: then what strikes it moves it alone.
bool movesAlone(const State& state, std::uint32_t mover);

}  // namespace sulfur::detail
