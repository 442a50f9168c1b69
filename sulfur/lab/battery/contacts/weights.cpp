// The weight of piles, measured at the floor.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

/// N, the upward force of all contacts with `floor` in the last tick.
double carried(const World& world, BodyId floor) {
    double impulse = 0;
    for (const ContactInfo& c : world.contacts()) {
        const auto upward = static_cast<double>(c.normal.y()) * static_cast<double>(c.impulse);
        if (c.b == floor) impulse += upward;
        if (c.a == floor) impulse -= upward;
    }
    return impulse * world.settings().tickRate;
}

struct Part {
    Blueprint plan;
    Point place;
};

Row weigh(const std::string& what, const std::vector<Part>& parts, const Setup& setup) {
    World world(still(setup, standardGravity));
    const Body floor = addFloor(world, 20);
    std::vector<Body> bodies;
    double mass = 0;
    for (const Part& part : parts) {
        bodies.push_back(world.add(part.plan, {.position = part.place}));
        mass += static_cast<double>(world.mass(bodies.back()));
    }
    run(world, 5);
    double force = 0;
    for (int i = 0; i < setup.tickRate; ++i) {
        world.step();
        force += carried(world, floor);
    }
    keepPicture(setup, "weight-" + what, world);
    return atMost(
        fmt::format("weight of {} at the floor, {:g} kg, mean of 1 s: error (share)", what, mass),
        std::abs(force / setup.tickRate / (mass * standardGravity) - 1), 0.01);
}

std::vector<Part> stackOf(const std::vector<double>& masses) {
    std::vector<Part> parts;
    for (const double mass : masses)
        parts.push_back({crate({.mass = mass}), Point(0, static_cast<double>(parts.size()) + 0.5)});
    return parts;
}

std::vector<Part> pyramidOf(int base) {
    std::vector<Part> parts;
    for (int row = 0; row < base; ++row)
        for (int column = 0; column < base - row; ++column)
            parts.push_back({crate(), Point(1.05 * (column - (base - row - 1) / 2.0), row + 0.5)});
    return parts;
}

}  // namespace

Rows weights(const Setup& setup) {
    return {weigh("a-crate", stackOf({1}), setup),
            weigh("10-crates", stackOf(std::vector<double>(10, 1.0)), setup),
            weigh("a-pyramid-of-base-5", pyramidOf(5), setup),
            weigh("a-jelly-on-a-crate",
                  {{crate(), Point(0, 0.5)}, {firmJelly(1, 2), Point(0, 1.5)}}, setup),
            weigh("a-soft-jelly", {{firmJelly(1, 1, 400, 1), Point(0, 0.5)}}, setup),
            weigh("crates-of-different-mass", stackOf({5, 0.5, 20, 1, 0.1}), setup)};
}

}  // namespace sulfur::lab
