// The battery: every scene that the library's dynamics must pass, with what it measures there
// beside what must hold.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "battery/row.hpp"

namespace sulfur::lab {

/// Scenes that belong together.
struct BatteryGroup {
    std::string key;  ///< for command lines
    std::string title;
    std::function<Rows(const Setup&)> run;
    bool onlyByName = false;  ///< whether a run of the whole battery leaves it out
};

/// All of them, with the lengths and bounds that the project asks for.
const std::vector<BatteryGroup>& batteryGroups();

}  // namespace sulfur::lab
