// Running the steps of bodies whose ticks are whole and of those whose ticks are divided.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

/// From here on steps are those of bodies of this pace, and the others stand by: nothing moves
/// them, but what runs into them is stopped. Where all bodies have one pace, nobody stands by.
void enterPace(State& state, Pace pace);

/// Between ticks nobody stands by.
void leavePaces(State& state);

/// A body that wakes, which is still asleep, goes on with those that move.
void joinPace(State& state, std::uint32_t body);

/// After the lists of who takes part are made: notes who does not.
void noteStill(State& state);

/// Which bodies the lists of the present steps name.
ListedMovers wantedMovers(const State& state);

/// Before a tick: keeps what the caller applied to bodies whose ticks are divided, for all of their
/// steps; before each step but the first: applies it again.
void keepAppliedForces(State& state);
void applyForcesAgain(State& state);

/// Moves the velocities of bodies that have changed their pace in this tick to the time at which
/// those of their new pace stand; forces must be known.
void startLateParticles(State& state);

}  // namespace sulfur::detail
