// Finding the triangles of soft bodies.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Finds the triangles of joints in dynamic bodies that have not been looked at, but for those that
/// are flat at rest or rigid, and braces their springs. A body with more than four triangles a
/// joint is no lattice (everything hangs on everything there) and has none.
void findTriangles(State& state);
/// What was found is of other particles, joints or rigid components than there are now.
void forgetTriangles(State& state);

/// Derives which of them are awake, and no part of a tree that moves alone.
void listTriangles(State& state);

}  // namespace sulfur::detail
