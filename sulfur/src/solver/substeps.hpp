// Whose ticks are divided into short steps.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

class ContactRows;

/// Worlds of fewer ticks a second than the library is tuned for stay accurate because the ticks of
/// a body are divided when it asks for it: what can touch and moves by more than a tenth of its
/// radius in a tick, contacts that slide, rebound or that the solver has left with an error, what
/// stands on something that can move itself, what was just put somewhere, networks of springs that
/// are too stiff to be forces for a whole tick. With it go all that it is tied to, touches, or may
/// come to touch in the tick: its island. A while after the last of it, each tick is one step
/// again. Decided before each tick, from the state alone, with lists that are up to date;
/// `changed`: the caller has changed bodies or joints since the last one.
void choosePaces(State& state, bool changed);

/// Whether the world has so few ticks a second that it may divide them.
bool mayDivideTicks(const State& state);

/// How many steps a tick has.
std::uint32_t stepsPerTick(const State& state, Pace pace);
/// s, of one of them.
Real stepDuration(const State& state, Pace pace);
inline Real stepDuration(const State& state, std::uint32_t body) {
    return stepDuration(state, state.bodies[body].divided ? Pace::divided : Pace::whole);
}

/// After the contacts of a step are solved: notes which bodies ask for short steps.
void noteStrain(State& state, const ContactRows& rows);

/// Gives a body a pace, and lets what follows from it follow.
void setDivided(State& state, std::uint32_t body, bool divided);

}  // namespace sulfur::detail
