// Three jellies of different stiffness fall on the floor. They are lattices of springs with a
// surface of capsules: the floor squeezes them, they wobble, and they come back to their shape,
// each as far as its own weight lets it.
#include <algorithm>
#include <array>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-3.1, -0.2}, {3.1, 3.3});

    World world;
    world.add(shapes::floor({-10, 0}, {10, 0}));
    struct Jelly {
        Real stiffness;  // N/m
        Body body = {};
        double flattest = 9, rest = 0;  // m
    };
    std::array<Jelly, 3> jellies{{{500}, {1500}, {5000}}};
    for (std::size_t i = 0; i < 3; ++i)
        jellies[i].body = world.add(shapes::jelly({.size = {1.2, 1.2},
                                                   .columns = 5,
                                                   .rows = 5,
                                                   .mass = 4,
                                                   .stiffness = jellies[i].stiffness,
                                                   .damping = 15}),
                                    {.position = {1.9 * (static_cast<double>(i) - 1), 2.25}});
    picture.take(world, 0.2);

    while (world.time() < 5) {
        world.step();
        for (Jelly& jelly : jellies) {
            const Bounds bounds = jelly.body.bounds();
            jelly.rest = bounds.high.y() - bounds.low.y();
            jelly.flattest = std::min(jelly.flattest, jelly.rest);
        }
        if (world.ticks() == 330) picture.take(world);
    }

    bool right = true;
    for (const Jelly& jelly : jellies) {
        std::printf("%4.0f N/m: squeezed to %.2f m, then %.2f m high\n", jelly.stiffness,
                    jelly.flattest, jelly.rest);
        right = right && jelly.rest > 1.1 && jelly.flattest < jelly.rest - 0.01;
    }
    return right && jellies[0].flattest < jellies[2].flattest - 0.05 ? 0 : 1;
}
