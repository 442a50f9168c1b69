#include "helpers.hpp"

namespace sulfur {
namespace {

/// A bit of everything, in motion.
void fill(World& world) {
    world.add(shapes::ground({.points = {{-8, 9}, {-8, 0}, {8, 0}, {8, 9}}}));
    for (int i = 0; i < 12; ++i) {
        const Pose pose{{-5 + 0.9 * i, 1.5 + 1.3 * (i % 4)}, 0.2 * i};
        if (i % 3 == 0) world.add(shapes::box({.size = {Real(0.8), Real(0.6)}}), pose);
        if (i % 3 == 1) world.add(shapes::jelly({.size = {Real(0.7), Real(0.7)}}), pose);
        if (i % 3 == 2) world.add(shapes::ball(), pose);
    }
    const Body rope = world.add(shapes::rope({.from = {-3, 8}, .to = {1, 8}, .pinFirst = true}));
    const Body load =
        world.add(shapes::box({.size = {1, Real(0.5)}, .mass = 5}), {.position = {1, 7}});
    world.attach(rope.back(), load, {0, Real(0.25)});
    Blueprint glass = shapes::jelly({.strength = 40});
    glass.skin =
        Skin{"glass.png", std::vector<Vec2>(glass.particles.size(), Vec2(0, 0)), {{0, 1, 2}}};
    world.add(glass, {.position = {5, 5}});
}

TEST(Persist, RestoredWorldGoesOnWithTheSameHash) {
    World world;
    fill(world);
    test::run(world, 1);
    const Snapshot snapshot = world.snapshot();
    World other;
    other.restore(snapshot);
    EXPECT_EQ(other.hash(), world.hash());
    for (int i = 0; i < 1500; ++i) {
        world.step();
        other.step();
        ASSERT_EQ(other.hash(), world.hash()) << "tick " << i;
    }
    world.restore(snapshot);
    test::run(world, 3);
    EXPECT_EQ(world.hash(), other.hash());
    EXPECT_EQ(world.snapshot(), other.snapshot());
}

/// The shapes of a ground are made anew when something is tied to it, also those that only
/// sleepers lie on.
TEST(Persist, TyingToTheGroundOfSleepersIsNothingThatARestoreChanges) {
    World world, other;
    const Body ground = world.add(shapes::floor({-20, 0}, {20, 0}));
    for (int i = 0; i < 4; ++i) world.add(shapes::box(), {.position = {4.0 * i - 8, 0.6}});
    test::run(world, 3);
    ASSERT_EQ(world.statistics().awakeParticles, 0u);
    const Body rope = world.add(shapes::rope({.from = {0, 6}, .to = {3, 6}}));
    const AttachmentId tie = world.attach(rope[0], ground.id(), {0, 0});
    for (int i = 0; i < 400; ++i) {
        if (i == 100) world.remove(tie);
        if (i == 200) world.remove(rope);
        if (i == 201) world.add(shapes::ball(), {.position = {12, 3}});
        other.restore(world.snapshot());
        world.step();
        other.step();
        ASSERT_EQ(other.snapshot(), world.snapshot()) << i;
    }
}

TEST(Persist, HandlesAreValidAgain) {
    World world;
    const Body body = world.add(shapes::box());
    const Snapshot snapshot = world.snapshot();
    world.remove(body);
    EXPECT_FALSE(world.contains(body));
    world.restore(snapshot);
    EXPECT_TRUE(world.contains(body));
    EXPECT_EQ(body.size(), 5u);
}

TEST(Persist, ASnapshotTakesTheMemoryOfItsBytes) {
    for (const int boxes : {0, 1, 30, 100}) {
        World world;
        for (int i = 0; i < boxes; ++i) world.add(shapes::box(), {.position = {0, 2.0 * i}});
        const Snapshot snapshot = world.snapshot();
        EXPECT_EQ(snapshot.capacity(), snapshot.size()) << boxes;
    }
}

TEST(Persist, HashNoticesAnyChange) {
    World world;
    const Body body = world.add(shapes::box());
    const auto before = world.hash();
    world.setVelocity(body[0], {Real(1e-6), 0});
    EXPECT_NE(world.hash(), before);
}

TEST(Persist, LookingDoesNotChangeTheWayOn) {
    World looked, left;
    fill(looked);
    fill(left);
    for (int i = 0; i < 1000; ++i) {
        looked.step();
        left.step();
        looked.castSegment({-7, 1}, {7, 2});
        (void)looked.contacts();
        (void)looked.snapshot();
    }
    EXPECT_EQ(looked.hash(), left.hash());
}

/// Queries bring the grid up to date, but only ticks may choose how large its cells are.
TEST(Persist, LookingBetweenAdditionsDoesNotChangeTheWayOn) {
    World looked, left;
    for (World* world : {&looked, &left}) {
        world->add(shapes::ball({.radius = Real(0.01)}));
        if (world == &looked) world->castSegment({-7, 1}, {7, 2});
        world->add(shapes::floor({-50, -1}, {50, -1}));
        for (int i = 0; i < 5; ++i) {
            const Real size = Real(0.7) + Real(0.3) * static_cast<Real>(i);
            world->add(shapes::box({.size = {size, size}}), {.position = {2.0 * i, 1}});
            if (world == &looked) world->closestPoint({0, 0}, 10);
        }
    }
    for (int i = 0; i < 500; ++i) {
        looked.step();
        left.step();
        looked.overlapCircle({0, 0}, 3);
        ASSERT_EQ(looked.hash(), left.hash()) << i;
    }
}

TEST(Persist, ManyQueriesBetweenTicksChangeNothing) {
    World world({.sleeping = false}), other({.sleeping = false});
    for (World* w : {&world, &other}) {
        fill(*w);
        test::run(*w, 0.2);
    }
    for (int i = 0; i < 1000; ++i) {
        world.castSegment({-7, 1}, {7, 2});
        world.castShape(QueryShape::circle({0, 5}, 0.1), {0, -5});
        world.closestPoint({0, 5}, 10);
        world.bodiesAt({0.01 * i, 1});
    }
    EXPECT_EQ(world.hash(), other.hash());
    world.step();
    other.step();
    EXPECT_EQ(world.hash(), other.hash());
    EXPECT_EQ(world.statistics().boxes, other.statistics().boxes);
}

/// How much of a stiff spring at a rigid body is a force follows from where the body had turned to
/// when that was derived; adding a body elsewhere does not derive it again.
TEST(Persist, AWorldToWhichABodyWasJustAddedGoesOnTheSameWay) {
    for (int n = 0; n < 10; ++n) {
        World world;
        for (int i = 0; i < 6; ++i) {
            const Body box =
                world.add(shapes::box({.size = {Real(0.5), Real(0.3)}}), {{2.0 * i, 0}, 0.1 * i});
            const Body ball =
                world.add(shapes::ball({.radius = Real(0.1)}), {{2.0 * i + 0.6, 0.5}, 0});
            world.connect(box[1], ball[0],
                          {.stiffness = static_cast<Real>(300000 + 30000 * i), .damping = 1});
            world.setVelocity(ball[0], {0, 3});
        }
        test::run(world, 0.1 + 0.014 * n);
        for (int k = 0; k < 2; ++k) world.add(shapes::jelly(), {{100, 3.0 * k}, 0});
        World other;
        other.restore(world.snapshot());
        EXPECT_EQ(other.hash(), world.hash());
        EXPECT_EQ(other.snapshot(), world.snapshot());
        for (int tick = 0; tick < 3; ++tick) {
            world.step();
            other.step();
            ASSERT_EQ(other.hash(), world.hash()) << n << ", tick " << tick;
        }
    }
}

/// The same of damaged ones, which may name other bodies than those that were there.
TEST(Persist, DamagedSnapshotsAreRefused) {
    World world;
    fill(world);
    test::run(world, 0.2);
    const Snapshot good = world.snapshot();
    test::Random random(6);
    World victim;
    victim.add(shapes::ball());
    const auto before = victim.hash();
    Snapshot bad = good;
    bad[0] = std::byte{0};
    EXPECT_THROW(victim.restore(bad), Error);
    EXPECT_THROW(victim.restore({}), Error);
    for (int i = 0; i < 300; ++i) {
        bad = good;
        bad.resize(random.below(good.size()));
        EXPECT_THROW(victim.restore(bad), Error);
    }
    EXPECT_EQ(victim.hash(), before);
    for (int i = 0; i < 1000; ++i) {
        bad = good;
        bad[random.below(good.size())] ^= static_cast<std::byte>(1 + random.below(255));
        EXPECT_THROW(victim.restore(bad), Error) << i;
    }
}

/// While all rests no stage runs. What is changed then is not left for later, of which a restored
/// world would know nothing.
TEST(Persist, WhatIsChangedWhileAllRestsGoesOnAlike) {
    Blueprint lift = shapes::box();
    lift.kind = BodyKind::kinematic;
    using Change = void (*)(World&, const Body&, const Body&);
    const Change changes[] = {[](World& world, const Body&, const Body& driver) {
                                  world.applyForce(driver[0], Vec2(-87, 3));
                              },
                              [](World& world, const Body& floor, const Body&) {
                                  world.setMaterial(floor.id(), {.restitution = Real(0.5)});
                              },
                              [](World& world, const Body& floor, const Body&) {
                                  world.setMaterial(floor.joints()[0],
                                                    Material{.restitution = Real(0.5)});
                              }};
    for (const Change& change : changes) {
        World world, copy;
        const Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
        const Body driver = world.add(lift, {Point(0, 3), 0});
        test::run(world, 1);
        const auto idle = world.statistics().idleTicks;
        ASSERT_GT(idle, 0u);
        change(world, floor, driver);
        copy.restore(world.snapshot());
        for (int i = 0; i < 5; ++i) {
            world.step();
            copy.step();
            ASSERT_EQ(world.hash(), copy.hash())
                << "change " << &change - changes << ", tick " << i;
        }
        EXPECT_GT(world.statistics().idleTicks, idle);
    }
}

}  // namespace
}  // namespace sulfur
