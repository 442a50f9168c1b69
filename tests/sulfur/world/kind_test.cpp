// Who moves a body can change.
#include "helpers.hpp"

namespace sulfur {
namespace {

TEST(Kind, WhatIsFixedFallsWhenItBecomesDynamic) {
    for (const Blueprint& plan : {test::ofKind(shapes::box(), BodyKind::fixed),
                                  test::ofKind(shapes::ball(), BodyKind::fixed)}) {
        World world({.sleeping = false});
        const Body body = world.add(plan, {.position = {0, 2}});
        test::run(world, 0.2);
        EXPECT_NEAR((body.centreOfMass() - Point(0, 2)).norm(), 0, 1e-15);
        body.setKind(BodyKind::dynamic);
        EXPECT_EQ(body.kind(), BodyKind::dynamic);
        test::run(world, 0.5);
        EXPECT_NEAR(body.centreOfMass().y(), 2 - 9.81 / 8, 1e-3);
        EXPECT_EQ(world.validate(), "");
    }
}

TEST(Kind, WhatBecomesFixedStopsAndBears) {
    World world;
    world.add(shapes::floor({-5, -9}, {5, -9}));
    const Body lower = world.add(shapes::box());
    const Body upper = world.add(shapes::box(), {.position = {0, 1.01}});
    test::run(world, 0.2);
    lower.setKind(BodyKind::fixed);
    const Point there = lower.centreOfMass();
    EXPECT_EQ(lower.meanVelocity(), Vec2(0, 0));
    EXPECT_THROW(lower.setVelocity({1, 0}), Error);
    test::run(world, 3);
    EXPECT_EQ(lower.centreOfMass(), there);
    EXPECT_NEAR(upper.centreOfMass().y() - there.y(), 1.1, 0.12);
    EXPECT_TRUE(upper.asleep());
    lower.setKind(BodyKind::dynamic);
    EXPECT_FALSE(upper.asleep());
    test::run(world, 0.3);
    EXPECT_LT(upper.centreOfMass().y(), there.y() + 0.8);
    EXPECT_EQ(world.validate(), "");
}

/// A rigid body goes on as it goes; back again too.
TEST(Kind, AKinematicBodyGoesOnWithItsMotion) {
    for (const Blueprint& plan : {shapes::box(), shapes::ball()})
        for (const int rate : {60, 500}) {
            World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
            const Body body = world.add(plan);
            body.setVelocity({1, Real(0.5)}, 2);
            test::run(world, 0.5);
            const Pose start = body.pose();
            body.setKind(BodyKind::kinematic);
            EXPECT_NEAR(body.pose().angle, start.angle, 1e-6);
            test::run(world, 0.5);
            const Pose middle = body.pose();
            EXPECT_NEAR((middle.position - start.position - Point(0.5, 0.25)).norm(), 0, 2e-3);
            if (plan.particles.size() > 1) {
                EXPECT_NEAR(middle.angle - start.angle, 1, 2e-3);
            }
            body.setKind(BodyKind::dynamic);
            test::run(world, 0.5);
            const Pose end = body.pose();
            EXPECT_NEAR((end.position - middle.position - Point(0.5, 0.25)).norm(), 0, 2e-2);
            EXPECT_NEAR(static_cast<double>(body.meanVelocity().x()), 1, 1e-3);
            EXPECT_EQ(world.validate(), "");
        }
}

/// A platform that is driven and let go has the momentum that its particles have.
TEST(Kind, WhatWasDrivenKeepsItsMomentum) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body body = world.add(test::ofKind(shapes::box(), BodyKind::kinematic));
    for (int i = 1; i <= 10; ++i) {
        body.moveTo({.position = {0.004 * i, 0}});
        world.step();
    }
    body.setKind(BodyKind::dynamic);
    EXPECT_NEAR(static_cast<double>(body.meanVelocity().x()), 2, 1e-3);
    test::run(world, 0.5);
    EXPECT_NEAR(static_cast<double>(body.meanVelocity().x()), 2, 1e-3);
    EXPECT_NEAR(body.centreOfMass().x(), 1.04, 1e-2);
}

TEST(Kind, TiesToWhatIsTooHeavyAreRefused) {
    World world;
    Blueprint light, heavy;
    light.kind = BodyKind::fixed;
    light.particles.push_back({.mass = Real(1e-6)});
    heavy.particles.push_back({.mass = Real(1e6)});
    const Body a = world.add(light), b = world.add(heavy, {.position = {1, 0}});
    world.connect(a.front(), b.front());
    const auto hash = world.hash();
    EXPECT_THROW(a.setKind(BodyKind::dynamic), Error);
    EXPECT_EQ(world.hash(), hash);
    EXPECT_EQ(a.kind(), BodyKind::fixed);
    // Two that never move may stay joined.
    b.setKind(BodyKind::fixed);
    test::run(world, 0.1);
    a.setKind(BodyKind::dynamic);
    test::run(world, 0.1);
    EXPECT_EQ(world.validate(), "");
}

TEST(Kind, GoesWithSnapshotsAndSoftBodies) {
    for (const BodyKind kind : {BodyKind::kinematic, BodyKind::fixed}) {
        World world;
        world.add(shapes::floor({-5, 0}, {5, 0}));
        const Body jelly = world.add(shapes::jelly(), {.position = {0, 1}});
        const Body rope =
            world.add(shapes::rope({.from = {-2, 3}, .to = {2, 3}, .links = 20, .pinFirst = true}));
        test::run(world, 0.5);
        jelly.setKind(kind);
        rope.setKind(kind);
        World other = world.clone();
        test::run(world, 0.5);
        test::run(other, 0.5);
        EXPECT_EQ(other.hash(), world.hash());
        jelly.setKind(BodyKind::dynamic);
        rope.setKind(BodyKind::dynamic);
        test::run(world, 1);
        EXPECT_LT(test::largestStrain(world, rope), 0.01);
        EXPECT_EQ(world.validate(), "");
    }
}

}  // namespace
}  // namespace sulfur
