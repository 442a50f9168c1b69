// What is tied together in loops, with a load that may weigh a million times what holds it.
#pragma once

#include "accuracy/scene.hpp"

namespace sulfur::lab {

/// A net of rigid joints, hung by two corners that are nearer to each other than it is wide. Its
/// rows hang as a V, taut by the load in the middle, its columns lean: let go, it swings for 1 s.
/// All its meshes are parallelograms and remain so, because none of them closes: that is the
/// reference's linkage.
AccuracyScene swingingNet(const SceneOptions& options);

/// The same net with vertical columns, and the load in the middle of its lower edge, where
/// something that moves sideways at 2 m/s has just been caught: joints are rigid, and the net moves
/// with it.
AccuracyScene strickenCloth(const SceneOptions& options);

/// Squares of 1 m and 1 kg, turned by 15 degrees one way and the other, each pinned by its corners
/// to those of its four neighbours, and the two upper corners of all of them to fixed ones: that
/// is rigid, so that nothing moves. The square in the middle bears the load.
AccuracyScene pinnedGrid(const SceneOptions& options);

}  // namespace sulfur::lab
