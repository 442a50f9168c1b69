// What only holds because contacts are solved together along the paths of load.
#include <algorithm>
#include <cmath>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// Crates of 1 m one on another, on a floor whose surface is at 0.
struct Stack {
    explicit Stack(double topMass = 1) : world({.sleeping = false}) {
        world.add(shapes::floor({-10, Real(-0.05)}, {10, Real(-0.05)}));
        for (int i = 0; i < count; ++i) {
            const double mass = i + 1 == count ? topMass : 1;
            crates.push_back(world.add(shapes::box({.mass = static_cast<Real>(mass)}),
                                       {.position = {0, 0.5 + i}}));
        }
    }

    double fastest() const {
        double speed = 0;
        for (const Body& crate : crates)
            for (const ParticleId p : crate.particles())
                speed = std::max(speed, static_cast<double>(world.velocity(p).norm()));
        return speed;
    }
    double farthestSideways() const {
        double way = 0;
        for (const Body& crate : crates)
            way = std::max(way, std::abs(world.centreOfMass(crate)[0]));
        return way;
    }

    static constexpr int count = 20;
    World world;
    std::vector<Body> crates;
};

TEST(ContactForest, ANewStackIsAtRestFromItsFirstTick) {
    Stack stack;
    for (int tick = 0; tick < 20; ++tick) {
        stack.world.step();
        EXPECT_LT(stack.fastest(), 1e-4) << tick;
    }
}

TEST(ContactForest, AHeavyTopSwaysNothing) {
    Stack stack(100);
    test::run(stack.world, 10);
    EXPECT_LT(stack.farthestSideways(), 0.02);
    EXPECT_NEAR(stack.world.centreOfMass(stack.crates.back())[1], Stack::count - 0.5, 0.005);
}

/// Both corners of a crate may press outwards or inwards without moving anything.
TEST(ContactForest, CornersOfOneFaceDoNotPressAgainstEachOther) {
    Stack stack;
    test::run(stack.world, 1);
    for (const ContactInfo& contact : stack.world.contacts())
        EXPECT_LT(std::abs(contact.friction), 0.01);  // of a weight of 0.2 N s
}

}  // namespace
}  // namespace sulfur
