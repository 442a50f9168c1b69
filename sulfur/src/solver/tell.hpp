// What the steps of a divided tick tell, told as that of one tick.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

void clear(Events& events);

/// Before the first step of a tick of several; after each; and after the last, which leaves the
/// tick's own events.
void startTelling(State& state);
void tellStep(State& state);
void tellTick(State& state);

/// Whether steps tell who goes on touching: in several steps, what they push is added up.
bool tellsPersisting(const State& state);

}  // namespace sulfur::detail
