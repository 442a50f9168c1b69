#include "battery/nets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

struct Course {
    double strain = 0, strainAtEnd = 0;  // the most, and at the end
    double gained = 0;                   // J, the most
};
Course follow(World& world, const Body& body, double seconds) {
    Course course;
    const double start = world.energy();
    const auto ticks = std::lround(seconds * world.settings().tickRate);
    for (long i = 0; i < ticks; ++i) {
        world.step();
        course.strainAtEnd = largestStrain(world, body);
        course.strain = std::max(course.strain, course.strainAtEnd);
        course.gained = std::max(course.gained, world.energy() - start);
    }
    return course;
}

WorldSettings awake(const Setup& setup) {
    return {.tickRate = setup.tickRate, .sleeping = false, .sweeps = setup.sweeps};
}

Blueprint ladder() {
    constexpr std::uint32_t ends = 60;
    Blueprint plan;
    for (std::uint32_t i = 0; i < ends; ++i)
        plan.particles.push_back({.position = Point(0.2 * (i % 2), -0.2 * (i / 2)).cast<Real>(),
                                  .mass = i + 2 == ends ? 100 : Real(0.1),
                                  .pinned = i < 2});
    for (std::uint32_t i = 0; i + 2 < ends; ++i) plan.joints.push_back({.a = i, .b = i + 2});
    for (std::uint32_t i = 2; i < ends; i += 2) plan.joints.push_back({.a = i, .b = i + 1});
    return plan;
}

}  // namespace

Rows nets(const Setup& setup) {
    Rows rows;
    for (const double load : {1.0, 1e2, 1e4, 1e6}) {
        World world(awake(setup));
        const Body body = world.add(net({.side = 20, .load = load}));
        const Course course = follow(world, body, setup.seconds(5, 2));
        const std::string name = fmt::format("net of 20 x 20 under {:g} times a node's mass", load);
        rows.push_back(atMost(name + ": largest strain", course.strain, 0.01));
        rows.push_back(atMost(name + ": strain at rest", course.strainAtEnd, 1e-3));
    }
    for (const double load : {1.0, 1e4}) {
        World world(awake(setup));
        const Body body = world.add(net({.load = load, .secondCorner = false}));
        constexpr double side = 1;  // m
        const double scale = standardGravity * static_cast<double>(world.mass(body)) * side;
        const Course course = follow(world, body, setup.seconds(5, 2));
        const std::string name =
            fmt::format("net of 10 x 10 let go at one corner, {:g} in the middle", load);
        const double gained = course.gained / scale;
        rows.push_back(atMost(name + ": largest strain", course.strain, 0.01));
        rows.push_back(atMost(name + ": energy gained, in what it may fall", gained, 0.01));
    }
    World world(awake(setup));
    const Body body = world.add(ladder());
    world.setVelocity(body.back(), {3, 0});
    const Course course = follow(world, body, setup.seconds(10, 5));
    rows.push_back(
        atMost("ladder of 29 rungs with 1000 times a node's mass: strain", course.strain, 1e-5));
    rows.push_back(atMost("ladder of 29 rungs with 1000 times a node's mass: energy gained, J",
                          course.gained, 0.05));
    return rows;
}

}  // namespace sulfur::lab
