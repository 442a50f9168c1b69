// Piles: processor time against overlap and against sinking.
#pragma once

#include <string>
#include <vector>

#include "accuracy/work_precision.hpp"

namespace sulfur::lab {

/// Scenes of `bench` whose error is compared: "S1", the mean overlap of dropped boxes, and "S2",
/// the sinking of a pyramid's top.
const std::vector<std::string>& pileKeys();

/// Runs a pile once in every setting: ours with 1, 2, 4 and 8 sweeps, Box2D 3 with as many substeps
/// and with contacts of several stiffnesses, Box2D 2.4 and Chipmunk, where they were found. `key`
/// must be one of pileKeys(). The cost is that of the whole scene. `quick` makes the pile small and
/// leaves rates out.
WorkPrecision measurePile(const std::string& key, bool quick);

}  // namespace sulfur::lab
