// A charge goes off under a wall of crates. The world has no call for explosions and needs none: it
// is asked what lies within reach, and each body gets an impulse away from the charge at the point
// that is nearest to it, which also makes it spin.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

/// Pushes whatever is within `reach` metres; `strength` N s at the charge, less and less farther
/// away.
void explode(sulfur::World& world, sulfur::Point charge, double reach, double strength) {
    using namespace sulfur;
    for (const Overlap& found : world.overlapCircle(charge, reach)) {
        if (world.kind(found.body) != BodyKind::dynamic) continue;
        const QueryFilter onlyThis{.accept = [&](BodyId body) { return body == found.body; }};
        const auto nearest = world.closestPoint(charge, reach, onlyThis);
        if (!nearest) continue;
        const double share = 1 - std::max(0.0, nearest->distance) / reach;
        const Point away = (world.centreOfMass(found.body) - charge).normalized();
        world.applyImpulse(found.body, (strength * share * away).cast<Real>(), nearest->point);
    }
}

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-4.2, -0.25}, {4.2, 4.4});

    World world;
    world.add(shapes::floor({-40, 0}, {40, 0}));
    std::vector<Body> crates;
    for (int row = 0; row < 6; ++row)
        for (int i = 0; i < 5; ++i)
            crates.push_back(world.add(shapes::box({.size = {0.5, 0.5}, .mass = 10}),
                                       {.position = {-1.0 + 0.5 * i, 0.3 + 0.5 * row}}));
    while (world.time() < 0.5) world.step();

    explode(world, {0, -0.1}, 3, 60);
    double fastest = 0;
    for (const Body& crate : crates)
        fastest = std::max(fastest, static_cast<double>(crate.meanVelocity().norm()));
    while (world.time() < 0.9) world.step();
    picture.take(world);
    while (world.time() < 4) world.step();

    const auto thrown = std::count_if(crates.begin(), crates.end(), [](const Body& crate) {
        return std::abs(crate.centreOfMass().x()) > 2;
    });
    std::printf("the fastest crate left at %.1f m/s, %d of %zu lie more than 2 m away\n", fastest,
                static_cast<int>(thrown), crates.size());
    return fastest > 3 && thrown >= 4 ? 0 : 1;
}
