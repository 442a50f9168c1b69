// A crate on ice, one on wood and a ball go down slopes of 20 degrees. Friction brakes the crate on
// wood; part of what gravity gives to the ball goes into its spin, so that it gains two thirds of
// the speed of the crate on ice. All quantities are in SI units, so that this is as in textbooks.
#include <array>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-0.9, -3.3}, {7.1, 3.8});

    constexpr double slope = 0.35, size = 0.5, floorRadius = 0.05;   // rad, m
    constexpr double g = 9.81, along = 0.342898, across = 0.939373;  // sine and cosine of the slope
    // Where two surfaces meet, the coefficient is the geometric mean of the two; that of the slopes
    // is 0.5.
    const Material ice{.staticFriction = 0, .kineticFriction = 0};
    const Material wood{.staticFriction = 0.08, .kineticFriction = 0.08};
    struct Racer {
        const char* name;
        Blueprint plan;
        double acceleration;  // m/s^2, by the textbook
    };
    const std::array<Racer, 3> racers{{
        {"crate on ice", shapes::box({.size = {size, size}, .material = ice}), g * along},
        {"crate on wood", shapes::box({.size = {size, size}, .material = wood}),
         g * (along - 0.2 * across)},
        {"ball", shapes::ball({.radius = size / 2}), g * along * 2 / 3},
    }};

    World world;
    std::array<Body, 3> bodies;
    for (std::size_t i = 0; i < 3; ++i) {
        const Point top(0, 2.6 - 1.5 * static_cast<double>(i));
        world.add(shapes::floor({-0.5, 0}, {7, 0}, floorRadius),
                  {.position = top, .angle = -slope});
        const Point up(along, across);
        bodies[i] = world.add(racers[i].plan,
                              {.position = top + (size / 2 + floorRadius) * up, .angle = -slope});
    }
    for (const unsigned tick : {1u, 350u, 700u}) {
        while (world.ticks() < tick) world.step();
        picture.take(world, tick == 700 ? 1 : 0.3);
    }

    bool right = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const double expected = racers[i].acceleration * world.time();
        const double speed = bodies[i].meanVelocity().norm();
        std::printf("%-13s %.3f m/s after %.1f s, expected %.3f\n", racers[i].name, speed,
                    world.time(), expected);
        right = right && std::abs(speed - expected) < 0.01 * expected;
    }
    return right ? 0 : 1;
}
