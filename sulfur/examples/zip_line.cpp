// A zip line: a rider hangs on a trolley that rolls down a rope between two posts. The trolley is a
// slider whose rail is the links of the rope, which sags under it. Half-way down the rider brakes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-0.5, 0}, {20.5, 7});

    World world;
    world.add(shapes::floor({-5, 0}, {25, 0}));
    world.add(shapes::floor({0, 6}, {0, 0}));
    world.add(shapes::floor({20, 0}, {20, 4}));
    shapes::RopeOptions options;
    options.from = {0, 6};
    options.to = {20, 4};
    options.links = 40;
    options.slack = Real(0.005);
    options.mass = 30;
    options.pinFirst = options.pinLast = true;
    const Body rope = world.add(shapes::rope(options));

    const Point start = world.position(rope[2]);
    const Body trolley = world.add({.particles = {{.mass = 5}}}, {.position = start});
    const Body rider = world.add(shapes::box({.size = {Real(0.4), Real(1)}, .mass = 70}),
                                 {.position = start - Point(0, 1.5)});
    const MechanismId slider = world.slider(rope, trolley, start, rope.joints());
    for (const ParticleId corner : rider.particles())  // the shoulders
        if (world.position(corner).y() > start.y() - 1.1) world.connect(trolley.front(), corner);
    world.setCollision(rope, rider, false);
    picture.take(world, 0.3);

    const double energy = world.energy();
    double fastest = 0;
    while (world.time() < 12) {
        world.step();
        if (world.info(slider).value > 10) world.setDrive(slider, {.damping = 60});
        fastest = std::max(fastest, world.info(slider).speed);
        if (std::abs(world.time() - 2) < 1e-6) picture.take(world, 0.6);
    }
    picture.take(world);
    const MechanismInfo end = world.info(slider);
    std::printf("the rider went %.1f m along the rope at up to %.1f m/s and hangs %.2f m high\n",
                end.value, fastest, end.pointB.y());
    const bool isOnRope = (end.pointA - end.pointB).norm() < 1e-2;
    return isOnRope && world.energy() < energy && fastest > 3 && std::abs(end.speed) < 0.1 ? 0 : 1;
}
