// A bridge of planks hangs between two cliffs and bears a cart's worth of crates that fall on it. A
// plank is a capsule between two particles, neighbours share a particle, and the outermost ones are
// pinned: that is the whole bridge. Its pins bear what hangs between them.
#include <algorithm>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-5.2, -2.6}, {5.2, 2.2});

    World world;
    world.add(
        shapes::ground({.points = {{-9, 0}, {-4, 0}, {-4.3, -2.5}, {4.3, -2.5}, {4, 0}, {9, 0}}}));
    const Body bridge = world.add(shapes::bridge({.from = {-4, 0},
                                                  .to = {4, 0},
                                                  .planks = 20,
                                                  .sag = 0.5,
                                                  .mass = 60,
                                                  .stiffness = 2e6,
                                                  .damping = 1000,
                                                  .strength = 20000}));
    std::vector<Body> crates;
    for (int i = 0; i < 7; ++i)
        crates.push_back(world.add(shapes::box({.size = {0.6, 0.5}, .mass = 25}),
                                   {.position = {-2.4 + 0.8 * i, 0.1 + 0.1 * (i % 2)}}));

    double pull = 0;  // N, the most that a plank bears
    while (world.time() < 6) {
        world.step();
        for (const JointId plank : bridge.joints())
            pull = std::max(pull, static_cast<double>(world.info(plank).force));
    }
    picture.take(world);

    double lowest = 0;
    for (const Body& crate : crates) lowest = std::min(lowest, crate.centreOfMass().y());
    std::printf(
        "%zu of 20 planks are whole, the lowest crate is %.2f m below the cliffs, "
        "planks bore up to %.0f N\n",
        bridge.joints().size(), -lowest, pull);
    return bridge.joints().size() == 20 && lowest > -1.2 && pull > 1000 ? 0 : 1;
}
