// What a Body does is what its world does with it.
#include "helpers.hpp"

namespace sulfur {
namespace {

TEST(Frames, PointsAndVectorsGoThereAndBack) {
    World world({.gravity = {0, 0}});
    for (const Blueprint& plan : {shapes::box(), shapes::ball(), shapes::jelly()}) {
        const Body body = world.add(plan, {.position = {30, -20}, .angle = 2});
        body.setVelocity({1, 2}, 3);
        test::run(world, 0.3);
        const Pose pose = body.pose();
        EXPECT_NEAR((body.toWorld({0, 0}) - pose.position).norm(), 0, 1e-12);
        const Point local(0.7, -3), there = body.toWorld(local);
        const double c = std::cos(pose.angle), s = std::sin(pose.angle);
        EXPECT_NEAR((there - pose.position - Point(c * 0.7 + s * 3, s * 0.7 - c * 3)).norm(), 0,
                    1e-9);
        EXPECT_NEAR((body.toBody(there) - local).norm(), 0, 1e-9);
        const Vec2 vector = body.vectorToWorld({Real(0.7), -3});
        EXPECT_NEAR((vector.cast<double>() - (there - pose.position)).norm(), 0, 1e-5);
        EXPECT_NEAR(static_cast<double>((body.vectorToBody(vector) - Vec2(Real(0.7), -3)).norm()),
                    0, 1e-5);
        EXPECT_THROW(body.toWorld({1e10, 0}), Error);
        EXPECT_THROW(body.vectorToBody({infinite, 0}), Error);
    }
}

TEST(Body, DoesWhatItsWorldDoes) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body crate = world.add(shapes::box(), {.position = {0, 0.55}});
    const Body ball = world.add(shapes::ball(), {.position = {0, 3}});
    crate.setUserData(7);
    crate.setFilter({.category = 2});
    crate.setMaterial({.restitution = Real(0.5)});
    crate.setCollision(ball, false);
    crate.setSelfCollision(true);
    EXPECT_EQ(world.userData(crate), 7u);
    EXPECT_EQ(crate.userData(), 7u);
    EXPECT_EQ(crate.filter().category, 2u);
    EXPECT_EQ(crate.material().restitution, Real(0.5));
    EXPECT_FALSE(crate.collision(ball));
    EXPECT_TRUE(crate.selfCollision());
    EXPECT_EQ(crate.name(), world.name(crate));
    EXPECT_EQ(crate.kind(), BodyKind::dynamic);
    EXPECT_TRUE(crate.angles().empty());
    EXPECT_FALSE(crate.skin());
    crate.attach(ball.front(), {0, 2});
    EXPECT_EQ(world.attachments().size(), 1u);
    const GrabId grab = crate.grab({0, 0}, {1, 1});
    EXPECT_EQ(world.info(grab).body, crate.id());
    world.release(grab);
    test::run(world, 3);
    EXPECT_TRUE(crate.asleep());
    crate.wake();
    EXPECT_FALSE(crate.asleep());
    crate.setSleepingAllowed(false);
    EXPECT_FALSE(crate.sleepingAllowed() || crate.putToSleep());
    crate.setSleepingAllowed(true);
    EXPECT_TRUE(crate.putToSleep());
    ball.setSensor(true);
    EXPECT_TRUE(ball.sensor() && ball.visitors().empty());
    EXPECT_TRUE(crate.exists());
    crate.remove();
    EXPECT_FALSE(crate.exists());
    EXPECT_EQ(world.validate(), "");
}

TEST(Body, AKinematicOneIsMovedToAPose) {
    World world;
    const Body body = world.add(test::ofKind(shapes::box(), BodyKind::kinematic));
    body.moveTo({.position = {0.01, 0}, .angle = 0.01});
    world.step();
    EXPECT_NEAR(body.pose().position.x(), 0.01, 1e-9);
    EXPECT_NEAR(body.angle(), 0.01, 1e-9);
}

}  // namespace
}  // namespace sulfur
