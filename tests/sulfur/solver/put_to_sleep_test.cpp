// Falling asleep as the caller wants it.
#include "helpers.hpp"

namespace sulfur {
namespace {

/// Two crates on each other and one aside, all awake.
struct PutToSleep : testing::Test {
    World world;
    Body floor = world.add(shapes::floor({-8, 0}, {8, 0}));
    Body lower = world.add(shapes::box(), {.position = {0, 0.55}});
    Body upper = world.add(shapes::box(), {.position = {0, 1.55}});
    Body lonely = world.add(shapes::box(), {.position = {5, 0.55}});
    PutToSleep() { test::run(world, 0.1); }

    void expectRefused(BodyId body) {
        const auto before = world.hash();
        EXPECT_FALSE(world.putToSleep(body));
        EXPECT_EQ(world.hash(), before);
        EXPECT_EQ(world.validate(), "");
    }
};

TEST_F(PutToSleep, TakesTheIslandAlong) {
    EXPECT_FALSE(world.asleep(lower));
    EXPECT_TRUE(world.putToSleep(upper));
    EXPECT_TRUE(world.putToSleep(upper));
    for (int i = 0; i < 50; ++i) {
        EXPECT_TRUE(world.asleep(lower));
        EXPECT_TRUE(world.asleep(upper));
        EXPECT_FALSE(world.asleep(lonely));
        world.step();
    }
    world.wake(lower);
    EXPECT_FALSE(world.asleep(upper));
    EXPECT_EQ(world.validate(), "");
}

TEST_F(PutToSleep, KeepsWhatFliesWhereItIs) {
    for (const Blueprint& plan : {shapes::ball(), test::disc(), shapes::jelly()}) {
        const Body body = world.add(plan, {.position = {0, 8}});
        body.setVelocity({1, 2}, 3);
        test::run(world, 0.1);
        body.applyForce({500, 0}, body.centreOfMass());
        body.applyTorque(5);
        body.setVelocity({1, 2}, 3);
        EXPECT_TRUE(world.putToSleep(body));
        const Pose place = body.pose();
        test::run(world, 1);
        EXPECT_TRUE(world.asleep(body));
        EXPECT_EQ(body.pose().position, place.position);
        EXPECT_EQ(body.angle(), place.angle);
        EXPECT_EQ(test::speedOf(body), 0);
        EXPECT_EQ(body.angularVelocity(), 0);
        world.wake(body);
        test::run(world, 0.2);
        EXPECT_NEAR(body.centreOfMass().x(), place.position.x(), 1e-3);
        EXPECT_NEAR(body.angularVelocity(), 0, 1e-3);
        EXPECT_NEAR(test::speedOf(body), 9.81 * 0.2, 0.05);
        world.remove(body);
    }
}

TEST_F(PutToSleep, WhatComesNearWakesIt) {
    const Body crate = world.add(shapes::box(), {.position = {0, 8}});
    EXPECT_TRUE(world.putToSleep(crate));
    world.add(shapes::ball(), {.position = {0.2, 10}});
    test::run(world, 0.3);
    EXPECT_TRUE(world.asleep(crate));
    test::run(world, 0.7);
    EXPECT_FALSE(world.asleep(crate));
    EXPECT_LT(crate.centreOfMass().y(), 7.9);
}

TEST_F(PutToSleep, RefusesWhoMayNot) {
    expectRefused(floor);
    world.setSleepingAllowed(lower, false);
    expectRefused(upper);
    expectRefused(lower);
    EXPECT_TRUE(world.putToSleep(lonely));
    world.setSleepingAllowed(lower, true);
    EXPECT_TRUE(world.putToSleep(upper));
    const Body gone = world.add(shapes::box(), {.position = {-5, 3}});
    world.remove(gone);
    test::expectRefused(world, ErrorCode::staleHandle, [&] { world.putToSleep(gone); });
    test::expectRefused(world, ErrorCode::staleHandle, [&] { world.sleepingAllowed(gone); });
    test::expectRefused(world, ErrorCode::staleHandle,
                        [&] { world.setSleepingAllowed(gone, true); });
    World wakeful({.sleeping = false});
    const Body crate = wakeful.add(shapes::box());
    EXPECT_FALSE(wakeful.putToSleep(crate));
    EXPECT_FALSE(wakeful.asleep(crate));
}

TEST_F(PutToSleep, RefusesWhoIsDriven) {
    Blueprint plan = shapes::box({.size = {4, 1}});
    plan.kind = BodyKind::kinematic;
    const Body platform = world.add(plan, {.position = {0, 5}});
    const Body rider = world.add(shapes::box(), {.position = {0, 6.05}});
    test::run(world, 0.1);
    world.setVelocity(platform, {Real(0.4), 0});
    expectRefused(rider);
    world.setVelocity(platform, {0, 0});
    EXPECT_TRUE(world.putToSleep(rider));
}

TEST_F(PutToSleep, NobodySleepsBesideWhoMayNot) {
    EXPECT_TRUE(world.sleepingAllowed(lower));
    const auto before = world.hash();
    world.setSleepingAllowed(lower, true);
    EXPECT_EQ(world.hash(), before);
    test::run(world, 3);
    ASSERT_TRUE(world.asleep(lower));
    world.setSleepingAllowed(lower, false);
    EXPECT_FALSE(world.asleep(lower));
    EXPECT_FALSE(world.asleep(upper));
    World other;
    other.restore(world.snapshot());
    for (World* one : {&world, &other}) {
        test::run(*one, 3);
        EXPECT_FALSE(one->sleepingAllowed(lower));
        EXPECT_FALSE(one->asleep(lower));
        EXPECT_FALSE(one->asleep(upper));
        EXPECT_TRUE(one->asleep(lonely));
    }
    EXPECT_EQ(other.hash(), world.hash());
    world.setSleepingAllowed(lower, true);
    test::run(world, 3);
    EXPECT_TRUE(world.asleep(lower));
}

}  // namespace
}  // namespace sulfur
