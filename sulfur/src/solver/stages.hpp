// The stages of a tick, in the order in which step() calls them. Each lives in a file of its own
// name; those of contact are in contacts/stages.hpp.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Derives how what is stiff is solved again, if bodies or joints have changed.
void updateStructure(State& state);
/// Rebuilds what is derived from bodies and joints, if they changed.
void applyChanges(State& state);
/// Gathers the forces of explicit elastic joints into Particles::force, angular ones too.
void gatherForces(State& state);
/// The same of angular joints.
void gatherAngles(State& state);
/// Adds what force fields do to Particles::force.
void applyFields(State& state);
/// v += h (g + w f), air friction, d = h v.
void predict(State& state);
/// Displacements change until contacts and all that is swept beside them hold.
void solveConstraints(State& state);
/// Velocities from displacements, and the move itself.
void updateVelocities(State& state);
/// Cuts joints that were loaded beyond their strength.
void breakJoints(State& state);
/// Finds out who is in which sensor, and who came and went.
void updateSensors(State& state);

/// One tick.
void step(State& state);

}  // namespace sulfur::detail
