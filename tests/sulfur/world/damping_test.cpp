// Damping of single bodies.
#include "helpers.hpp"

namespace sulfur {
namespace {

/// s, from the place of velocities to the end of the tick.
double halfStep(const World& world) {
    return static_cast<double>(world.tickDuration()) / world.statistics().substeps / 2;
}

/// kg m^2/s, about its centre of mass.
double turningOf(const Body& body) {
    return static_cast<double>(body.inertia()) * body.angularVelocity();
}

TEST(Damping, SlowsDownAsTheLawSays) {
    for (const int rate : {60, 500})
        for (const Blueprint& plan :
             {shapes::box(), shapes::ball(), shapes::jelly(), test::disc()}) {
            World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
            const Body body = world.add(plan), other = world.add(plan, {.position = {20, 0}});
            body.setDamping(2, Real(0.5));
            EXPECT_EQ(body.linearDamping(), Real(2));
            EXPECT_EQ(body.angularDamping(), Real(0.5));
            EXPECT_EQ(other.linearDamping(), Real(0));
            for (const Body& one : {body, other}) one.setVelocity({3, -1}, 2);
            const double before = turningOf(body);
            test::run(world, 1);
            const double t = world.time() - halfStep(world);
            EXPECT_NEAR(body.meanVelocity().x(), 3 * std::exp(-2 * t), 1e-4);
            EXPECT_NEAR(body.meanVelocity().y(), -std::exp(-2 * t), 1e-4);
            EXPECT_NEAR(turningOf(body), before * std::exp(-0.5 * t), 2e-3 * before);
            EXPECT_NEAR(other.meanVelocity().x(), 3, 1e-5);
            EXPECT_NEAR(turningOf(other), before, 2e-3 * before);
        }
}

TEST(Damping, IsAirFrictionOfOneBody) {
    for (const Real air : {Real(0), Real(1)}) {
        World world({.airFriction = air, .sleeping = false});
        World thick({.airFriction = air + 3, .sleeping = false});
        const Body body = world.add(shapes::box()), same = thick.add(shapes::box());
        body.setDamping(3, 3);
        for (const Body& one : {body, same}) one.applyAngularImpulse(1);
        for (World* one : {&world, &thick}) test::run(*one, 1);
        EXPECT_NEAR(body.centreOfMass().y(), same.centreOfMass().y(), 1e-4);
        EXPECT_NEAR(body.angularVelocity(), same.angularVelocity(), 1e-2 * same.angularVelocity());
        for (World* one : {&world, &thick}) test::run(*one, 9);
        const double terminal = -9.81 / (3 + static_cast<double>(air));
        EXPECT_NEAR(body.meanVelocity().y(), terminal, 1e-5);
        EXPECT_NEAR(same.meanVelocity().y(), terminal, 1e-5);
    }
}

TEST(Damping, OfTurningKeepsMomentum) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body body = world.add(shapes::jelly());
    body.setDamping(0, 100);
    body.setVelocity({1, 2}, 5);
    test::run(world, 1);
    EXPECT_NEAR(body.meanVelocity().x(), 1, 1e-12);
    EXPECT_NEAR(body.meanVelocity().y(), 2, 1e-12);
    EXPECT_NEAR(body.angularVelocity(), 0, 1e-3);
}

/// Two particles at a spring swing on, although what they do together is damped.
TEST(Damping, BrakesNoDeformation) {
    const auto swing = [](Real damping) {
        World world({.gravity = {0, 0}, .sleeping = false});
        const Body body = world.add({.particles = {{}, {.position = {1, 0}}},
                                     .joints = {{.a = 0, .b = 1, .stiffness = 100}}});
        body.setDamping(damping, damping);
        world.setVelocity(body[0], {1, 0});
        test::run(world, 5);
        return (world.position(body[1]) - world.position(body[0])).norm();
    };
    EXPECT_NEAR(swing(20), swing(0), 1e-5);
    EXPECT_GT(std::abs(swing(0) - 1), 0.01);
}

TEST(Damping, BrakesWhatTurnsAboutAPin) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body body = world.add(shapes::box());
    world.setPinned(body[0], true);
    body.setDamping(2, 2);
    body.setVelocity({0, 0}, 3);
    world.step();
    const double first = body.angularVelocity();
    test::run(world, 1);
    EXPECT_GT(std::abs(first), 0.1);
    EXPECT_NEAR(body.angularVelocity() / first, std::exp(-2), 1e-3);
}

TEST(Damping, BringsARopeToRest) {
    const auto speedOf = [](Real damping) {
        World world({.sleeping = false});
        const Body rope = world.add(shapes::rope(
            {.from = {0, 0}, .to = {2, 0}, .links = 12, .radius = 0, .pinFirst = true}));
        rope.setDamping(damping, damping);
        test::run(world, 6);
        double fastest = 0;
        for (const ParticleId i : rope.particles())
            fastest = std::max(fastest, static_cast<double>(world.velocity(i).norm()));
        EXPECT_LT(test::largestStrain(world, rope), 1e-4);
        return fastest;
    };
    EXPECT_LT(speedOf(5), speedOf(0) / 2);
}

TEST(Damping, IsKeptBySnapshotsAndByPieces) {
    World world({.sleeping = false}), other;
    const auto plain = world.add(shapes::box(), {.position = {20, 0}});
    const Body wall = world.add(shapes::wall({.strength = 1}));
    const auto before = world.hash();
    wall.setDamping(0, 0);
    EXPECT_EQ(world.hash(), before);
    wall.setDamping(1, 2);
    EXPECT_NE(world.hash(), before);
    world.applyImpulse(wall.front(), {-30, 0});
    test::run(world, 0.1);
    ASSERT_GT(world.bodies().size(), 2u);
    world.remove(plain);
    other.restore(world.snapshot());
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(other.hash(), world.hash());
        world.step();
        other.step();
    }
    for (const BodyId id : other.bodies()) {
        EXPECT_EQ(other.linearDamping(id), Real(1));
        EXPECT_EQ(other.angularDamping(id), Real(2));
    }
}

TEST(Damping, RefusesWhatIsOutOfRange) {
    World world;
    const Body body = world.add(shapes::box()), gone = world.add(shapes::box());
    world.remove(gone);
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    test::expectRefused(world, ErrorCode::notFinite, [&] { body.setDamping(nan, 0); });
    test::expectRefused(world, ErrorCode::notFinite, [&] { body.setDamping(0, infinite); });
    test::expectRefused(world, ErrorCode::outOfRange, [&] { body.setDamping(-1, 0); });
    test::expectRefused(world, ErrorCode::outOfRange, [&] { body.setDamping(0, 501); });
    test::expectRefused(world, ErrorCode::staleHandle, [&] { gone.setDamping(1, 1); });
    test::expectRefused(world, ErrorCode::staleHandle, [&] { gone.linearDamping(); });
    test::expectRefused(world, ErrorCode::staleHandle, [&] { gone.angularDamping(); });
    body.setDamping(0, 400);
    test::expectRefused(world, ErrorCode::outOfRange, [&] { world.setTickRate(300); });
    world.setTickRate(400);
    test::run(world, 1);
    EXPECT_EQ(world.validate(), "");
}

/// The first kick of a tick that is shorter than the last one is longer than it.
TEST(Damping, TurnsNothingAroundWhereTheRateChanges) {
    World world({.gravity = {0, 0}, .tickRate = 60});
    const Body box = world.add(shapes::box());
    box.setVelocity({10, 0}, 5);
    world.step();
    world.setTickRate(10000);
    box.setDamping(10000, 10000);
    world.step();
    EXPECT_GE(box.meanVelocity()[0], Real(-1e-4));
    EXPECT_GE(box.angularVelocity(), -1e-4);
}

}  // namespace
}  // namespace sulfur
