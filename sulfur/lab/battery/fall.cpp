#include "battery/fall.hpp"

#include <fmt/format.h>

#include <cmath>

#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

Body stone(World& world, double distance) {
    Blueprint body = ghost("stone");
    body.particles.push_back({});
    return world.add(body, {.position = Point(distance, distance)});
}

}  // namespace

Row freeFall(double distance, const Setup& setup) {
    World world(still(setup, standardGravity));
    const Body body = stone(world, distance);
    const Point start = world.position(body.front());
    run(world, 1);
    const double error =
        (world.position(body.front()) - start - Point(0, -standardGravity / 2)).norm();
    return atMost(
        fmt::format("free fall of 1 s at {:g} m, {} Hz: error (m)", distance, setup.tickRate),
        error, setup.tickRate > 2000 ? 0.01 : 0.001);
}

Row slowDrift(double seconds, const Setup& setup) {
    World world(still(setup, 0));
    const Body body = stone(world, 1000);
    const Point start = world.position(body.front());
    const double speed = 0.01;
    world.setVelocity(body.front(), vec2(speed, 0));
    run(world, seconds);
    const Point way = world.position(body.front()) - start;
    return atMost(fmt::format("drift of {:g} s at {:g} m/s at 1 km, {} Hz: error of the distance "
                              "(share)",
                              seconds, speed, setup.tickRate),
                  (way - Point(speed * seconds, 0)).norm() / (speed * seconds), 0.01);
}

}  // namespace sulfur::lab
