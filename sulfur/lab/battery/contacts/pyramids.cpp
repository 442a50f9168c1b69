// Pyramids of crates.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

/// Rows of crates of 1 m with gaps of 5 cm between neighbours, each crate over such a gap. The
/// last body is the top.
std::vector<Body> pyramid(World& world, int base) {
    constexpr double size = 1, pitch = 1.05;  // m
    addFloor(world, base + 10);
    std::vector<Body> bodies;
    for (int row = 0; row < base; ++row)
        for (int column = 0; column < base - row; ++column)
            bodies.push_back(world.add(crate({.size = size}),
                                       {.position = Point(pitch * (column - (base - row - 1) / 2.0),
                                                          size * (row + 0.5))}));
    return bodies;
}

Rows standing(int base, const Setup& setup) {
    World world(still(setup, standardGravity));
    const std::vector<Body> bodies = pyramid(world, base);
    const std::vector<Body> top{bodies.back()};
    const Places places(world, bodies), topPlace(world, top);
    const double seconds = setup.seconds(60, 10);
    double sunk = 0, sideways = 0;
    for (int i = 0; i < std::lround(seconds * 10); ++i) {
        run(world, 0.1);
        sunk = worst(sunk, topPlace.sunk());
        sideways = worst(sideways, places.sideways());
    }
    keepPicture(setup, fmt::format("pyramid{}", base), world);
    const std::string name = fmt::format("pyramid of base {}, {:g} s: ", base, seconds);
    const auto row = [&](const std::string& what, double measured, double bound) {
        return base == 40 ? atMost(name + what, measured, bound) : reported(name + what, measured);
    };
    return {atMost(name + "crates not at their places", places.moved(0.5), 0),
            row("top sinks (m)", sunk, 0.05), row("any crate sideways (m)", sideways, 0.01),
            reported(name + "overlap (share of a radius)", deepestOverlap(world).share)};
}

}  // namespace

Rows pyramids(const Setup& setup) {
    Rows rows;
    for (const int base : {10, 20, 40})
        for (Row& row : standing(base, setup)) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sulfur::lab
