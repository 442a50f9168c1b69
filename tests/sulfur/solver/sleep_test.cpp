#include "helpers.hpp"

namespace sulfur {
namespace {

struct Lying : testing::Test {
    World world;
    Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    Body jelly = world.add(shapes::jelly({.damping = 4}), {.position = {0, 0.6}});
    Lying() { test::run(world, 8); }
};

TEST_F(Lying, FallsAsleepAndCostsNothing) {
    ASSERT_TRUE(world.asleep(jelly));
    EXPECT_EQ(world.statistics().awakeParticles, 0u);
    EXPECT_EQ(world.statistics().candidates, 0u);
    const Point before = world.centreOfMass(jelly);
    test::run(world, 1);
    EXPECT_EQ(world.centreOfMass(jelly), before);
}

TEST_F(Lying, WakesByForceGravityTouchAndLossOfSupport) {
    const auto state = world.snapshot();
    ASSERT_TRUE(world.asleep(jelly));
    world.applyForce(jelly[0], {1, 0});
    EXPECT_FALSE(world.asleep(jelly));
    world.restore(state);
    ASSERT_TRUE(world.asleep(jelly));
    world.setGravity({0, 1});
    EXPECT_FALSE(world.asleep(jelly));
    world.restore(state);
    world.add(shapes::ball(), {.position = {0, 3}});
    test::run(world, 1);
    EXPECT_FALSE(world.asleep(jelly));
    world.restore(state);
    world.remove(floor);
    EXPECT_FALSE(world.asleep(jelly));
    test::run(world, 1);
    EXPECT_LT(world.centreOfMass(jelly)[1], -3);
}

TEST(Sleep, CanBeSwitchedOff) {
    World world({.sleeping = false});
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body jelly = world.add(shapes::jelly({.damping = 4}), {.position = {0, 0.6}});
    test::run(world, 8);
    EXPECT_FALSE(world.asleep(jelly));
}

TEST(Sleep, SlowDriftIsNotRest) {
    World world({.gravity = {0, 0}});
    const Body ball = world.add(shapes::ball());
    world.setVelocity(ball, {Real(0.01), 0});
    test::run(world, 3);
    EXPECT_FALSE(world.asleep(ball));
}

}  // namespace
}  // namespace sulfur
