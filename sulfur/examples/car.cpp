// A car drives over bumps on sprung wheels. Each wheel slides up and down on a line of the body,
// with a spring, a damper and stops, and a motor turns it. What the motor gives the wheel acts on
// the body the other way round, as with a real engine.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {0.9, -0.3}, {12.1, 2.4});

    World world;
    shapes::GroundOptions road{.points = {{-8, 0}, {3, 0}}};
    for (int i = 1; i <= 60; ++i) {  // bumps
        const Real x = 3 + Real(0.1) * static_cast<Real>(i), bump = std::sin(Real(2.1) * (x - 3));
        road.points.push_back({x, Real(0.18) * bump * bump});
    }
    road.points.push_back({60, 0});
    world.add(shapes::ground(road));

    const Body body = world.add(shapes::polygon({.points = {{-0.25, -0.15},
                                                            {0.25, -0.15},
                                                            {1.1, 0.25},
                                                            {0.55, 0.35},
                                                            {0.3, 0.65},
                                                            {-0.5, 0.65},
                                                            {-0.7, 0.35},
                                                            {-1.1, 0.3}},
                                                 .mass = 300}),
                                {.position = {0, 0.55}});
    std::array<Body, 2> wheels;
    std::array<WheelIds, 2> hung;
    for (std::size_t i = 0; i < 2; ++i) {
        wheels[i] = world.add(shapes::ball({.radius = 0.35, .mass = 20}),
                              {.position = {i == 0 ? -0.85 : 0.85, 0.4}});
        picture.paint(wheels[i], "grey");
        // Down is positive: the springs bear the car where they are, 10 cm from rest.
        hung[i] = world.wheel(body, wheels[i], wheels[i].centreOfMass(), {0, -1},
                              {.spring = {.lower = Real(-0.12),
                                          .upper = Real(0.15),
                                          .stiffness = 15000,
                                          .damping = 1200,
                                          .rest = Real(0.1)},
                               .motor = {.motorSpeed = -4 / Real(0.35), .motorMax = 120}});
    }
    picture.paint(body, "red");

    double highest = 0, lowest = 0, tilt = 0;  // m of a wheel on its line, rad
    while (world.time() < 6) {
        world.step();
        const double down = world.info(hung[1].spring).value;
        highest = std::min(highest, down);
        lowest = std::max(lowest, down);
        tilt = std::max(tilt, std::abs(body.angle()));
        if (world.ticks() == 1000 || world.ticks() == 2000) picture.take(world, 0.3);
        if (world.ticks() == 1500) picture.take(world);
    }
    std::printf(
        "the car drove %.1f m; its front wheel went up by %.2f and down by %.2f m, the body tilted "
        "by up to %.0f degrees\n",
        body.centreOfMass().x(), -highest, lowest, tilt * 180 / 3.14159265);
    return body.centreOfMass().x() > 12 && lowest - highest > 0.05 && tilt < 0.5 ? 0 : 1;
}
