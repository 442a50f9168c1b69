// The kinds of constraints that solveConstraints() sweeps over.
#pragma once

#include "world/state.hpp"

namespace sulfur::detail {

void clearMultipliers(State& state);
void solveImplicitJoints(State& state);
/// Gives contacts the multipliers that they pushed with in the last tick, so that a stack does not
/// have to be found anew in every tick.
void warmStartContacts(State& state);
/// Takes down what the next tick begins with.
void finishContacts(State& state);
/// Some contacts, by their places in the list, one after the other.
void solveContacts(State& state, const std::vector<std::uint32_t>& which, bool backwards);
/// Pushes with the multipliers that the contact has.
void pushWithMultipliers(State& state, const Contact& contact);
/// What overlapped before the tick is led apart by moving positions, not displacements, so that
/// it leaves no velocity behind and nothing is thrown. applyRecovery() does the move.
void solveRecovery(State& state, const std::vector<std::uint32_t>& which);
/// The same for what friction holds and has crept from its place: once in a tick, so that it never
/// works against the former.
void recoverDrifts(State& state, const std::vector<std::uint32_t>& which);
/// After the last sweep: nothing that joints pushed may be past the surface that it touches.
void guardContacts(State& state);
void solveAttachments(State& state);
void solveRigidJoints(State& state);
/// Whether sweeps leave a rigid joint of a body that touches something too far from its length.
bool touchedRigidJointsAreStrained(const State& state);
/// The forces that the multipliers stand for: lambda / h^2.
void recordForces(State& state);

}  // namespace sulfur::detail
