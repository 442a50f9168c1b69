// Balls run down two ramps through a light barrier into a basket. Both are sensors, which push
// nothing: the barrier counts who comes and who goes by the events of each tick, the basket is
// asked at the end who lies in it.
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-3.3, -0.25}, {3.3, 4.2});

    World world;
    world.add(shapes::floor({-10, 0}, {10, 0}));
    world.add(shapes::floor({-3, 3}, {0.9, 2.2}));
    world.add(shapes::ground({.points = {{-0.9, 1}, {2.9, 1.7}, {3, 2.4}}}));
    world.add(shapes::ground({.points = {{-2.6, 1.1}, {-2.5, 0.05}, {-1, 0.05}, {-0.9, 0.6}}}));
    const auto sensor = [&](Point low, Point high) {
        Blueprint plan = shapes::box({.size = (high - low).cast<Real>()});
        plan.kind = BodyKind::fixed;
        plan.sensor = true;
        return world.add(plan, {.position = (low + high) / 2});
    };
    const Body barrier = sensor({-0.2, 2.5}, {0, 3.2});
    const Body basket = sensor({-2.4, 0.15}, {-1.1, 0.9});

    int came = 0, went = 0;
    std::vector<Body> balls;
    while (world.time() < 8) {
        if (world.ticks() % 200 == 0 && balls.size() < 8) {
            balls.push_back(world.add(shapes::ball({.radius = 0.14}), {.position = {-2.6, 3.4}}));
            balls.back().setVelocity({1, 0});
        }
        world.step();
        for (const SensorEntered& event : world.events().sensorsEntered)
            if (event.sensor == barrier) ++came;
        for (const SensorLeft& event : world.events().sensorsLeft)
            if (event.sensor == barrier) ++went;
        if (world.ticks() == 1150) picture.take(world);
    }
    const std::size_t caught = world.visitors(basket).size();
    std::printf("%d balls came into the barrier, %d left it; %zu lie in the basket\n", came, went,
                caught);
    return came == 8 && went == 8 && caught >= 6 ? 0 : 1;
}
