// The kinds of constraints that solveConstraints() sweeps over.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Lists the movers that any of these kinds, triangles, grabs or trees hold in this step.
void listTied(State& state);
void clearMultipliers(State& state);
void solveImplicitJoints(State& state);
void solveAttachments(State& state);
void solveRigidJoints(State& state);
/// The forces that the multipliers stand for: lambda / h^2.
void recordForces(State& state);

}  // namespace sulfur::detail
