// An iron ball strikes a wall of bricks. The mortar between them is elastic joints that break at
// 300 N: where a pull is larger, Events::jointsBroken tells so, and the bricks come loose. (For a
// wall of one body that falls apart into bodies, see shapes::wall and Events::bodiesSplit.)
#include <algorithm>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

/// Joins all corners of both bricks that are near each other.
void addMortar(sulfur::World& world, sulfur::Body a, sulfur::Body b) {
    for (const sulfur::ParticleId i : a.particles())
        for (const sulfur::ParticleId j : b.particles())
            if ((world.position(i) - world.position(j)).norm() < 0.22)
                world.connect(i, j, {.stiffness = 60000, .damping = 60, .strength = 300});
}

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-5, -0.25}, {5.4, 4});

    World world;
    world.add(shapes::floor({-20, 0}, {20, 0}));
    std::vector<Body> bricks;
    for (int row = 0; row < 10; ++row)
        for (int i = 0; i < 4; ++i)
            bricks.push_back(
                world.add(shapes::box({.size = {0.49, 0.29}, .mass = 3}),
                          {.position = {0.5 * i + 0.25 * (row % 2), 0.2 + 0.3 * row}}));
    for (std::size_t i = 0; i < bricks.size(); ++i)
        for (std::size_t j = i + 1; j < bricks.size(); ++j) addMortar(world, bricks[i], bricks[j]);
    const std::size_t mortar = world.connections().size();
    std::size_t broken = 0;
    while (world.time() < 1) {  // the wall stands
        world.step();
        broken += world.events().jointsBroken.size();
    }
    const bool stood = broken == 0;

    const Body ball = world.add(shapes::ball({.radius = 0.3, .mass = 20}), {.position = {-4, 1.5}});
    picture.paint(ball, "grey");
    for (const Body& brick : bricks) picture.paint(brick, "red");
    ball.setVelocity({14, 1.5});
    while (world.time() < 4) {
        world.step();
        broken += world.events().jointsBroken.size();
        if (world.ticks() == 780) picture.take(world);
    }

    const auto fallen = std::count_if(bricks.begin(), bricks.end(), [](const Body& brick) {
        return brick.centreOfMass().x() > 2.5;
    });
    std::printf("the wall stood; then %zu of %zu joints broke and %d of %zu bricks fell\n", broken,
                mortar, static_cast<int>(fallen), bricks.size());
    return stood && broken > 20 && fallen > 3 ? 0 : 1;
}
