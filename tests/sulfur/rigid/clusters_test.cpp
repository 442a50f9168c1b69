#include "helpers.hpp"

namespace sulfur {
namespace {

TEST(Clusters, ACrateIsOneAndItsJointsAreNotSolved) {
    World world;
    world.add(shapes::box());
    world.add(shapes::rope({.from = {3, 0}, .to = {4, 0}, .links = 4}));
    world.step();
    EXPECT_EQ(world.statistics().clusters, 1u);
    EXPECT_EQ(world.statistics().rigidJoints, 4u);
}

TEST(Clusters, ACutSetsThePartsFree) {
    World world({.gravity = {0, 0}});
    Blueprint plan;
    plan.particles = {{}, {.position = {1, 0}}, {.position = {1, 1}}, {.position = {0, 1}}};
    plan.joints = {
        {.a = 0, .b = 1}, {.a = 1, .b = 2}, {.a = 2, .b = 3}, {.a = 3, .b = 0}, {.a = 0, .b = 2}};
    const Body square = world.add(plan);
    world.step();
    EXPECT_EQ(world.statistics().clusters, 1u);
    world.remove(square.joints()[4]);
    world.step();
    EXPECT_EQ(world.statistics().clusters, 0u);
    EXPECT_EQ(world.statistics().rigidJoints, 4u);
    world.connect(square[1], square[3]);
    world.step();
    EXPECT_EQ(world.statistics().clusters, 1u);
}

/// Two triangles on a common corner: momentum, spin and the corner are kept.
TEST(Clusters, AHingeHoldsTwoTogether) {
    World world({.gravity = {0, 0}, .sleeping = false});
    Blueprint plan;
    plan.particles = {{},
                      {.position = {-1, 1}},
                      {.position = {-1, -1}},
                      {.position = {1, 1}, .mass = 3},
                      {.position = {1, -1}, .mass = 3}};
    plan.joints = {{.a = 0, .b = 1}, {.a = 1, .b = 2}, {.a = 2, .b = 0},
                   {.a = 0, .b = 3}, {.a = 3, .b = 4}, {.a = 4, .b = 0}};
    const Body scissors = world.add(plan);
    world.setVelocity(scissors[1], {1, 0});
    world.setVelocity(scissors[4], {0, 2});
    world.step();
    EXPECT_EQ(world.statistics().clusters, 2u);
    const double energy = world.energy();
    const Vec2 velocity = world.meanVelocity(scissors);
    test::run(world, 20);
    EXPECT_NEAR(world.energy(), energy, 0.001 * energy);
    EXPECT_NEAR((world.meanVelocity(scissors) - velocity).norm(), 0, 1e-4);
    for (const auto& [a, b, length] :
         {std::tuple(0, 1, std::sqrt(2.0)), {1, 2, 2.0}, {0, 3, std::sqrt(2.0)}, {3, 4, 2.0}}) {
        const auto at = [&](int i) {
            return world.position(scissors[static_cast<std::size_t>(i)]);
        };
        EXPECT_NEAR((at(a) - at(b)).norm(), length, 1e-6);
    }
}

TEST(Clusters, OnePinIsAPivotTwoPinsHold) {
    World world({.sleeping = false});
    const Body crate = world.add(shapes::box());
    world.setPinned(crate[0], true);
    const Point pin = world.position(crate[0]);
    test::run(world, 0.3);
    EXPECT_EQ(world.position(crate[0]), pin);
    EXPECT_GT((world.position(crate[2]) - Point(0.48, 0.48)).norm(), 0.1);
    world.setPinned(crate[2], true);
    const Point other = world.position(crate[1]);
    test::run(world, 1);
    EXPECT_EQ(world.position(crate[1]), other);
    world.setPinned(crate[0], false);
    world.setPinned(crate[2], false);
    test::run(world, 1);
    EXPECT_LT(world.centreOfMass(crate)[1], -4);
}

/// A caller may bend a crate; it comes back into shape and then moves as one again.
TEST(Clusters, ABentCrateRecovers) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body crate = world.add(shapes::box());
    world.step();
    const Point corner = world.position(crate[0]);
    world.setPosition(crate[0], corner + Point(0.05, 0.1));
    world.step();
    EXPECT_EQ(world.statistics().clusters, 0u);
    test::run(world, 2);
    EXPECT_EQ(world.statistics().clusters, 1u);
    EXPECT_NEAR((world.position(crate[0]) - world.position(crate[1])).norm(), 0.96, 1e-3);
    EXPECT_EQ(world.validate(), "");
}

TEST(Clusters, ImpulsesGoWhereTheyAct) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body crate = world.add(shapes::box({.size = {1, 1}, .mass = 2}));
    world.applyImpulse(crate[1], {0, 3});  // right, below the middle
    world.step();
    EXPECT_NEAR(world.meanVelocity(crate)[1], 1.5, 1e-6);
    // L = r x p = 0.48 * 3; I = m (w^2 + h^2) / 12.
    const double spin = 0.48 * 3 / (2.0 / 6);
    const double relative =
        static_cast<double>((world.velocity(crate[2]) - world.velocity(crate[0])).norm()) /
        (0.96 * std::sqrt(2));
    EXPECT_NEAR(relative, spin, 1e-3 * spin);
}

}  // namespace
}  // namespace sulfur
