// What the broad phase costs in whole worlds: of any extent, and of very different sizes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace sulfur {
class World;
}

namespace sulfur::lab {

struct WorldCase {
    std::string key, title;
    std::function<void(World&)> build;
};

struct WorldResult {
    std::string key, title;
    std::uint32_t bodies = 0;
    std::uint32_t candidates = 0;  ///< pairs that are near each other, after the last tick
    double boxes = 0;              ///< drawn anew, a tick
    int ticks = 0, rebuilds = 0;
    double rebuild = 0;  ///< s, the median of ticks that drew boxes anew; 0: none
    double kept = 0;     ///< s, the median of the others; 0: none
};

/// Equal heaps that are nearer and farther apart, then grains alone and with things that are up
/// to 50,000 times larger. `grains` is how many.
std::vector<WorldCase> broadPhaseWorlds(int grains);

/// Steps it and takes the times of the broad phase's stage.
WorldResult measureWorld(const WorldCase& world, int ticks);

}  // namespace sulfur::lab
