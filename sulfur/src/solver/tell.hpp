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

/// Whether a step tells that a pair goes on touching: on request, and where it began in an earlier
/// step of the tick, whose push it goes on with.
bool tellsPersisting(const State& state, const BodyPair& pair);

}  // namespace sulfur::detail
