// Triangles of soft bodies keep the side on which they are: a lattice of springs is as content
// with its mirror image as with its shape, and what a heap or a blow has pressed through itself
// would stay so.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Finds the triangles that the displacements so far press too flat.
void startAreas(State& state);
/// Displacements change until those have the area that they must have.
void solveAreas(State& state);
/// What was too flat or turned over already when the tick began is led back by moving positions,
/// not displacements, so that nothing is thrown.
void recoverAreas(State& state);

}  // namespace sulfur::detail
