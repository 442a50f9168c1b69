#include "battery/spinning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

Blueprint crate() {
    Blueprint plan = shapes::box();
    plan.filter.mask = 0;
    return plan;
}

Rows neverGrows(const std::string& name, World& world, Body body, double seconds) {
    world.step();
    const double first = motionOf(world, body.particles()).spinKinetic;
    double largest = 0;
    const auto ticks = std::lround(seconds * world.settings().tickRate);
    for (long i = 1; i < ticks; ++i) {
        world.step();
        largest = worst(largest, motionOf(world, body.particles()).spinKinetic);
    }
    return {atMost(name + ": largest energy of spin over the first, minus 1", largest / first - 1,
                   1e-3),
            atMost(name + ": not finite", allFinite(world, body.particles()) ? 0 : 1, 0)};
}

}  // namespace

Rows spinningCrate(double turnsPerSecond, double distance, double seconds, const Setup& setup) {
    World world(still(setup, 0));
    const Body body = world.add(crate(), {.position = Point(distance, distance)});
    spin(world, body, 2 * std::numbers::pi * turnsPerSecond);
    world.step();
    const Motion first = motionOf(world, body.particles());
    run(world, seconds);
    const Motion last = motionOf(world, body.particles());
    const std::string name =
        fmt::format("crate in free flight, {:g} turns/s at {:g} m, {:g} s: ", turnsPerSecond,
                    distance, seconds);
    return {atMost(name + "change of angular momentum (share)",
                   std::abs(last.angularMomentum / first.angularMomentum - 1), 1e-3),
            atMost(name + "change of energy (share)", std::abs(last.kinetic / first.kinetic - 1),
                   1e-3)};
}

Rows fastCrate(double turnsPerSecond, double seconds, const Setup& setup) {
    World world(still(setup, 0));
    const Body body = world.add(crate());
    spin(world, body, 2 * std::numbers::pi * turnsPerSecond);
    return neverGrows(fmt::format("crate, {:g} turns/s at {} Hz, {:g} s", turnsPerSecond,
                                  setup.tickRate, seconds),
                      world, body, seconds);
}

Rows spinningShard(double speed, double seconds, const Setup& setup) {
    World world(still(setup, 0));
    Blueprint plan = ghost("shard");
    const double side = 0.04, height = side * std::sqrt(3.0) / 2;
    for (const Vec& corner : {Vec(0, 0), Vec(side, 0), Vec(side / 2, height)})
        plan.particles.push_back({.position = corner.cast<Real>(), .mass = real(0.01)});
    for (const auto& [a, b] : {std::pair(0u, 1u), {1u, 2u}, {2u, 0u}})
        plan.joints.push_back({.a = a, .b = b});
    const Body body = world.add(plan);
    spin(world, body, speed / (height * 2 / 3));
    return neverGrows(
        fmt::format("shard of 4 cm at {:g} m/s, {} Hz, {:g} s", speed, setup.tickRate, seconds),
        world, body, seconds);
}

}  // namespace sulfur::lab
