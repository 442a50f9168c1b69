// Bodies with round corners slide and roll without bumps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

Blueprint roundedBox(Real size, Real radius, Real friction) {
    return shapes::box({.size = {size, size},
                        .radius = radius,
                        .rounded = true,
                        .material = {.staticFriction = friction, .kineticFriction = friction}});
}

/// A line of short capsules, whose upper side is at 0.
Blueprint seamedFloor() {
    shapes::GroundOptions options{.material = {.staticFriction = 5, .kineticFriction = 5}};
    for (int i = -8; i <= 40; ++i)
        options.points.emplace_back(Real(0.25) * static_cast<Real>(i), Real(-0.05));
    return shapes::ground(options);
}

/// m, of the lowest point of the surface above the floor.
double lowest(const World& world, const Body& body, double radius) {
    double least = 1e9;
    for (std::size_t i = 0; i < 4; ++i) least = std::min(least, world.position(body[i]).y());
    return least - radius;
}

TEST(RoundedBodies, SlideOverSeamsWithoutBumps) {
    World world;
    world.add(seamedFloor());
    const Body body = world.add(roundedBox(1, Real(0.3), 0), {.position = {0, 0.5}});
    test::run(world, 0.2);
    body.setVelocity({3, 0}, 0);
    double fastest = 0;
    for (int i = 0; i < 1000; ++i) {
        world.step();
        fastest = std::max(fastest, std::abs(static_cast<double>(body.meanVelocity().y())));
    }
    EXPECT_LT(fastest, 1e-3);
    EXPECT_NEAR(static_cast<double>(body.meanVelocity().x()), 3, 1e-3);
    EXPECT_LT(std::abs(body.angle()), 1e-3);
}

TEST(RoundedBodies, RockOnTheirCornersAsOnWheels) {
    for (const double radius : {0.2, 0.35, 0.45}) {
        World world;
        world.add(seamedFloor());
        const double lean = 0.6;  // rad: it rolls back to its side
        const double half = 0.5 - radius;
        const double corner = -half * (std::sin(lean) + std::cos(lean));  // below the middle
        const Body body = world.add(roundedBox(1, static_cast<Real>(radius), 5),
                                    {.position = {0, radius - corner}, .angle = lean});
        const double energy = world.energy();
        double highest = 0, least = 0, worst = 0;
        int ticks = 0;
        while (body.angle() > 0.02 && world.time() < 5) {
            world.step();
            const double gap = lowest(world, body, radius);
            highest = std::max(highest, gap);
            least = std::min(least, gap);
            worst = std::max(worst, std::abs(world.energy() - energy));
            ++ticks;
        }
        EXPECT_GT(ticks, 100) << radius;
        EXPECT_LT(highest, 1e-3) << radius;
        EXPECT_GT(least, -1e-3) << radius;
        const double drop = 9.81 * (radius - corner - 0.5);
        EXPECT_LT(worst, 0.02 * drop) << radius;
        // Until it lies on its side, the spin is that of what has fallen so far.
        EXPECT_LT(body.angularVelocity(), -0.1) << radius;
    }
}

}  // namespace
}  // namespace sulfur
