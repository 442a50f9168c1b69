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
    /// A collider of a visitor that may come into a sensor while the grid is valid.
    struct Near {
        std::uint32_t sensor = 0, visitor = 0;  // bodies, dense indices
        std::uint32_t collider = 0;             // number in the broad phase

        friend auto operator<=>(const Near&, const Near&) = default;
    };
    struct Part {
        std::uint32_t sensor = 0, collider = 0;

        friend auto operator<=>(const Part&, const Part&) = default;
    };

    std::vector<std::uint32_t> bodies;      // sensors, dense indices; derived with the colliders
    std::vector<Part> parts;                // the colliders of these, sorted
    std::vector<Near> near;                 // sorted
    std::uint64_t run = ~std::uint64_t{0};  // of the broad phase, for which they hold
    std::vector<Visit> visits;              // after the last tick, sorted
    std::vector<Visit> now;                 // scratch
    std::vector<std::uint32_t> around;      // scratch
};

}  // namespace sulfur::detail
