#include "helpers.hpp"

namespace sulfur {
namespace {

/// The error of the paper's method in free fall is that of rounding alone, once its first step is
/// half a kick.
TEST(Fall, OneSecondIsExactAtAnyRateAndPlace) {
    for (const int rate : {60, 100, 500, 2000, 10000}) {
        for (const double place : {0.0, 100.0, 1000.0}) {
            World world({.tickRate = rate});
            const Body ball = world.add(shapes::ball(), {.position = {place, place}});
            test::run(world, 1);
            const double fallen = place - world.position(ball.front())[1];
            EXPECT_NEAR(fallen, 9.81 / 2, rate == 10000 ? 1e-2 : 1e-3) << rate << " " << place;
        }
    }
}

TEST(Fall, SlowDriftFarFromTheOriginIsKept) {
    for (const int rate : {500, 10000}) {
        World world({.gravity = {0, 0}, .tickRate = rate});
        const Body ball = world.add(shapes::ball(), {.position = {1000, 0}});
        world.setVelocity(ball, {Real(0.01), 0});
        test::run(world, 10);
        EXPECT_NEAR(world.position(ball.front())[0] - 1000, 0.1, 0.001) << rate;
    }
}

TEST(Fall, ThrownBallFollowsItsParabola) {
    World world;
    const Body ball = world.add(shapes::ball());
    world.setVelocity(ball, {3, 4});
    EXPECT_EQ(world.velocity(ball.front()), Vec2(3, 4));
    test::run(world, 0.5);
    EXPECT_NEAR(world.position(ball.front())[0], 1.5, 1e-4);
    EXPECT_NEAR(world.position(ball.front())[1], 4 * 0.5 - 9.81 / 8, 1e-4);
}

TEST(Fall, AirFrictionGivesTheTerminalSpeed) {
    World world({.airFriction = 2});
    const Body ball = world.add(shapes::ball(), {.position = {0, 100}});
    test::run(world, 1);
    // v(t) = g / c (1 - exp(-c t)); velocity() stands for the middle of the last tick.
    EXPECT_NEAR(-world.velocity(ball.front())[1], 9.81 / 2 * (1 - std::exp(-2 * 0.999)), 1e-3);
    test::run(world, 9);
    EXPECT_NEAR(-world.velocity(ball.front())[1], 9.81 / 2, 1e-3);
}

TEST(Fall, ForcesAndImpulses) {
    World world({.gravity = {0, 0}});
    const Body ball = world.add(shapes::ball({.mass = 2}));
    world.applyImpulse(ball.front(), {4, 0});
    world.step();
    EXPECT_NEAR(world.velocity(ball.front())[0], 2, 1e-6);
    for (int i = 0; i < 500; ++i) {
        world.applyForce(ball.front(), {0, 6});
        world.step();
    }
    EXPECT_NEAR(world.velocity(ball.front())[1], 3, 1e-4);
    world.step();
    EXPECT_NEAR(world.velocity(ball.front())[1], 3, 1e-4) << "a force lasts one tick";
}

TEST(Fall, InterpolationLiesBetweenTheTicks) {
    World world;
    const Body ball = world.add(shapes::ball());
    world.setVelocity(ball, {5, 0});
    world.step();
    const Point before = world.position(ball.front());
    world.step();
    const Point after = world.position(ball.front());
    EXPECT_NEAR((world.interpolated(ball.front(), 0) - before).norm(), 0, 1e-9);
    EXPECT_NEAR((world.interpolated(ball.front(), 1) - after).norm(), 0, 1e-12);
    EXPECT_NEAR(world.interpolated(ball.front(), 0.25)[0], 0.01 + 0.0025, 1e-7);
}

TEST(Fall, PinnedParticlesStayUntilLetGo) {
    World world;
    const Body ball = world.add(shapes::ball());
    world.setPinned(ball.front(), true);
    test::run(world, 1);
    EXPECT_EQ(world.position(ball.front()), Point(0, 0));
    world.setPinned(ball.front(), false);
    test::run(world, 1);
    EXPECT_LT(world.position(ball.front())[1], -4);
}

TEST(Fall, KinematicBodiesGoWhereTheyAreTold) {
    World world;
    Blueprint plan = shapes::box();
    plan.kind = BodyKind::kinematic;
    const Body lift = world.add(plan);
    world.moveTo(lift, {.position = {0, 0.01}, .angle = 0});
    world.step();
    EXPECT_NEAR(world.centreOfMass(lift)[1], 0.01, 1e-8);
    world.step();
    EXPECT_NEAR(world.centreOfMass(lift)[1], 0.01, 1e-8);
    world.setVelocity(lift, {1, 0});
    test::run(world, 1);
    EXPECT_NEAR(world.centreOfMass(lift)[0], 1, 1e-5);
}

}  // namespace
}  // namespace sulfur
