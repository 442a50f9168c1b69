// Angular joints of bodies that are changed, limited, driven and broken.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr double fullTurn = 2 * std::numbers::pi;

/// Two arms of 1 m and 1 kg at each particle, straight along x, with an angle between them.
Blueprint elbow(const AngularJointSpec& angle = {}) {
    Blueprint plan{
        .particles = {{.position = {0, 0}}, {.position = {1, 0}}, {.position = {2, 0}}},
        .joints = {{.a = 0, .b = 1, .radius = Real(0.02)}, {.a = 1, .b = 2, .radius = Real(0.02)}},
        .angles = {angle}};
    plan.angles[0].a = 0;
    plan.angles[0].b = 1;
    plan.angles[0].c = 2;
    return plan;
}
/// The same, with its first arm held.
Blueprint forearm(const AngularJointSpec& angle = {}) {
    Blueprint plan = elbow(angle);
    plan.particles[0].pinned = plan.particles[1].pinned = true;
    return plan;
}

AngleInfo only(const World& world, BodyId body) {
    const auto angles = world.angles(body);
    EXPECT_EQ(angles.size(), 1u);
    return angles.at(0);
}

struct Spin {
    Point momentum{0, 0};
    double angular = 0;
};
Spin spinOf(const World& world, BodyId body) {
    Spin sum;
    for (const ParticleId id : world.particles(body)) {
        const ParticleInfo p = world.info(id);
        const Point momentum = static_cast<double>(p.mass) * p.velocity.cast<double>();
        sum.momentum += momentum;
        sum.angular += p.position.x() * momentum.y() - p.position.y() * momentum.x();
    }
    return sum;
}

TEST(DrivenAngles, AreAskedByTheirHandles) {
    World world;
    const Body body = world.add(elbow({.stiffness = 7, .damping = 2, .strength = 30}));
    const AngleInfo info = world.info(only(world, body).id);
    EXPECT_EQ(info.body, body.id());
    EXPECT_EQ(info.a, body[0]);
    EXPECT_EQ(info.b, body[1]);
    EXPECT_EQ(info.c, body[2]);
    EXPECT_EQ(info.drive.stiffness, 7);
    EXPECT_EQ(info.drive.damping, 2);
    EXPECT_EQ(info.drive.strength, 30);
    EXPECT_TRUE(world.contains(info.id));
    world.remove(body);
    EXPECT_FALSE(world.contains(info.id));
    test::expectRefused(world, ErrorCode::staleHandle, [&] { world.info(info.id); });
}

TEST(DrivenAngles, RefuseWhatIsNoDrive) {
    World world;
    const AngleId id = only(world, world.add(elbow())).id;
    const auto refused = [&](const Drive& drive) {
        test::expectRefused(world, ErrorCode::outOfRange, [&] { world.setDrive(id, drive); });
    };
    refused({.lower = 1, .upper = 0});
    refused({.stiffness = -1});
    refused({.rest = 4});
    refused({.lower = -1, .rest = 4});
    EXPECT_THROW(elbow({.lower = 1, .upper = 0}).validate(), Error);
    EXPECT_THROW(elbow({.motorMax = -1}).validate(), Error);
    EXPECT_THROW(elbow({.strength = 0}).validate(), Error);
}

/// A pendulum of springs goes at its frequency before and after its stiffness is changed.
TEST(DrivenAngles, SpringsAreChangedWhileTheyRun) {
    World world({.gravity = {0, 0}});
    const Body arm = world.add(forearm({.stiffness = 4, .restAngle = Real(0.1)}));
    const AngleId id = only(world, arm).id;
    const auto period = [&](double stiffness) {
        world.setDrive(id, {.stiffness = static_cast<Real>(stiffness), .rest = Real(0.1)});
        std::vector<double> ends;
        double before = world.info(id).angle;
        double rate = 0;
        while (ends.size() < 3 && world.time() < 60) {
            world.step();
            const double now = world.info(id).angle;
            if (rate > 0 && now < before) ends.push_back(world.time());
            rate = now - before;
            before = now;
        }
        return ends.at(2) - ends.at(1);
    };
    EXPECT_NEAR(period(4), fullTurn / 2, 0.01);  // inertia 1 kg m^2
    EXPECT_NEAR(period(36), fullTurn / 6, 0.01);
    world.setDrive(id, {.stiffness = 36, .damping = 12, .rest = Real(-0.5)});
    test::run(world, 4);
    EXPECT_NEAR(world.info(id).angle, -0.5, 1e-3);
}

TEST(DrivenAngles, AMotorTurnsAsFastAsItIsToldTo) {
    for (const int rate : {60, 500}) {
        World world({.gravity = {0, 0}, .tickRate = rate});
        const Body arm = world.add(forearm({.motorSpeed = 3, .motorMax = 100}));
        const AngleId id = only(world, arm).id;
        test::run(world, 1);
        const double before = world.info(id).angle;
        test::run(world, 3);
        // More than a whole turn.
        EXPECT_NEAR(world.info(id).angle - before, 9, 1e-3) << rate;
        EXPECT_LT(std::abs(static_cast<double>(world.info(id).torque)), 0.01) << rate;
    }
}

TEST(DrivenAngles, AMotorHoldsAgainstALoadWithItsTorque) {
    World world;
    const Body arm =
        world.add(forearm({.motorSpeed = 5, .motorMax = 10000, .motorTarget = Real(0.5)}),
                  {.position = {0, 5}});
    test::run(world, 2);
    const AngleInfo info = only(world, arm);
    EXPECT_NEAR(info.angle, 0.5, 1e-3);
    EXPECT_NEAR(static_cast<double>(info.torque), 9.81 * std::cos(0.5), 0.01);
    // Too weak, it slips, and gives all that it has.
    Drive weak = info.drive;
    weak.motorMax = 4;
    world.setDrive(info.id, weak);
    world.step();
    world.step();
    EXPECT_NEAR(static_cast<double>(world.info(info.id).torque), 4, 1e-3);
}

TEST(DrivenAngles, LimitsStopWithoutOvershoot) {
    for (const int rate : {60, 500}) {
        World world({.gravity = {0, 0}, .tickRate = rate});
        const Body arm = world.add(forearm({.lower = -1, .upper = Real(0.8)}));
        const AngleId id = only(world, arm).id;
        world.setVelocity(arm[2], {0, 10});
        double most = 0;
        std::size_t reached = 0;
        for (int i = 0; i < rate; ++i) {
            world.step();
            most = std::max(most, world.info(id).angle);
            for (const LimitReached& event : world.events().limitsReached) {
                EXPECT_EQ(event.angle, id);
                EXPECT_EQ(event.mechanism, MechanismId{});
                EXPECT_TRUE(event.upper);
                ++reached;
            }
        }
        EXPECT_NEAR(most, 0.8, 1e-4) << rate;
        EXPECT_EQ(reached, 1u) << rate;
        EXPECT_TRUE(world.mechanisms().empty());
    }
}

/// Stiffness has no border: rigid, it is one piece.
TEST(DrivenAngles, RigidOnesStayStraight) {
    World world;
    Blueprint plan;
    for (std::uint32_t i = 0; i < 9; ++i)
        plan.particles.push_back({.position = {Real(0.25) * static_cast<Real>(i), 0}});
    for (std::uint32_t i = 0; i < 8; ++i) plan.joints.push_back({.a = i, .b = i + 1});
    for (std::uint32_t i = 0; i < 7; ++i)
        plan.angles.push_back({.a = i, .b = i + 1, .c = i + 2, .stiffness = infinite});
    plan.particles[0].pinned = plan.particles[1].pinned = true;
    const Body beam = world.add(plan);
    test::run(world, 2);
    for (const ParticleId p : beam.particles()) EXPECT_NEAR(world.position(p).y(), 0, 1e-4);
    // The moment of what hangs beyond the clamp: masses of 1 kg at 0.25 to 1.75 m.
    EXPECT_NEAR(static_cast<double>(world.angles(beam)[0].torque), 9.81 * 7, 0.05);
}

TEST(DrivenAngles, KeepBothMomenta) {
    World world({.gravity = {0, 0}});
    const Body body =
        world.add(elbow({.lower = Real(-0.6), .upper = Real(0.6), .motorSpeed = 4, .motorMax = 20}),
                  {.position = {3, 1}, .angle = 0.3});
    body.setVelocity({1, 2}, 1);
    const Spin before = spinOf(world, body);
    test::run(world, 2);
    const Spin after = spinOf(world, body);
    EXPECT_NEAR((after.momentum - before.momentum).norm(), 0, 1e-4);
    EXPECT_NEAR(after.angular, before.angular, 1e-3);
}

TEST(DrivenAngles, BreakAndTellIt) {
    for (const Real limit : {infinite, Real(0.2)}) {  // elastic and driven
        World world;
        const Body arm =
            world.add(forearm({.stiffness = 2000, .damping = 50, .lower = -limit, .strength = 30}));
        const AngleId id = only(world, arm).id;
        test::run(world, 1);
        EXPECT_TRUE(world.contains(id));
        EXPECT_NEAR(static_cast<double>(world.info(id).torque), 9.81, 0.1);
        world.applyImpulse(arm[2], {0, -20});
        std::vector<AngleBroken> told;
        for (int i = 0; i < 500; ++i) {
            world.step();
            const auto& broken = world.events().anglesBroken;
            told.insert(told.end(), broken.begin(), broken.end());
        }
        ASSERT_EQ(told.size(), 1u);
        EXPECT_EQ(told[0].angle, id);
        EXPECT_EQ(told[0].body, arm.id());
        EXPECT_EQ(told[0].corner, arm[1]);
        EXPECT_GT(told[0].torque, 30);
        EXPECT_FALSE(world.contains(id));
        EXPECT_EQ(arm.joints().size(), 2u);
        EXPECT_EQ(world.validate(), "");
    }
}

/// A beam that is overloaded everywhere breaks where it is bent most.
TEST(DrivenAngles, ABeamBreaksAtItsRoot) {
    World world;
    Blueprint plan;
    for (std::uint32_t i = 0; i < 6; ++i)
        plan.particles.push_back({.position = {Real(0.2) * static_cast<Real>(i), 0}});
    for (std::uint32_t i = 0; i < 5; ++i) plan.joints.push_back({.a = i, .b = i + 1});
    for (std::uint32_t i = 0; i < 4; ++i)
        plan.angles.push_back(
            {.a = i, .b = i + 1, .c = i + 2, .stiffness = 1e6, .strength = Real(0.1)});
    plan.particles[0].pinned = plan.particles[1].pinned = true;
    const Body beam = world.add(plan);
    while (world.events().anglesBroken.empty() && world.time() < 1) world.step();
    ASSERT_EQ(world.events().anglesBroken.size(), 1u);
    EXPECT_EQ(world.events().anglesBroken[0].corner, beam[1]);
}

TEST(DrivenAngles, GoWithTheirJointsAndBodies) {
    World world({.gravity = {0, 0}});
    const AngularJointSpec driven{.upper = 1, .motorSpeed = 1, .motorMax = 500};
    const Body first = world.add(elbow(driven));
    const Body second = world.add(elbow(driven), {.position = {0, 2}});
    const Body third = world.add(elbow(driven), {.position = {0, 4}});
    const std::array ids{only(world, first).id, only(world, second).id, only(world, third).id};
    test::run(world, 0.1);
    world.remove(world.joints(first)[0]);
    world.remove(second);
    EXPECT_FALSE(world.contains(ids[0]));
    EXPECT_FALSE(world.contains(ids[1]));
    EXPECT_TRUE(world.contains(ids[2]));
    EXPECT_EQ(world.validate(), "");
    test::run(world, 0.2);
    EXPECT_NEAR(world.info(ids[2]).angle, 0.3, 0.01);
    world.remove(ids[2]);
    EXPECT_EQ(third.angles().size(), 0u);
    EXPECT_EQ(world.validate(), "");
    test::run(world, 0.2);
}

/// Of a body that falls apart the piece takes its motor along.
TEST(DrivenAngles, FollowThePieceThatTheyAreOf) {
    World world({.gravity = {0, 0}});
    Blueprint plan;
    for (std::uint32_t i = 0; i < 7; ++i)
        plan.particles.push_back({.position = {static_cast<Real>(i), 0}});
    for (std::uint32_t i = 0; i < 6; ++i)
        plan.joints.push_back({.a = i, .b = i + 1, .radius = Real(0.02)});
    plan.joints[3].strength = 1;
    for (const std::uint32_t i : {0u, 4u})
        plan.angles.push_back(
            {.a = i, .b = i + 1, .c = i + 2, .motorSpeed = 2, .motorMax = 100, .strength = 1e5});
    const Body body = world.add(plan);
    const AngleId near = world.angles(body)[0].id, far = world.angles(body)[1].id;
    world.applyImpulse(body[6], {5, 0});
    for (int i = 0; i < 5; ++i) world.step();
    ASSERT_EQ(world.bodies().size(), 2u);
    EXPECT_EQ(world.validate(), "");
    EXPECT_NE(world.info(near).body, world.info(far).body);
    const double before = world.info(far).angle;
    test::run(world, 0.5);
    EXPECT_NEAR(world.info(far).angle - before, 1, 0.02);
    world.remove(world.info(far).body);
    EXPECT_EQ(world.validate(), "");
    EXPECT_TRUE(world.contains(near));
    EXPECT_FALSE(world.contains(far));
}

/// A body that is turned as a whole has not bent.
TEST(DrivenAngles, OutlastATurnOfTheirBody) {
    for (double turn = -3.2; turn < 3.3; turn += 0.1) {
        World world({.gravity = {0, 0}});
        const Body body = world.add(elbow({.restAngle = Real(0.9), .lower = -1, .upper = 1}));
        world.setDrive(
            only(world, body).id,
            {.lower = -1, .upper = 1, .stiffness = 50, .damping = 10, .rest = Real(0.9)});
        test::run(world, 1);
        const double before = only(world, body).angle;
        body.setPose({.position = {4, 0}, .angle = turn});
        EXPECT_NEAR(only(world, body).angle, before, 1e-5) << turn;
        world.step();
        EXPECT_NEAR(only(world, body).angle, before, 1e-2) << turn;
        EXPECT_LT(test::speedOf(body), 0.01) << turn;
    }
}

TEST(DrivenAngles, GoOnAfterRestoreToTheBit) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body body =
        world.add(elbow({.upper = 2, .motorSpeed = 3, .motorMax = 20, .strength = 90}),
                  {.position = {-1, Real(0.5)}});
    test::run(world, 0.3);
    World other;
    other.restore(world.snapshot());
    EXPECT_EQ(other.hash(), world.hash());
    const Drive back{.lower = -1, .motorSpeed = -3, .motorMax = 20};
    for (World* each : {&world, &other}) {
        each->setDrive(each->angles(body)[0].id, back);
        test::run(*each, 0.5);
    }
    EXPECT_EQ(other.hash(), world.hash());
    EXPECT_LT(only(world, body).angle, 0.9);
    // What may break is another world than what may not.
    const auto hash = world.hash();
    Drive weak = back;
    weak.strength = 1000;
    other.setDrive(other.angles(body)[0].id, weak);
    EXPECT_NE(other.hash(), hash);
}

TEST(DrivenAngles, TakeTheirDriveAwayAgain) {
    World world({.gravity = {0, 0}});
    const Body arm = world.add(forearm({.motorSpeed = 3, .motorMax = 100}));
    const AngleId id = only(world, arm).id;
    test::run(world, 0.2);
    world.setDrive(id, {});
    EXPECT_EQ(world.validate(), "");
    test::run(world, 0.2);
    EXPECT_EQ(world.info(id).torque, 0);
    EXPECT_NEAR(static_cast<double>(world.velocity(arm[2]).norm()), 3,
                1e-3);  // it goes on by itself
    EXPECT_EQ(world.info(id).drive.motorMax, 0);
}

TEST(DrivenAngles, AreShown) {
    struct Recorder final : DebugDraw {
        std::vector<Angle> angles;
        std::size_t mechanisms = 0;
        void angle(const Angle& a) override { angles.push_back(a); }
        void mechanism(const Mechanism&) override { ++mechanisms; }
    } seen;
    World world;
    const Body body = world.add(elbow({.upper = 1}), {.position = {2, 3}});
    world.draw(seen);
    ASSERT_EQ(seen.angles.size(), 1u);
    EXPECT_EQ(seen.mechanisms, 0u);
    EXPECT_EQ(seen.angles[0].info.body, body.id());
    EXPECT_EQ(seen.angles[0].info.drive.upper, 1);
    EXPECT_EQ(seen.angles[0].a, Point(2, 3));
    EXPECT_EQ(seen.angles[0].b, Point(3, 3));
    EXPECT_EQ(seen.angles[0].c, Point(4, 3));
    world.draw(seen, {.angles = false});
    EXPECT_EQ(seen.angles.size(), 1u);
}

}  // namespace
}  // namespace sulfur
