// A curtain hangs by its upper corners. A hand takes a lower corner, pulls it aside and lets go;
// the curtain swings and hangs as before. Its threads are stiff springs, which need no smaller
// ticks, and the hand is a soft one (World::grab), as a mouse has it.
#include <algorithm>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-1.7, -0.2}, {2.1, 2.6});

    World world({.airFriction = 0.5});
    world.add(shapes::floor({-10, 0}, {10, 0}));
    constexpr int columns = 16, rows = 14;
    const Body cloth = world.add(shapes::cloth({.size = {2, 1.7},
                                                .columns = columns,
                                                .rows = rows,
                                                .mass = 1,
                                                .stiffness = 5000,
                                                .damping = 0.5}),
                                 {.position = {0, 1.5}});
    picture.paint(cloth, "violet");
    while (world.time() < 5) world.step();         // it sags a little
    const ParticleId corner = cloth[columns - 1];  // row by row from the lower left
    const Point rest = world.position(corner);

    const GrabId hand = world.grab(corner, rest, {.frequency = 4});
    while (world.time() < 6.5) {
        world.setTarget(hand, rest + (world.time() - 5) / 1.5 * Point(0.7, 0.6));
        world.step();
    }
    picture.take(world);
    const double pulled = (world.position(corner) - rest).norm();
    double strain = 0;  // the largest of any thread
    for (const JointId id : cloth.joints()) {
        const JointInfo thread = world.info(id);
        const double length = (world.position(thread.a) - world.position(thread.b)).norm();
        strain = std::max(strain, length / thread.restLength - 1);
    }

    world.release(hand);
    while (world.time() < 15) world.step();
    const double off = (world.position(corner) - rest).norm();
    std::printf(
        "the corner was pulled %.2f m aside, threads stretched by up to %.1f %%; "
        "it came back to %.0f mm\n",
        pulled, 100 * strain, 1000 * off);
    return pulled > 0.5 && strain < 0.1 && off < 0.05 ? 0 : 1;
}
