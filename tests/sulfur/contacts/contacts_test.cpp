#include "core/settings.hpp"
#include "helpers.hpp"

namespace sulfur {
namespace {

TEST(Contacts, BallComesToRestOnTheFloor) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}, Real(0.1)));
    const Body ball = world.add(shapes::ball({.radius = Real(0.25)}), {.position = {0, 2}});
    test::run(world, 3);
    EXPECT_NEAR(world.position(ball.front())[1], 0.35, 1e-3);
    EXPECT_NEAR(world.velocity(ball.front()).norm(), 0, 1e-3);
}

TEST(Contacts, BoxAndJellyComeToRestOnTheFloor) {
    World world({.sleeping = false});
    world.add(shapes::floor({-5, 0}, {5, 0}, Real(0.05)));
    const Body box = world.add(shapes::box(), {.position = {-2, 1}, .angle = 0.3});
    const Body jelly = world.add(shapes::jelly({.damping = 4}), {.position = {2, 2}});
    test::run(world, 6);
    EXPECT_NEAR(world.centreOfMass(box)[1], 0.55, 5e-3);
    EXPECT_NEAR(world.centreOfMass(jelly)[1], 0.55, 0.03);
    EXPECT_LT(world.meanVelocity(box).norm(), 0.01);
    EXPECT_LT(world.meanVelocity(jelly).norm(), 0.01);
}

/// A frame of four rods may turn over, as pieces of broken walls do.
TEST(Contacts, WhatFallsOnAFrameThatIsTurnedOverStaysOnIt) {
    World world({.sleeping = false});
    Blueprint frame;
    for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
        frame.particles.push_back({.position = p, .pinned = true});
    for (std::uint32_t i = 0; i < 4; ++i)
        frame.joints.push_back({.a = i, .b = (i + 1) % 4, .radius = Real(0.02)});
    const auto corners = world.add(frame).particles();
    for (std::size_t i = 0; i < 4; ++i) {
        const Point at = world.position(corners[i]);
        world.setPosition(corners[i], Point(1 - at[0], at[1]));
    }
    const Body ball = world.add(shapes::ball({.radius = Real(0.1)}), {.position = {0.45, 1.3}});
    test::run(world, 2);
    EXPECT_NEAR(world.position(ball.front())[1], 1.12, 1e-3);
}

/// Loads of statics hold it from its first tick, in which half the weight acts, and the slop keeps
/// it from jittering.
TEST(Contacts, APyramidStandsFromItsFirstTick) {
    World world({.sleeping = false});
    world.add(shapes::floor({-20, 0}, {20, 0}, Real(0.05)));
    const Blueprint plan = shapes::box({.radius = Real(0.01)});
    constexpr int base = 12;
    // m, what may stay of overlaps between the top and the ground; single precision needs none of
    // it
    constexpr double slops = detail::tuned::slop * ((base - 1) * 0.02 + 0.06);
    std::vector<Body> boxes;
    std::vector<Point> places;
    for (int row = 0; row < base; ++row)
        for (int k = 0; k < base - row; ++k) {
            const Point place((k - (base - 1 - row) / 2.0) * 1.05, 0.55 + row);
            boxes.push_back(world.add(plan, {.position = place}));
            places.push_back(world.centreOfMass(boxes.back()));
        }
    for (int i = 0; i < 1000; ++i) {
        world.step();
        double farthest = 0;
        for (std::size_t k = 0; k < boxes.size(); ++k)
            farthest = std::max(farthest, (world.centreOfMass(boxes[k]) - places[k]).norm());
        ASSERT_LT(farthest, slops) << "tick " << i;
    }
}

TEST(Contacts, ReboundFollowsRestitution) {
    for (const Real e : {Real(0.5), Real(0.9)}) {
        World world({.sleeping = false});
        world.add(shapes::floor({-5, 0}, {5, 0}, Real(0.1)));
        const Body ball =
            world.add(shapes::ball({.radius = Real(0.1), .material = {.restitution = e}}),
                      {.position = {0, 2.2}});
        double highest = 0;
        bool bounced = false;
        for (int i = 0; i < 1000; ++i) {
            world.step();
            const double v = world.velocity(ball.front())[1];
            if (bounced && v < 0) break;
            bounced |= v > 0;
            if (bounced) highest = std::max(highest, world.position(ball.front())[1] - 0.2);
        }
        const double expected = 2 * static_cast<double>(e) * static_cast<double>(e);
        EXPECT_NEAR(highest / expected, 1, 0.03) << e;
    }
}

TEST(Contacts, FrictionHoldsOrLetsSlide) {
    const auto slide = [](Real friction, double slope) {
        World world({.sleeping = false});
        const Material surface{friction, friction, 0};
        const Real rise = static_cast<Real>(20 * std::tan(slope));
        world.add(shapes::ground(
            {.points = {{-20, -rise}, {20, rise}}, .radius = Real(0.05), .material = surface}));
        const double lift = (0.55 + 1e-4) / std::cos(slope);
        const Body box =
            world.add(shapes::box({.material = surface}), {.position = {0, lift}, .angle = slope});
        test::run(world, 1);
        return (world.centreOfMass(box) - Point(0, lift)).norm();
    };
    const double slope = 0.4, mu = std::tan(slope);
    EXPECT_LT(slide(static_cast<Real>(1.1 * mu), slope), 0.01);
    const double expected = 9.81 * (std::sin(slope) - 0.5 * mu * std::cos(slope)) / 2;
    EXPECT_NEAR(slide(static_cast<Real>(0.5 * mu), slope), expected, 0.03 * expected);
    EXPECT_NEAR(slide(0, slope), 9.81 * std::sin(slope) / 2, 0.03 * 9.81 * std::sin(slope) / 2);
}

TEST(Contacts, SoftPushesRigidAndRigidPushesSoft) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body box = world.add(shapes::box({.mass = 2}), {.position = {0, 0}});
    const Body jelly = world.add(shapes::jelly({.mass = 2}), {.position = {2, 0}});
    world.setVelocity(box, {2, 0});
    test::run(world, 3);
    const double a = world.meanVelocity(box)[0], b = world.meanVelocity(jelly)[0];
    EXPECT_NEAR(2 * a + 2 * b, 4, 0.01) << "momentum";
    EXPECT_GT(b, a);
    EXPECT_GT(b, 0.9);
}

TEST(Contacts, FastThingsDoNotPassThinWalls) {
    test::Random random(4);
    for (int shot = 0; shot < 100; ++shot) {
        World world({.gravity = {0, 0}, .sleeping = false});
        world.add(shapes::floor({0, -50}, {0, 50}, Real(0.02)));
        const double angle = random.uniform(0, 6);
        const Body thing =
            shot % 2 == 0 ? world.add(shapes::box({.size = {Real(0.3), Real(0.3)}}),
                                      {.position = {-2, 0}, .angle = angle})
                          : world.add(shapes::ball({.radius = Real(0.05)}), {.position = {-2, 0}});
        const double fastest = shot % 2 == 0 ? 40 : 300;
        world.setVelocity(thing, {static_cast<Real>(random.uniform(20, fastest)),
                                  static_cast<Real>(random.uniform(-20, 20))});
        test::run(world, 0.5);
        EXPECT_LT(world.centreOfMass(thing)[0], 0) << "shot " << shot;
        EXPECT_EQ(world.validate(), "");
    }
}

TEST(Contacts, OverlappingBodiesPartWithoutBeingThrown) {
    World world({.gravity = {0, 0}, .sleeping = false});
    std::vector<Body> balls;
    for (int i = 0; i < 10; ++i)
        balls.push_back(world.add(shapes::ball({.radius = Real(0.25)}),
                                  {.position = {0.05 * i, 0.01 * (i % 3)}}));
    double fastest = 0;
    for (int i = 0; i < 2000; ++i) {
        world.step();
        for (const Body& ball : balls)
            fastest = std::max(fastest, static_cast<double>(world.meanVelocity(ball).norm()));
    }
    EXPECT_LT(fastest, 1);
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_GT((world.centreOfMass(balls[i]) - world.centreOfMass(balls[k])).norm(), 0.49);
}

TEST(Contacts, FiltersDecide) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    Blueprint ghost = shapes::box();
    ghost.filter.mask = 0;
    const Body body = world.add(ghost, {.position = {0, 1}});
    test::run(world, 2);
    EXPECT_LT(world.centreOfMass(body)[1], -5);
    EXPECT_TRUE(mayCollide({1, 1, 5}, {2, 0, 5}));
    EXPECT_FALSE(mayCollide({1, 0xff, -5}, {1, 0xff, -5}));
    EXPECT_FALSE(mayCollide({1, 2, 0}, {1, 2, 0}));
}

TEST(Contacts, BeginIsToldOnce) {
    World world;
    const Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body ball = world.add(shapes::ball(), {.position = {0, 1.3}});
    int told = 0;
    for (int i = 0; i < 1000; ++i) {
        world.step();
        for (const ContactBegun& event : world.events().contactsBegun) {
            ++told;
            EXPECT_TRUE((event.a == ball.id() && event.b == floor.id()) ||
                        (event.b == ball.id() && event.a == floor.id()));
            EXPECT_NEAR(event.speed, std::sqrt(2 * 9.81 * 1), 0.1);
        }
    }
    EXPECT_EQ(told, 1);
}

TEST(Contacts, StackOfTenStands) {
    World world({.sleeping = false});
    world.add(shapes::floor({-20, 0}, {20, 0}));
    std::vector<Body> boxes;
    for (int i = 0; i < 10; ++i)
        boxes.push_back(world.add(shapes::box(), {.position = {0, 0.55 + i}}));
    test::run(world, 10);
    for (int i = 0; i < 10; ++i) {
        EXPECT_NEAR(world.centreOfMass(boxes[static_cast<std::size_t>(i)])[0], 0, 0.1) << i;
        EXPECT_NEAR(world.centreOfMass(boxes[static_cast<std::size_t>(i)])[1], 0.55 + i, 0.03) << i;
    }
}

/// Loads of statics are for what begins to rest, not for every step in which somebody is new.
TEST(Contacts, WhoComesElsewhereStirsNoPyramid) {
    const auto topAfter = [](bool othersCome) {
        World world({.sleeping = false});
        world.add(shapes::floor({-20, 0}, {20, 0}, Real(0.05)));
        Body top;
        for (int row = 0; row < 8; ++row)
            for (int k = 0; k < 8 - row; ++k)
                top = world.add(shapes::box(), {.position = {1.05 * (k + 0.5 * row), 0.55 + row}});
        for (int i = 0; i < 200; ++i) {
            if (othersCome) world.add(shapes::ball(), {.position = {1000.0 + 5 * i, 50}});
            world.step();
        }
        return world.centreOfMass(top);
    };
    EXPECT_EQ(topAfter(true), topAfter(false));
}

TEST(Contacts, KinematicBodyLiftsWhatLiesOnIt) {
    World world;
    Blueprint plan = shapes::floor({-2, 0}, {2, 0});
    plan.kind = BodyKind::kinematic;
    const Body lift = world.add(plan);
    const Body box = world.add(shapes::box(), {.position = {0, 0.55}});
    world.setVelocity(lift, {0, 1});
    test::run(world, 2);
    EXPECT_NEAR(world.centreOfMass(box)[1], 2.55, 0.02);
}

}  // namespace
}  // namespace sulfur
