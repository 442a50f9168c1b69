// The stages of a tick, in the order in which step() calls them. Each lives in a file of its own
// name; those of contact are in contacts/stages.hpp.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

/// Derives how what is stiff is solved again, if bodies or joints have changed.
void updateStructure(State& state);
/// Rebuilds what is derived from bodies and joints, if they changed.
void applyChanges(State& state);
/// Gathers the forces of explicit elastic joints into Particles::force.
void gatherForces(State& state);
/// Adds what force fields do to Particles::force.
void applyFields(State& state);
/// v += h (g + w f), air friction, d = h v.
void predict(State& state);
/// Velocities from displacements, and the move itself.
void updateVelocities(State& state);
/// Cuts joints that were loaded beyond their strength.
void breakJoints(State& state);
/// Finds out who is in which sensor, and who came and went.
void updateSensors(State& state);

/// Makes a body take part again, with all that fell asleep with it or leans on it, or lets it rest,
/// at once.
void wakeBody(State& state, std::uint32_t body);
/// Wakes a body that goes away or leaves its place, and what is near or tied to it.
void wakeTouching(State& state, std::uint32_t body);
/// Wakes the sleepers that a body may have come to overlap: those whose bounding boxes meet its
/// own. Linear in the particles of the sleepers.
void wakeNear(State& state, std::uint32_t body);
void sleepBody(State& state, std::uint32_t body);
/// Joins the rings of two sleepers, so that they wake together.
void joinSleepers(State& state, std::uint32_t a, std::uint32_t b);

/// One tick.
void step(State& state);

}  // namespace sulfur::detail
