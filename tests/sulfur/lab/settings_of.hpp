// All settings in which the engines that were found play a scene.
#pragma once

#include <vector>

#include "bench/scenes.hpp"

namespace sulfur::lab::bench {

inline std::vector<Setting> settingsOf(const Scene& scene) {
    std::vector<Setting> all;
    for (const Engine& engine : engines())
        if (engine.found())
            for (const Setting& setting : settingsFor(engine, scene)) all.push_back(setting);
    return all;
}

}  // namespace sulfur::lab::bench
