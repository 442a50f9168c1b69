// A car drives over bumps on sprung wheels. Each wheel hangs on a rigid arm that turns about a
// point of the body, and on a spring with a damper above it. A torque turns the wheels, and the
// opposite one acts on the body, as with a real engine.
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

    // The first particles of a polygon are its corners. The lower two carry the arms, those at both
    // ends the springs.
    constexpr std::array<int, 2> arms{0, 1}, ends{7, 2};
    const Body body = world.add(shapes::polygon({.points = {{-0.25, -0.15},
                                                            {0.25, -0.15},
                                                            {1.1, 0.25},
                                                            {0.55, 0.35},
                                                            {0.3, 0.65},
                                                            {-0.5, 0.65},
                                                            {-0.7, 0.35},
                                                            {-1.1, 0.3}},
                                                 .mass = 300}),
                                {.position = {0, 0.9}});
    std::array<Body, 2> wheels;
    std::array<JointId, 2> springs;
    for (std::size_t i = 0; i < 2; ++i) {
        wheels[i] = world.add(shapes::ball({.radius = 0.35, .mass = 20}),
                              {.position = {i == 0 ? -0.85 : 0.85, 0.4}});
        picture.paint(wheels[i], "grey");
        const ParticleId hub = wheels[i].front();
        world.connect(body[arms[i]], hub);
        springs[i] = world.connect(body[ends[i]], hub, {.stiffness = 15000, .damping = 1200});
        world.setCollision(body, wheels[i], false);
    }
    picture.paint(body, "red");

    double shortest = 1, longest = 0, tilt = 0;  // m of a spring, rad
    while (world.time() < 6) {
        const Real engine = body.meanVelocity().x() < 4 ? 120 : 0;  // N m
        for (const Body& wheel : wheels) wheel.applyTorque(-engine);
        body.applyTorque(2 * engine);
        world.step();
        const JointInfo spring = world.info(springs[1]);
        const double length = (world.position(spring.a) - world.position(spring.b)).norm();
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
        tilt = std::max(tilt, std::abs(body.angle()));
        if (world.ticks() == 1000 || world.ticks() == 2000) picture.take(world, 0.3);
        if (world.ticks() == 1500) picture.take(world);
    }
    std::printf(
        "the car drove %.1f m; its front springs were %.2f to %.2f m long, the body tilted by up "
        "to %.0f degrees\n",
        body.centreOfMass().x(), shortest, longest, tilt * 180 / 3.14159265);
    return body.centreOfMass().x() > 12 && longest - shortest > 0.05 && tilt < 0.5 ? 0 : 1;
}
