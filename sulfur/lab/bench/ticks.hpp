// What a tick of ours takes, for the experiments `scaling` and `skip`.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <sulfur/sulfur.hpp>
#include <vector>

#include "bench/spread.hpp"

namespace sulfur::lab::bench {

struct TickOptions {
    int warmUp = 50;  ///< ticks before the clock starts
    int ticks = 50;   ///< in one measurement
    int repeats = 5;  ///< measurements, of which the median counts
};

/// Seconds of processor time for a tick of `world`; or on the wall, where threads take part.
Spread tickTime(World& world, const TickOptions& options, bool onWall = false);

/// Something that can grow, and a world of each size.
struct Growth {
    std::string key;    ///< "bodies"
    std::string title;  ///< what grows, with its unit
    std::vector<double> sizes;
    std::function<std::unique_ptr<World>(double size)> make;
    bool threads = false;  ///< the sizes are threads: to be measured on the wall, on all cores
};
/// Bodies, joints, contacts, the share that is awake, sleepers alone, the extent of the world, and
/// threads where there are any.
std::vector<Growth> growths(bool quick);

/// Something that can be on or off.
struct Option {
    std::string name;   ///< "friction"
    std::string scene;  ///< where it is switched on, for people
    std::function<std::unique_ptr<World>(bool on)> make;
};
std::vector<Option> options(int bodies);

}  // namespace sulfur::lab::bench
