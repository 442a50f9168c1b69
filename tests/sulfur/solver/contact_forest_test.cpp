// What only holds because contacts are solved together along the paths of load.
#include <algorithm>
#include <cmath>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

double speedOf(const World& world, const std::vector<Body>& bodies) {
    double speed = 0;
    for (const Body& body : bodies)
        for (const ParticleId p : body.particles())
            speed = std::max(speed, static_cast<double>(world.velocity(p).norm()));
    return speed;
}

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

    double fastest() const { return speedOf(world, crates); }
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

/// Now and then a contact of two corners begins with what its neighbour carried. A tree mends that
/// at once; stacks that were left to the sweeps for it swayed at 1 to 3 cm/s.
TEST(ContactForest, StacksOfSmallCratesStayQuiet) {
    for (const double side : {0.26, 0.275, 0.3, 0.36}) {
        const Real size = static_cast<Real>(side);
        World world({.sleeping = false});
        const Material rough{.staticFriction = Real(0.5), .kineticFriction = Real(0.5)};
        Blueprint ground = shapes::box({.size = {10 * size, 1}, .material = rough});
        ground.kind = BodyKind::fixed;
        world.add(ground, {.position = {0, -0.5}});
        std::vector<Body> crates;
        for (int i = 0; i < 20; ++i)
            crates.push_back(world.add(shapes::box({.size = {size, size}, .material = rough}),
                                       {.position = {0, side * (0.5 + i)}}));
        test::run(world, 10);
        double fastest = 0;
        for (int tick = 0; tick < 3500; ++tick) {
            world.step();
            fastest = std::max(fastest, speedOf(world, crates));
        }
        EXPECT_LT(fastest, 5e-3) << side;
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
