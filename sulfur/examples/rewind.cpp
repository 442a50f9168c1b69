// A shot misses; time goes back and the player tries again. A snapshot holds the whole state of a
// world, so that restoring it and doing the same again gives the same, to the last bit.
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-5, -0.25}, {4, 4.8});

    World world;
    world.add(shapes::floor({-20, 0}, {20, 0}));
    std::vector<Body> crates;
    for (int i = 0; i < 6; ++i)
        crates.push_back(
            world.add(shapes::box({.size = {0.5, 0.5}}), {.position = {1, 0.3 + 0.5 * i}}));
    const Body ball = world.add(shapes::ball({.radius = 0.2, .mass = 3}), {.position = {-4, 0.25}});
    while (world.time() < 1) world.step();
    const Snapshot before = world.snapshot();  // a game would keep one for each of the last seconds

    const auto shoot = [&](Vec2 velocity, double opacity) {
        ball.setVelocity(velocity);
        for (int tick = 0; tick < 750; ++tick) {
            world.step();
            if (tick % 20 == 0) picture.dot(ball.centreOfMass(), opacity);
            if (tick == 340) picture.take(world, opacity);
        }
        return crates.back().centreOfMass().y() > 2.5;  // whether the tower stands
    };
    const bool missed = shoot({7, 9}, 0.25);
    std::printf("the first shot goes over the tower, which %s\n", missed ? "stands" : "falls");

    world.restore(before);  // handles from then are valid again
    std::printf("back to %.1f s\n", world.time());
    const bool missedAgain = shoot({8, 4}, 1);
    const std::uint64_t end = world.hash();
    std::printf("the second shot hits the tower, which %s\n", missedAgain ? "stands" : "falls");

    world.restore(before);
    shoot({8, 4}, 0);
    const bool same = world.hash() == end;
    std::printf("the same shot again ends %s\n", same ? "the same, to the bit" : "differently");
    return missed && !missedAgain && same ? 0 : 1;
}
