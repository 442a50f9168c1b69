// Newton's cradle: five steel balls hang side by side, the first is lifted and let go. What it
// gives the last one takes, and those between stay where they are: blows are solved pair after
// pair, with the restitution of the material.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-2.1, 0.2}, {2.1, 2.5});

    World world;
    const Material steel{.staticFriction = 0, .kineticFriction = 0, .restitution = 1};
    constexpr double length = 1.6, radius = 0.15, ceiling = 2.2;  // m
    std::vector<Body> balls;
    for (int i = 0; i < 5; ++i) {
        const Blueprint onThread{.name = "ball on a thread",
                                 .particles = {{.position = {0, 0}, .pinned = true},
                                               {.position = {0, -length}, .radius = radius}},
                                 .joints = {{.a = 0, .b = 1}},
                                 .material = steel};
        const Pose pose{.position = {2.001 * radius * (i - 2), ceiling},
                        .angle = i == 0 ? -0.9 : 0};
        balls.push_back(world.add(onThread, pose));
    }
    picture.take(world, 0.25);

    const auto height = [&](const Body& ball) {  // m above its lowest place
        return world.position(ball.back()).y() - (ceiling - length);
    };
    const double lifted = height(balls.front());
    double thrown = 0, sway = 0;  // m
    while (world.time() < 1.6) {
        world.step();
        if (height(balls.back()) < thrown && thrown > 0.1) break;  // it falls again
        thrown = std::max(thrown, height(balls.back()));
        sway = std::max(sway, std::abs(world.position(balls[2].back()).x()));
    }
    picture.take(world);

    std::printf(
        "the first ball fell by %.3f m, the last one rose by %.3f m, the middle one moved "
        "by %.0f mm\n",
        lifted, thrown, 1000 * sway);
    return thrown > 0.98 * lifted && sway < 0.01 ? 0 : 1;
}
