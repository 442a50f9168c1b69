// Crates one on another.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

struct StackOptions {
    std::string name;  // of the picture
    std::string title;
    int count = 20;
    double size = 1;     // m
    double topMass = 1;  // kg; the others have 1 kg
    bool soft = false;
    double sinkBound = 0.01;  // m
    bool sinks = true;        // has to sink by less than that
    bool still = true;        // has to keep to its line and be quiet
};

std::vector<Body> pile(World& world, const StackOptions& o) {
    addFloor(world, 10 * o.size);
    std::vector<Body> bodies;
    for (int i = 0; i < o.count; ++i) {
        const double mass = i + 1 == o.count ? o.topMass : 1;
        bodies.push_back(
            world.add(o.soft ? firmJelly(o.size, mass) : crate({.size = o.size, .mass = mass}),
                      {.position = Point(0, o.size * (i + 0.5))}));
    }
    return bodies;
}

Rows stand(const StackOptions& o, const Setup& setup) {
    World world(still(setup, standardGravity));
    const std::vector<Body> bodies = pile(world, o);
    const Places places(world, bodies);
    const double seconds = setup.seconds(60, 20);
    double sunk = 0, sideways = 0;
    run(world, 0.1);
    for (int i = 1; i < std::lround((seconds - 10) * 10); ++i) {
        run(world, 0.1);
        sunk = worst(sunk, places.sunk());
        sideways = worst(sideways, places.sideways());
    }
    double jitter = 0;
    SpeedMeter speed(world, bodies);
    for (int i = 0; i < 10 * setup.tickRate; ++i) {
        world.step();
        jitter = worst(jitter, speed.add());
    }
    sunk = worst(sunk, places.sunk());
    sideways = worst(sideways, places.sideways());
    keepPicture(setup, o.name, world);
    const std::string name = fmt::format("{}, {:g} s: ", o.title, seconds);
    const double fallen = places.moved(o.size / 2);
    Rows rows{o.soft ? reported(name + "crates not at their places", fallen)
                     : atMost(name + "crates not at their places", fallen, 0)};
    const auto add = [&](bool bounded, const std::string& what, double measured, double bound) {
        rows.push_back(bounded ? atMost(name + what, measured, bound)
                               : reported(name + what, measured));
    };
    add(o.sinks, "sinks (m)", sunk, o.sinkBound);
    add(o.still, "sideways (m)", sideways, 0.01);
    add(o.still, "largest speed in the last 10 s (m/s)", jitter, 1e-3);
    rows.push_back(reported(name + "overlap (share of a radius)", deepestOverlap(world).share));
    return rows;
}

Rows fallAsleep(const StackOptions& o, const Setup& setup) {
    WorldSettings settings = still(setup, standardGravity);
    settings.sleeping = true;
    World world(settings);
    const std::vector<Body> bodies = pile(world, o);
    const auto asleep = [&] {
        return std::all_of(bodies.begin(), bodies.end(),
                           [&](const Body& body) { return world.asleep(body); });
    };
    while (!asleep() && world.time() < 20) world.step();
    const double needed = asleep() ? world.time() : std::numeric_limits<double>::quiet_NaN();
    SpeedMeter speed(world, bodies);
    double fastest = 0;
    for (int i = 0; i < 5 * setup.tickRate; ++i) {
        world.step();
        fastest = worst(fastest, speed.add());
    }
    return {atMost(o.title + ": time until all sleep (s)", needed, 5),
            atMost(o.title + ": largest speed in the 5 s after (m/s)", fastest, 0)};
}

}  // namespace

Rows stacks(const Setup& setup) {
    const StackOptions plain{.name = "stack20", .title = "stack of 20 crates of 1 m"};
    StackOptions heavy{.name = "stack20-heavy",
                       .title = "stack of 20 crates, the top one 100 times as heavy",
                       .topMass = 100,
                       .sinkBound = 0.05,
                       .still = false};
    StackOptions small{
        .name = "stack20-small", .title = "stack of 20 crates of 0.3 m", .size = 0.3};
    StackOptions soft{.name = "stack20-jelly",
                      .title = "stack of 20 firm jellies of 1 m",
                      .soft = true,
                      .sinks = false,
                      .still = false};
    Rows rows;
    for (const StackOptions& o : {plain, heavy, small, soft})
        for (Row& row : stand(o, setup)) rows.push_back(std::move(row));
    for (const StackOptions& o : {plain, small})
        for (Row& row : fallAsleep(o, setup)) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sulfur::lab
