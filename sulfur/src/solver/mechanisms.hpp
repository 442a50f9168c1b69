// Mechanisms, as the stages of a step see them.
#pragma once

#include <vector>

#include "model/state.hpp"

namespace sulfur::detail {

/// When velocities are predicted: finds the rows of what is awake, and gives them the forces of the
/// last step to begin with.
void startMechanisms(State& state);
/// When the constraints begin: leaves the rows that act, with what they may do in this step.
void settleMechanisms(State& state);
/// Once trees are known to be pulled: how these answer the rows.
void answerMechanisms(State& state);
/// What holds a row: its coordinate plus `compliance` times this multiplier is to be `goal`.
RowHold holdOf(const MechanismRow& row);
/// One sweep.
void solveMechanisms(State& state);
/// After the sweeps: leads back what is beyond its limits, or not where it is held.
void leadMechanisms(State& state);
/// The forces that the multipliers stand for; what limits began and ceased to push.
void recordMechanisms(State& state);
/// Angular joints that are not driven and break: of those of a body that are loaded beyond their
/// strength the worst one.
std::vector<AngleId> breakingAngles(State& state);
/// Takes angular joints away, as far as they are there, with the rows that drive them.
void dropAngles(State& state, const std::vector<AngleId>& gone);
/// Removes what was loaded beyond its strength, and what holds nothing any more.
void breakMechanisms(State& state);
/// Removes what holds nothing any more.
void forgetMechanisms(State& state);
/// Removes a mechanism and what belongs to it alone: pins and a veto. Wakes both bodies.
void dropMechanism(State& state, std::uint32_t index);

}  // namespace sulfur::detail
