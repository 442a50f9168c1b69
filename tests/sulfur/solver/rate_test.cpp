#include "helpers.hpp"

namespace sulfur {
namespace {

/// The velocities stand in the middle of the last tick; a change of the rate must not kick too
/// hard or too little.
TEST(Rate, AFallDoesNotFeelItsChange) {
    World world({.tickRate = 500, .sleeping = false});
    const Body ball = world.add(shapes::ball());
    const Body crate = world.add(shapes::box(), {.position = {5, 0}});
    const Body rope = world.add(shapes::rope({.from = {9, 0}, .to = {10, 0}, .links = 5}));
    for (const int rate : {500, 60, 2000, 120, 10000, 500}) {
        world.setTickRate(rate);
        test::run(world, 0.25);
    }
    EXPECT_NEAR(world.time(), 1.5, 1e-12);
    const double fallen = 9.81 / 2 * 1.5 * 1.5;
    EXPECT_NEAR(world.position(ball.front())[1], -fallen, 1e-5);
    EXPECT_NEAR(world.centreOfMass(crate)[1], -fallen, 1e-5);
    EXPECT_NEAR(world.centreOfMass(rope)[1], -fallen, 1e-5);
}

TEST(Rate, ASwingingRopeKeepsItsEnergy) {
    World world({.sleeping = false});
    world.add(shapes::rope({.from = {0, 0}, .to = {2, 0}, .links = 10, .pinFirst = true}));
    world.step();
    const double start = world.energy();
    for (const int rate : {500, 250, 1000, 300, 2000}) {
        world.setTickRate(rate);
        test::run(world, 0.4);
    }
    EXPECT_NEAR(world.energy(), start, 0.02 * 0.5 * 9.81 * 1);
}

TEST(Rate, HowAJointIsSolvedFollows) {
    World world({.gravity = {0, 0}, .tickRate = 2000, .sleeping = false});
    Blueprint plan;
    plan.particles = {{}, {.position = {1, 0}}};
    plan.joints = {{.a = 0, .b = 1, .stiffness = 400000}};
    world.add(plan);
    world.step();
    EXPECT_EQ(world.statistics().explicitJoints, 1u);
    world.setTickRate(60);
    world.step();
    EXPECT_EQ(world.statistics().explicitJoints, 0u);
    EXPECT_EQ(world.statistics().implicitJoints, 1u);
}

TEST(Rate, RefusesWhatIsOutOfRange) {
    World world({.airFriction = 100});
    for (const int rate : {59, 10001, 0, -5, 80})
        test::expectRefused(world, ErrorCode::outOfRange, [&] { world.setTickRate(rate); });
}

/// The paper's damper brakes a turning pair, the axial one does not.
TEST(Damper, FullOneBrakesTurning) {
    for (const Damper damper : {Damper::axial, Damper::full}) {
        World world({.gravity = {0, 0}, .sleeping = false, .damper = damper});
        Blueprint plan;
        plan.particles = {{}, {.position = {1, 0}}};
        plan.joints = {{.a = 0, .b = 1, .stiffness = 1000, .damping = Real(0.1)}};
        const Body pair = world.add(plan);
        world.setVelocity(pair[0], {0, Real(-0.5)});
        world.setVelocity(pair[1], {0, Real(0.5)});
        test::run(world, 5);
        // The relative velocity decays with b (1/m + 1/m) where all of it is damped.
        const double expected = damper == Damper::full ? std::exp(-0.2 * 5) : 1;
        const double speed = (world.velocity(pair[1]) - world.velocity(pair[0])).norm();
        EXPECT_NEAR(speed, expected, 0.01);
    }
}

}  // namespace
}  // namespace sulfur
