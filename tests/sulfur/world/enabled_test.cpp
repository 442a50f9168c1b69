// Bodies that take no part for a while.
#include <algorithm>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// A floor with a crate on it, and a second crate on that.
struct Pile {
    explicit Pile(const WorldSettings& settings = {}) : world(settings) {
        world.add(shapes::floor({-5, 0}, {5, 0}));
        lower = world.add(shapes::box(), {.position = {0, 0.55}});
        upper = world.add(shapes::box(), {.position = {0, 1.55}});
    }
    World world;
    Body lower, upper;
};

TEST(Enabled, WhoIsOutStaysWhereItIsAndTouchesNothing) {
    for (const int rate : {60, 500}) {
        Pile pile({.tickRate = rate});
        World& world = pile.world;
        EXPECT_TRUE(pile.lower.isEnabled());
        test::run(world, 2);
        EXPECT_TRUE(pile.upper.asleep());
        const Pose before = pile.lower.pose();
        pile.lower.setEnabled(false);
        EXPECT_FALSE(pile.lower.isEnabled());
        EXPECT_FALSE(pile.lower.asleep());
        world.step();
        // With it end its contacts with the floor and with the crate that it bore.
        const auto& ended = world.events().contactsEnded;
        EXPECT_EQ(std::count_if(ended.begin(), ended.end(),
                                [&](const ContactEnded& e) {
                                    return e.a == pile.lower.id() || e.b == pile.lower.id();
                                }),
                  2);
        test::run(world, 2);
        EXPECT_EQ(pile.lower.pose().position, before.position);
        EXPECT_EQ(pile.lower.pose().angle, before.angle);
        EXPECT_LT(pile.upper.centreOfMass().y(), 0.6);  // it fell through
        EXPECT_EQ(world.validate(), "");
    }
}

TEST(Enabled, NobodyFindsWhoIsOut) {
    World world({.gravity = {0, 0}});
    const Body crate = world.add(shapes::box());
    const Body hall = world.add(shapes::box({.size = {4, 4}}));
    world.setSensor(hall, true);
    world.step();
    EXPECT_EQ(world.visitors(hall).size(), 1u);
    crate.setEnabled(false);
    const auto isFound = [&] {
        return world.castSegment({-3, 0}, {3, 0}).has_value() ||
               world.castRay({-3, 0}, {1, 0}, 9).has_value() || !world.bodiesAt({0, 0}).empty() ||
               !world.overlapBox({-1, -1}, {1, 1}).empty() ||
               !world.bodiesIn({-1, -1}, {1, 1}).empty() ||
               world.closestPoint({0, 0}, 5).has_value() ||
               world.castShape(QueryShape::circle({-3, 0}, 0.1), {6, 0}).has_value();
    };
    EXPECT_FALSE(isFound());
    world.step();
    EXPECT_FALSE(isFound());
    ASSERT_EQ(world.events().sensorsLeft.size(), 1u);
    EXPECT_EQ(world.events().sensorsLeft[0].visitor, crate.id());
    crate.setEnabled(true);
    EXPECT_TRUE(isFound());
    world.step();
    EXPECT_TRUE(isFound());
    EXPECT_EQ(world.visitors(hall).size(), 1u);
    hall.setEnabled(false);
    world.step();
    EXPECT_TRUE(world.visitors(hall).empty());
    EXPECT_TRUE(world.events().sensorsLeft.empty());
    EXPECT_EQ(world.validate(), "");
}

/// A ball that rolls through the air, a jelly that turns, a crate that turns: all go on to where
/// they would have been.
TEST(Enabled, ItComesBackAsItWas) {
    for (const Blueprint& plan : {shapes::box(), shapes::ball(), shapes::jelly()}) {
        const auto flight = [&](int pause) {
            World world({.gravity = {0, 0}, .sleeping = false});
            const Body body = world.add(plan);
            body.setVelocity({1, 2}, 3);
            test::run(world, 0.5);
            const Pose there = body.pose();
            if (pause > 0) {
                body.setEnabled(false);
                for (int i = 0; i < pause; ++i) world.step();
                EXPECT_EQ(body.pose().position, there.position);
                body.setEnabled(true);
            }
            test::run(world, 0.5);
            EXPECT_EQ(world.validate(), "");
            return body.pose();
        };
        const Pose without = flight(0), with = flight(100);
        EXPECT_NEAR((with.position - without.position).norm(), 0, 1e-5) << plan.name;
        EXPECT_NEAR(with.angle, without.angle, 1e-4) << plan.name;
    }
}

TEST(Enabled, WhatIsTiedToItIsFreeMeanwhile) {
    for (const bool attached : {false, true}) {
        World world({.sleeping = false});
        const Body hook = world.add(test::ofKind(shapes::box(), BodyKind::fixed));
        const Body weight = world.add(shapes::ball(), {.position = {0, -2}});
        if (attached)
            hook.attach(weight.front(), {0, -2});
        else
            world.connect(hook[0], weight.front());
        test::run(world, 0.5);
        EXPECT_GT(weight.centreOfMass().y(), -3);
        hook.setEnabled(false);
        const double start = weight.centreOfMass().y();
        const double speed = static_cast<double>(weight.meanVelocity().y());
        test::run(world, 0.5);
        EXPECT_NEAR(weight.centreOfMass().y(), start + speed / 2 - 9.81 / 8, 0.02) << attached;
        hook.setEnabled(true);
        test::run(world, 8);
        EXPECT_GT(weight.centreOfMass().y(), -3) << attached;
        EXPECT_EQ(world.validate(), "");
    }
}

TEST(Enabled, IsPartOfTheState) {
    Pile pile;
    test::run(pile.world, 1);
    const auto hash = pile.world.hash();
    const Snapshot before = pile.world.snapshot();
    pile.lower.setEnabled(false);
    EXPECT_NE(pile.world.hash(), hash);
    World other = pile.world.clone();
    EXPECT_FALSE(other.isEnabled(pile.lower));
    test::run(pile.world, 1);
    test::run(other, 1);
    EXPECT_EQ(other.hash(), pile.world.hash());
    pile.world.restore(before);
    EXPECT_TRUE(pile.lower.isEnabled());
    EXPECT_THROW(pile.world.setEnabled({}, false), Error);
}

TEST(Enabled, ForcesAndImpulsesDoNothingToWhoIsOut) {
    World world({.gravity = {0, 0}});
    const Body crate = world.add(shapes::box());
    world.step();
    crate.setEnabled(false);
    crate.applyImpulse({5, 0}, {0, 0});
    crate.applyForce({5, 0}, {0, 0});
    crate.applyTorque(5);
    world.applyForce(crate[0], {5, 0});
    world.applyImpulse(crate[0], {5, 0});
    EXPECT_FALSE(crate.putToSleep());
    world.step();
    crate.setEnabled(true);
    test::run(world, 0.1);
    EXPECT_NEAR(crate.centreOfMass().norm(), 0, 1e-15);
    crate.setEnabled(false);
    crate.setVelocity({1, 0});
    test::run(world, 0.1);
    EXPECT_NEAR(crate.centreOfMass().norm(), 0, 1e-15);
    crate.setEnabled(true);
    test::run(world, 0.1);
    EXPECT_NEAR(crate.centreOfMass().x(), 0.1, 1e-6);
}

/// Removed while it is out, it leaves lists and counts whole.
TEST(Enabled, WhoIsOutCanBeRemoved) {
    Pile pile;
    test::run(pile.world, 2);
    pile.lower.setEnabled(false);
    pile.world.step();
    pile.lower.remove();
    pile.world.step();
    EXPECT_FALSE(pile.lower.exists());
    EXPECT_EQ(pile.world.validate(), "");
    test::run(pile.world, 2);
    EXPECT_TRUE(pile.upper.asleep());
}

}  // namespace
}  // namespace sulfur
