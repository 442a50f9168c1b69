// What sensors feel.
#pragma once

#include <compare>
#include <cstdint>
#include <sulfur/ids.hpp>
#include <vector>

namespace sulfur::detail {

/// A body in a sensor.
struct Visit {
    BodyId sensor = {}, visitor = {};

    friend auto operator<=>(const Visit&, const Visit&) = default;
};

struct Sensing {
    std::vector<std::uint32_t> bodies;  // sensors, dense indices; derived with the shapes
    std::vector<Visit> visits;          // after the last tick, sorted
    // Something was made or moved by hand, so that what is still has to be looked at too.
    bool anew = true;
    bool left = false;  // somebody was removed, who may have been in a sensor

    // Scratch of a tick.
    std::vector<Visit> now;
    std::vector<std::uint32_t> inside;  // one sensor; bodies, dense indices
    std::size_t looks = 0;
};

}  // namespace sulfur::detail
