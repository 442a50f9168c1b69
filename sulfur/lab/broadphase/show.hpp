// What the experiment `broadphase` found, in every form.
#pragma once

#include <string>
#include <vector>

#include "broadphase/methods.hpp"
#include "broadphase/worlds.hpp"

namespace sulfur::lab {

struct BroadPhaseResults {
    std::vector<CaseResult> cases;
    std::vector<WorldResult> worlds;
    int repeats = 0;
};

std::string asText(const BroadPhaseResults& results);
std::string asCsv(const BroadPhaseResults& results);
std::string asJson(const BroadPhaseResults& results);
/// Share of the touching pairs that the literal line misses, over thickness.
std::string missesAsSvg(const BroadPhaseResults& results);
/// Time per capsule of all methods, over length, at the smallest thickness.
std::string timesAsSvg(const BroadPhaseResults& results);

}  // namespace sulfur::lab
