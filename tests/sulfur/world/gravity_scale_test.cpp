// How much of gravity acts on a body.
#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr double gravity = 9.81;

TEST(GravityScale, FallsAsMechanicsSays) {
    for (const int rate : {60, 500})
        for (const Real scale : {Real(0), Real(0.5), Real(-1), Real(3)})
            for (const Blueprint& plan :
                 {shapes::box(), shapes::ball(), shapes::jelly(),
                  shapes::rope({.from = {0, 0}, .to = {1, 0}, .links = 6, .radius = 0})}) {
                World world({.tickRate = rate, .sleeping = false});
                const Body body = world.add(plan, {.position = {0, 2}});
                const Body other = world.add(plan, {.position = {5, 2}});
                body.setGravityScale(scale);
                EXPECT_EQ(body.gravityScale(), scale);
                const double start = body.centreOfMass().y(), energy = world.energy();
                test::run(world, 1);
                const double h = static_cast<double>(world.tickDuration());
                const double t = rate * h, fall = gravity / 2 * t * t;
                EXPECT_NEAR(body.centreOfMass().y(), start - static_cast<double>(scale) * fall,
                            1e-4 * fall);
                EXPECT_NEAR(other.centreOfMass().y(), start - fall, 1e-4 * fall);
                EXPECT_NEAR(world.energy(), energy, 0.01 * gravity * fall);
                EXPECT_NEAR(body.angularVelocity(), 0, 1e-4);
            }
}

/// s, of a rigid pendulum that is let go at a small angle.
double periodOf(Real scale) {
    World world({.sleeping = false});
    const Body body = world.add(shapes::rope(
        {.from = {0, 0}, .to = {Real(0.1), -2}, .links = 1, .radius = 0, .pinFirst = true}));
    body.setGravityScale(scale);
    int crossings = 0;
    double first = 0, last = 0, before = 1;
    for (int i = 0; i < 10000 && crossings < 5; ++i) {
        world.step();
        const double x = world.position(body.back()).x();
        if ((x < 0) != (before < 0)) {
            last = world.time();
            if (crossings++ == 0) first = last;
        }
        before = x;
    }
    return (last - first) / 2;
}

TEST(GravityScale, APendulumSwingsAsItsGravityHasIt) {
    EXPECT_NEAR(periodOf(4), periodOf(1) / 2, 0.005);
}

TEST(GravityScale, PressesAsMuchAsItWeighs) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body box = world.add(shapes::box({.mass = 2}), {.position = {0, 0.56}});
    const Body upper = world.add(shapes::box({.mass = 2}), {.position = {0, 1.57}});
    box.setGravityScale(3);
    upper.setGravityScale(Real(0.5));
    test::run(world, 3);
    EXPECT_TRUE(world.asleep(box));
    double pressed = 0;
    for (const ContactInfo& c : world.contacts())
        if (c.a != upper.id() && c.b != upper.id()) pressed += static_cast<double>(c.impulse);
    const double h = static_cast<double>(world.tickDuration());
    EXPECT_NEAR(pressed, (3 + 0.5) * 2 * gravity * h, 0.01 * 7 * gravity * h);
    EXPECT_NEAR(upper.centreOfMass().y(), 1.55, 0.01);
    // What rises lets what lay on it go along.
    box.setGravityScale(-1);
    EXPECT_FALSE(world.asleep(box));
    EXPECT_FALSE(world.asleep(upper));
    test::run(world, 1);
    EXPECT_GT(box.centreOfMass().y(), 1);
}

TEST(GravityScale, WhatFloatsFallsAsleepAndASnapshotKeepsIt) {
    World world, other;
    const Body body = world.add(shapes::box());
    const auto before = world.hash();
    body.setGravityScale(1);
    EXPECT_EQ(world.hash(), before);
    body.setGravityScale(0);
    EXPECT_NE(world.hash(), before);
    test::run(world, 0.2);
    other.restore(world.snapshot());
    EXPECT_EQ(other.hash(), world.hash());
    for (int i = 0; i < 400; ++i) {
        world.step();
        other.step();
        ASSERT_EQ(other.hash(), world.hash());
    }
    EXPECT_TRUE(world.asleep(body));
    EXPECT_LT(body.centreOfMass().norm(), 1e-6);
    body.setGravityScale(1);
    EXPECT_FALSE(world.asleep(body));
}

TEST(GravityScale, PiecesInheritIt) {
    World world({.sleeping = false});
    const Body wall = world.add(shapes::wall({.strength = 1}));
    wall.setGravityScale(0);
    world.applyImpulse(wall.front(), {-30, 0});
    test::run(world, 0.1);
    ASSERT_GT(world.bodies().size(), 1u);
    for (const BodyId id : world.bodies()) EXPECT_EQ(world.gravityScale(id), 0);
}

TEST(GravityScale, RefusesWhatIsOutOfRange) {
    World world;
    const Body body = world.add(shapes::box()), gone = world.add(shapes::box());
    world.remove(gone);
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    test::expectRefused(world, ErrorCode::notFinite, [&] { body.setGravityScale(nan); });
    test::expectRefused(world, ErrorCode::notFinite, [&] { body.setGravityScale(infinite); });
    test::expectRefused(world, ErrorCode::outOfRange, [&] { body.setGravityScale(1001); });
    test::expectRefused(world, ErrorCode::staleHandle, [&] { gone.setGravityScale(1); });
    test::expectRefused(world, ErrorCode::staleHandle, [&] { gone.gravityScale(); });
}

/// A box that is pinned at a corner swings, whether anybody looks at it between ticks or not: it
/// got up to 680,000 J where nobody did.
TEST(GravityScale, APendulumThatNobodyLooksAtKeepsItsEnergy) {
    for (const int rate : {60, 500})
        for (const Real scale : {Real(0), Real(2), Real(30)}) {
            const auto swing = [&](bool looks) {
                World world({.tickRate = rate, .sleeping = false});
                const Body box = world.add(shapes::box());
                world.setPinned(box[0], true);
                world.setGravityScale(box, scale);
                double most = 0;
                for (int i = 0; i < 5 * rate; ++i) {
                    world.step();
                    if (looks) most = std::max(most, std::abs(world.angularVelocity(box)));
                }
                return std::pair(world.hash(), std::max(most, std::abs(box.angularVelocity())));
            };
            const auto seen = swing(true), unseen = swing(false);
            EXPECT_EQ(seen.first, unseen.first) << rate << " Hz, " << scale;
            // It falls from 45 degrees above its pin: m g s (1/2 + l) = I w^2 / 2, l^2 = 1/2, I =
            // 2/3 m.
            const double falls = 9.81 * static_cast<double>(scale) * (std::sqrt(0.5) + 0.5);
            EXPECT_LE(unseen.second, 1.1 * std::sqrt(3 * falls) + 1e-6) << rate << ' ' << scale;
        }
}

/// Weight is no blow, however large: a stack stays.
TEST(GravityScale, AHeavyStackDoesNotJump) {
    World world({.sleeping = false});
    world.add(shapes::floor({-5, 0}, {5, 0}));
    std::vector<Body> boxes;
    for (int i = 0; i < 4; ++i) {
        boxes.push_back(world.add(shapes::box(), {.position = {0, 0.55 + 1.0 * i}}));
        world.setGravityScale(boxes.back(), 100);
    }
    test::run(world, 1);
    double fastest = 0;
    for (int i = 0; i < 500; ++i) {
        world.step();
        for (const Body& box : boxes)
            fastest = std::max(fastest, static_cast<double>(box.meanVelocity().norm()));
    }
    EXPECT_LT(fastest, 0.01);
}

}  // namespace
}  // namespace sulfur
