// Scenes in sweeps over places.
#pragma once

#include <memory>

#include "accuracy/subjects.hpp"

namespace sulfur::lab {

/// Whether nothing but rigid joints or pins holds a scene.
bool canBeSwept(const AccuracyScene& scene);
/// Such a scene under XPBD (see PositionSweeps).
std::unique_ptr<Run> makeSweptRun(const AccuracyScene& scene, int rate, int sweeps);

}  // namespace sulfur::lab
