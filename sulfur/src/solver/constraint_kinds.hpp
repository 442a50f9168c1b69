// The kinds of constraints that solveConstraints() sweeps over.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Lists the movers that any of these kinds, triangles, grabs or trees hold in this step.
void listTied(State& state);
/// Of these only what trees and networks hold, and what touches them.
void listTiedToTrees(State& state);
void clearMultipliers(State& state);
/// Of angular joints, how those that are constraints are solved: anew with the lists.
void groupAngles(State& state);
/// When the constraints begin; in each sweep; at the end.
void startAngles(State& state);
void solveAngles(State& state);
void recordAngles(State& state);
void solveImplicitJoints(State& state);
void solveAttachments(State& state);
void solveRigidJoints(State& state);
/// The forces that the multipliers stand for: lambda / h^2.
void recordForces(State& state);

}  // namespace sulfur::detail
