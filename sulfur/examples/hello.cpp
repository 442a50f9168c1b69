// A crate falls onto a floor and comes to rest.
#include <cstdio>
#include <sulfur/sulfur.hpp>

int main() {
    sulfur::World world{{.gravity = {0, -9.81f}}};  // 500 ticks a second
    world.add(sulfur::shapes::floor({-20, 0}, {20, 0}));
    auto crate = world.add(sulfur::shapes::box({.size = {1, 1}, .mass = 2}), {.position = {0, 3}});
    for (int tick = 0; tick <= 1000; ++tick) {
        if (tick % 250 == 0) {
            std::printf("%.1f s: %.2f m\n", world.time(), world.centreOfMass(crate).y());
        }
        world.step();
    }
}
