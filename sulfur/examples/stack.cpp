// Ten crates stand on each other, each a little smaller than the one below. Nothing is tuned for
// it: static friction and the impulses that contacts keep from tick to tick hold them where they
// are, until the whole tower falls asleep and costs nothing any more.
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-3.4, -0.25}, {3.4, 4.8});

    World world;
    world.add(shapes::floor({-10, 0}, {10, 0}));
    double height = 0.05;  // the floor is 10 cm thick, half of it above 0
    Body top;
    for (int i = 0; i < 10; ++i) {
        const Real side = Real(0.6) - Real(0.03) * static_cast<Real>(i);
        const Blueprint crate = shapes::box({.size = {side, side}, .mass = 100 * side * side});
        height += side / 2;
        top = world.add(crate, {.position = {i % 2 == 0 ? 0.02 : -0.02, height}});
        height += side / 2;
    }

    const Point before = top.centreOfMass();
    while (world.time() < 4) world.step();
    const Point moved = top.centreOfMass() - before;

    picture.take(world);
    std::printf("after %.0f s the uppermost crate has moved by %.2f mm and %s\n", world.time(),
                1000 * moved.norm(), world.asleep(top) ? "sleeps" : "is awake");
    return moved.norm() < 0.005 && world.asleep(top) ? 0 : 1;
}
