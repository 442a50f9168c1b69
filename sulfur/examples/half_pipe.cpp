// A half-pipe of arcs. What slides in it without friction comes as high on the other side as it
// began; what rolls in it does so, too, and takes longer, because a part of what gravity gives it
// is in its spin. Of facets, each would take the part of the speed that points into it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-5.4, -0.4}, {5.4, 3.2});

    World world;
    const Real quarter = Real(3.14159265 / 2);
    const Material slick{.staticFriction = 0, .kineticFriction = 0};
    const Material rough{.staticFriction = 1, .kineticFriction = 1};
    // Two pipes, one before the other: what is in one does not touch the other.
    const auto pipe = [&](const Material& material, std::uint32_t category) {
        Blueprint plan = shapes::ground({.points = {{-5, 2},
                                                    {-4, 2},
                                                    {-4, Real(1.98)},
                                                    {-2, 0},
                                                    {2, 0},
                                                    {4, Real(1.98)},
                                                    {4, 2},
                                                    {5, 2}},
                                         .material = material,
                                         .bends = {0, 0, quarter, 0, quarter, 0, 0}});
        plan.filter = {.category = category, .mask = category};
        world.add(plan);
    };
    const auto drop = [&](Blueprint plan, std::uint32_t category) {
        plan.filter = {.category = category, .mask = category};
        // In the left arc, a radian up from its lowest point.
        const double reach = 2 - 0.05 - 0.25;
        return world.add(plan,
                         {.position = {-2 - reach * std::sin(1.0), 2 - reach * std::cos(1.0)}});
    };
    pipe(slick, 1);
    pipe(rough, 2);
    const Body puck = drop(shapes::ball({.radius = Real(0.25), .material = slick}), 1);
    const Body ball = drop(shapes::ball({.radius = Real(0.25), .material = rough}), 2);
    const double start = world.position(puck[0]).y();

    double highest[2] = {0, 0}, lowest[2] = {9, 9};
    unsigned arrival[2] = {0, 0};
    picture.take(world, 0.3);
    for (unsigned tick = 1; tick <= 1500; ++tick) {
        world.step();
        for (const int i : {0, 1}) {
            const Point at = world.position((i == 0 ? puck : ball)[0]);
            lowest[i] = std::min(lowest[i], at.y());
            if (at.x() > 2) highest[i] = std::max(highest[i], at.y());
            if (at.x() > 2 && arrival[i] == 0) arrival[i] = tick;
        }
        if (tick == 450) picture.take(world);
    }
    std::printf(
        "began at %.3f m; the puck comes to %.3f m, the ball to %.3f m, after %u and %u ticks\n",
        start, highest[0], highest[1], arrival[0], arrival[1]);
    const auto comesBack = [&](int i) {
        return std::abs(highest[i] - start) < 0.02 && std::abs(lowest[i] - 0.3) < 0.002;
    };
    // It has 2/3 of the acceleration, at each place.
    const double slower = static_cast<double>(arrival[1]) / arrival[0];
    return comesBack(0) && comesBack(1) && std::abs(slower - std::sqrt(1.5)) < 0.01 ? 0 : 1;
}
