// What counts as slow: by gravity, or as the caller wants it.
#include "helpers.hpp"

namespace sulfur {
namespace {

/// s until a body sleeps, or `most`.
double secondsAwake(World& world, BodyId body, double most) {
    while (!world.asleep(body) && world.time() < most) world.step();
    return world.time();
}

/// A crate of 2 mm where things fall slowly.
struct SlowWorlds : testing::Test {
    World world{{.gravity = {0, Real(-0.01)}}};
    Body floor = world.add(shapes::floor({-1, 0}, {1, 0}, Real(1e-4)));
    Body crate = world.add(
        shapes::box({.size = {Real(0.002), Real(0.002)}, .mass = Real(1e-5), .radius = Real(1e-4)}),
        {.position = {0, 1.1e-3}});
};

TEST_F(SlowWorlds, NothingFallsAsleepInTheAir) {
    crate.setVelocity({0, Real(0.005)});
    double highest = 0;
    while (world.time() < 1) {
        world.step();
        ASSERT_FALSE(world.asleep(crate)) << world.time();
        highest = std::max(highest, crate.centreOfMass().y());
    }
    EXPECT_NEAR(highest, 1.1e-3 + 0.005 * 0.005 / (2 * 0.01), 1e-5);
    EXPECT_LT(secondsAwake(world, crate, 20), 20);
    EXPECT_NEAR(crate.centreOfMass().y(), 1.1e-3, 5e-6);
    EXPECT_NEAR(crate.angle(), 0, 0.01);
}

TEST_F(SlowWorlds, NeitherDoesWhatHardlyWeighsAnything) {
    World earth;
    const Body ball = earth.add(shapes::ball());
    ball.setGravityScale(Real(0.001));
    ball.setVelocity({0, Real(0.006)});
    test::run(earth, 1.5);
    EXPECT_FALSE(earth.asleep(ball));
    EXPECT_LT(ball.meanVelocity().y(), -0.005);
    // What floats goes on for ever, unless something slows it.
    const Body floats = earth.add(shapes::ball(), {.position = {10, 0}});
    floats.setGravityScale(0);
    floats.setVelocity({0, Real(0.004)});
    test::run(earth, 1);
    EXPECT_FALSE(earth.asleep(floats));
    floats.setDamping(Real(0.1), 0);
    test::run(earth, 1);
    EXPECT_TRUE(earth.asleep(floats));
}

TEST_F(SlowWorlds, WhatFallsSlowlyRebounds) {
    crate.setPose({.position = {0, 0.0211}});
    for (const Body& one : {floor, crate}) world.setMaterial(one, {.restitution = 1});
    double fastest = 0;
    for (int i = 0; i < 1200; ++i) {
        world.step();
        fastest = std::max(fastest, static_cast<double>(crate.meanVelocity().y()));
    }
    EXPECT_NEAR(fastest, std::sqrt(2 * 0.01 * 0.02), 5e-4);
}

/// Where lengths are in millimetres, too: 5 mm/s is slow, 500 mm/s is not.
TEST_F(SlowWorlds, FollowALargeGravity) {
    const auto rebounds = [](Real speed, Real metre) {
        World one({.gravity = {0, Real(-9.81) * metre}, .sleeping = false});
        Blueprint plan = test::disc();
        plan.particles[0].radius *= metre;
        plan.material.restitution = 1;
        const double width = static_cast<double>(metre);
        const Body left = one.add(plan), right = one.add(plan, {.position = {1.001 * width, 0}});
        for (const Body& disc : {left, right}) disc.setGravityScale(0);
        left.setVelocity({speed * metre, 0});
        test::run(one, 1);
        const Vec2 parts = right.meanVelocity() - left.meanVelocity();
        return parts.x() > Real(0.5) * speed * metre;
    };
    for (const Real metre : {Real(1), Real(1000)}) {
        EXPECT_FALSE(rebounds(Real(0.005), metre)) << metre;
        EXPECT_TRUE(rebounds(Real(0.5), metre)) << metre;
    }
}

TEST_F(SlowWorlds, AsTheCallerWantsIt) {
    const auto sleepsAt = [](std::optional<Real> sleepSpeed) {
        World one({.gravity = {0, 0}, .sleepSpeed = sleepSpeed});
        const Body ball = one.add(shapes::ball());
        ball.setVelocity({Real(0.01), 0});
        test::run(one, 2);
        return one.asleep(ball);
    };
    EXPECT_FALSE(sleepsAt(std::nullopt));
    EXPECT_TRUE(sleepsAt(Real(0.02)));
    EXPECT_FALSE(sleepsAt(Real(0)));
    const auto partsAfter = [](std::optional<Real> reboundSpeed) {
        World one({.gravity = {0, 0}, .sleeping = false, .reboundSpeed = reboundSpeed});
        const Body left = one.add(test::disc()),
                   right = one.add(test::disc(), {.position = {1.02, 0}});
        for (const Body& disc : {left, right}) one.setMaterial(disc, {.restitution = 1});
        left.setVelocity({Real(0.05), 0});
        test::run(one, 2);
        return right.meanVelocity().x() - left.meanVelocity().x();
    };
    EXPECT_LT(partsAfter(Real(0.1)), 0.001);
    EXPECT_NEAR(partsAfter(Real(0.01)), 0.05, 0.001);
}

/// The values that a world of ordinary gravity has are those of before there were settings.
TEST_F(SlowWorlds, OrdinaryGravityChangesNothing) {
    const auto fall = [](const WorldSettings& settings) {
        World one(settings);
        one.add(shapes::floor({-5, 0}, {5, 0}));
        std::vector<Body> crates;
        for (int i = 0; i < 4; ++i)
            crates.push_back(one.add(shapes::box({.material = {.restitution = Real(0.5)}}),
                                     {.position = {0.1 * i, 0.7 + 1.2 * i}, .angle = 0.1 * i}));
        test::run(one, 4);
        std::vector<Point> places;
        for (const Body& crate : crates) places.push_back(crate.centreOfMass());
        return places;
    };
    EXPECT_EQ(fall({}), fall({.sleepSpeed = Real(0.005), .reboundSpeed = Real(0.1)}));
    EXPECT_NE(fall({}), fall({.reboundSpeed = Real(1)}));
}

TEST_F(SlowWorlds, SnapshotsKeepTheSettings) {
    World given({.sleepSpeed = Real(0.02), .reboundSpeed = Real(0.3)}), other;
    EXPECT_NE(given.hash(), other.hash());
    EXPECT_NE(World({.sleepSpeed = Real(0.3)}).hash(), World({.reboundSpeed = Real(0.3)}).hash());
    other.restore(given.snapshot());
    EXPECT_EQ(given.hash(), other.hash());
    EXPECT_EQ(other.settings().sleepSpeed, Real(0.02));
    EXPECT_EQ(other.settings().reboundSpeed, Real(0.3));
    other.restore(world.snapshot());
    EXPECT_FALSE(other.settings().sleepSpeed);
    EXPECT_THROW(World({.sleepSpeed = Real(-1)}), Error);
    EXPECT_THROW(World({.sleepSpeed = infinite}), Error);
    EXPECT_THROW(World({.reboundSpeed = Real(2001)}), Error);
}

}  // namespace
}  // namespace sulfur
