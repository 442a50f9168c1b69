// Into how many steps a tick is divided.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

/// Worlds of fewer ticks a second than the library is tuned for stay accurate because their ticks
/// are divided when something asks for it: what can touch and moves by more than a tenth of
/// its radius in a tick, contacts that slide, rebound or that the solver has left with an error,
/// what stands on something that can move itself, what was just put somewhere, networks of springs
/// that are too stiff to be forces for a whole tick. A while after the last of it, each tick is one
/// step again. Decided before each tick, from the state alone, with lists that are up to date; sets
/// h, and what the solver remembers follows.
void chooseSubsteps(State& state);

/// s, of a tick that is not divided.
Real tickDuration(const State& state);

/// Whether the world has so few ticks a second that it may divide them.
bool mayDivideTicks(const State& state);

/// After the contacts of a step are solved: notes what asks for short steps.
void noteStrain(State& state, bool leftError);

/// Changes the duration of steps. Multipliers, which are forces times its square, follow.
void setStep(State& state, Real h);

}  // namespace sulfur::detail
