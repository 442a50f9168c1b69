// Capsules that are arcs: exact curved surfaces on both sides, as terrain and as parts of bodies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sulfur/draw.hpp>
#include <sulfur/queries.hpp>
#include <sulfur/sulfur.hpp>
#include <tuple>
#include <utility>
#include <vector>

#include "helpers.hpp"
#include "kernels/rows.hpp"

namespace sulfur {
namespace {

constexpr double pi = 3.14159265358979, arcGravity = 9.81;
const Real halfTurn = Real(pi);

Material withFriction(double friction) {
    Material m;
    m.staticFriction = m.kineticFriction = static_cast<Real>(friction);
    return m;
}

/// A fixed arc, 0.1 m thick.
Blueprint arc(Vec2 from, Vec2 to, Real bend, const Material& material = {}) {
    return shapes::ground(
        {.points = {from, to}, .radius = Real(0.05), .material = material, .bends = {bend}});
}
Blueprint disc(double radius, const Material& material) {
    Blueprint plan;
    plan.material = material;
    plan.particles = {{.mass = 1, .radius = static_cast<Real>(radius)}};
    return plan;
}
World awakeWorld() {
    WorldSettings settings;
    settings.sleeping = false;
    return World(settings);
}

/// Mean time of a swing of what x() tells, s, from where it passes 0 downwards.
template <class Value>
double periodOf(World& world, double seconds, Value&& x) {
    double before = x(), first = -1, last = -1;
    int swings = -1;
    const double h = 1.0 / world.settings().tickRate;
    for (int i = 1; i * h <= seconds; ++i) {
        world.step();
        const double now = x();
        if (before > 0 && now <= 0) {
            last = (i - 1 + before / (before - now)) * h;
            if (++swings == 0) first = last;
        }
        before = now;
    }
    return (last - first) / swings;
}
/// Of a pendulum of that length, released at an angle (series of the elliptic integral).
double pendulumPeriod(double length, double angle) {
    const double a2 = angle * angle;
    return 2 * pi * std::sqrt(length / arcGravity) * (1 + a2 / 16 + 11 * a2 * a2 / 3072);
}

TEST(Arcs, WhatSlidesInABowlIsAPendulum) {
    World world = awakeWorld();
    world.add(arc({-2, 0}, {2, 0}, halfTurn, withFriction(0)));
    const double length = 2 - 0.05 - 0.1, angle = 0.3;
    const Body b = world.add(disc(0.1, withFriction(0)),
                             {.position = {length * std::sin(angle), -length * std::cos(angle)}});
    const auto x = [&] { return world.position(b[0]).x(); };
    EXPECT_NEAR(periodOf(world, 20, x) / pendulumPeriod(length, angle), 1, 1e-4);
    double most = 0;
    for (int i = 0; i < 2000; ++i) {
        world.step();
        most = std::max(most, x());
        EXPECT_NEAR(world.position(b[0]).norm(), length, 1e-4);
    }
    EXPECT_NEAR(most / (length * std::sin(angle)), 1, 0.01);
}

TEST(Arcs, WhatRollsInABowlIsSlowerByItsSpin) {
    World world = awakeWorld();
    world.add(arc({-2, 0}, {2, 0}, halfTurn, withFriction(1)));
    const double length = 2 - 0.05 - 0.1, angle = 0.2;
    const Body b = world.add(disc(0.1, withFriction(1)),
                             {.position = {length * std::sin(angle), -length * std::cos(angle)}});
    const double period = periodOf(world, 20, [&] { return world.position(b[0]).x(); });
    EXPECT_NEAR(period / pendulumPeriod(1.5 * length, angle), 1, 5e-4);
}

TEST(Arcs, WhatSlidesOffAHillLeavesItAtTwoThirds) {
    World world = awakeWorld();
    world.add(arc({-3, 0}, {3, 0}, -halfTurn, withFriction(0)));
    const double radius = 3 + 0.05 + 0.1, angle = 0.1;
    const Body b = world.add(disc(0.1, withFriction(0)),
                             {.position = {radius * std::sin(angle), radius * std::cos(angle)}});
    bool pressed = true;
    double cosine = 1;
    for (int i = 0; i < 3000 && pressed; ++i) {
        world.step();
        pressed = i < 5 || !world.contacts().empty();
        cosine = world.position(b[0]).y() / world.position(b[0]).norm();
    }
    EXPECT_FALSE(pressed);
    EXPECT_NEAR(cosine, 2.0 / 3 * std::cos(angle), 0.01);
}

/// Half a disc, hollow, its curved side below, and its centre of mass a quarter below the middle.
Blueprint rocker() {
    Blueprint plan;
    plan.material = withFriction(1);
    plan.particles = {{.position = {-1, 0}, .mass = 1},
                      {.position = {1, 0}, .mass = 1},
                      {.position = {0, Real(-0.5)}, .mass = 2}};
    plan.joints = {{.a = 0, .b = 1, .radius = Real(0.05), .bend = halfTurn},
                   {.a = 0, .b = 2},
                   {.a = 1, .b = 2}};
    return plan;
}

TEST(Arcs, ABodyWithACurvedSideRocksAsTheorySays) {
    World world = awakeWorld();
    world.add(shapes::ground({.points = {{-5, 0}, {5, 0}}, .material = withFriction(1)}));
    const Body b = world.add(rocker(), {.position = {0, 0.05 + 1.05}, .angle = 0.05});
    const double mass = 4, lever = 0.25, radius = 1.05;
    const double inertia = 2 * (1 + lever * lever) + 2 * lever * lever;
    const double reach = radius - lever;
    const double theory =
        2 * pi * std::sqrt((inertia + mass * reach * reach) / (mass * arcGravity * lever));
    EXPECT_NEAR(periodOf(world, 30, [&] { return world.angle(b); }) / theory, 1, 2e-3);
    const Point middle = (world.position(b[0]) + world.position(b[1])) / 2;
    EXPECT_NEAR(middle.y(), 0.05 + 1.05, 1e-3);
}

TEST(Arcs, ACurvedSideLiesInABowlAndOnAHill) {
    World world;
    world.add(arc({-3, 0}, {3, 0}, halfTurn, withFriction(1)));
    const Body inside = world.add(rocker(), {.position = {0.5, -1.5}});
    test::run(world, 5);
    const Point middle = (world.position(inside[0]) + world.position(inside[1])) / 2;
    EXPECT_NEAR(middle.norm(), 3 - 0.05 - 1.05, 2e-3);

    World other = awakeWorld();
    other.add(arc({-3, 0}, {3, 0}, -halfTurn, withFriction(1)));
    const Body above = other.add(rocker(), {.position = {0, 3 + 0.05 + 1.05}});
    test::run(other, 1);
    const Point top = (other.position(above[0]) + other.position(above[1])) / 2;
    EXPECT_NEAR(top.norm(), 3 + 0.05 + 1.05, 2e-3);
}

TEST(Arcs, ABoxAndAJellyLieOnAHill) {
    World world;
    world.add(arc({-3, 0}, {3, 0}, Real(-1), withFriction(1)));
    const double top = 3 / std::sin(0.5) * (1 - std::cos(0.5)) + 0.05;
    const Body box =
        world.add(shapes::box({.material = withFriction(1)}), {.position = {-1, top + 0.6}});
    const Body jelly =
        world.add(shapes::jelly({.material = withFriction(1)}), {.position = {1, top + 0.8}});
    test::run(world, 5);
    const double radius = 3 / std::sin(0.5);
    const Point centre(0, -radius * std::cos(0.5));
    for (const Body* body : {&box, &jelly})
        for (std::size_t i = 0; i < body->size(); ++i)
            EXPECT_GT((world.position((*body)[i]) - centre).norm(), radius + 0.05);
    EXPECT_LT((world.centreOfMass(box) - centre).norm(), radius + 0.05 + 0.6);
}

TEST(Arcs, WhatRollsMeetsNoBumpWhereTangentsGoOn) {
    // A ramp that ends in a quarter of a circle and goes on level.
    const Real radius = 2;
    World world = awakeWorld();
    world.add(shapes::ground({.points = {{0, 2}, {2, 0}, {20, 0}},
                              .radius = Real(0.05),
                              .material = withFriction(0),
                              .bends = {Real(pi / 2), 0}}));
    const double gone = static_cast<double>(radius) - 0.05 - 0.1;
    const Body b = world.add(disc(0.1, withFriction(0)),
                             {.position = {2 - gone * std::cos(0.3), 2 - gone * std::sin(0.3)}});
    const double fall = world.position(b[0]).y() - (0.05 + 0.1);
    test::run(world, 1.5);
    EXPECT_GT(world.position(b[0]).x(), 3);
    EXPECT_NEAR(static_cast<double>(world.velocity(b[0]).norm()) / std::sqrt(2 * arcGravity * fall),
                1, 2e-3);
    EXPECT_NEAR(world.position(b[0]).y(), 0.15, 1e-3);
}

TEST(Arcs, ADrumTurnsWhatIsInIt) {
    Blueprint drum;
    drum.kind = BodyKind::kinematic;
    drum.material = withFriction(1);
    drum.particles = {{.position = {-1, 0}}, {.position = {1, 0}}};
    drum.joints = {{.a = 0, .b = 1, .radius = Real(0.05), .bend = halfTurn},
                   {.a = 1, .b = 0, .radius = Real(0.05), .bend = halfTurn}};
    WorldSettings settings;
    settings.gravity = {0, 0};
    settings.sleeping = false;
    World world(settings);
    const Body b = world.add(drum);
    const Body ball = world.add(disc(0.3, withFriction(1)), {.position = {0.6, 0}});
    world.setVelocity(ball, Vec2(Real(0.5), 0));
    for (int i = 0; i < 2500; ++i) {
        world.setVelocity(b, Vec2(0, 0), 2);
        world.step();
        EXPECT_LT(world.position(ball[0]).norm(), 0.65 + 1e-3);
    }
    // What the wall drags along rolls round, and is pressed to the wall by that.
    EXPECT_NEAR(world.position(ball[0]).norm(), 0.65, 1e-3);
    EXPECT_GT(std::abs(world.velocity(ball[0]).norm()), 0.3);
}

TEST(Arcs, WhatIsInTheHollowOfOneOnBothSidesIsNotPushedThroughIt) {
    // A thin bowl without an inside, which lies on the ground, with a crate in it.
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body bowl = world.add(rocker(), {.position = {0, 1.1}});
    const Body crate = world.add(
        shapes::box(
            {.size = {Real(0.4), Real(0.3)}, .mass = Real(0.2), .material = withFriction(1)}),
        {.position = {0.2, 0.6}});
    test::run(world, 5);
    const Point middle = (world.position(bowl[0]) + world.position(bowl[1])) / 2;
    EXPECT_LT((world.centreOfMass(crate) - middle).norm(), 0.95);
    EXPECT_LT(static_cast<double>(world.meanVelocity(crate).norm()), 0.05);
    EXPECT_GT(middle.y(), 1);
}

TEST(Arcs, ClosedCrowdsOfThemKeepTheirLaws) {
    test::Random random(11);
    for (int round = 0; round < 20; ++round) {
        WorldSettings settings;
        settings.gravity = {0, 0};
        settings.sleeping = false;
        World world(settings);
        std::vector<Body> bodies;
        for (int i = 0; i < 12; ++i) {
            Blueprint plan = rocker();
            for (JointSpec& joint : plan.joints)
                if (joint.radius > 0) joint.bend = static_cast<Real>(random.uniform(-3, 3));
            bodies.push_back(
                world.add(plan, {.position = {random.uniform(-6, 6), random.uniform(-6, 6)},
                                 .angle = random.uniform(0, 6)}));
            world.setVelocity(
                bodies.back(),
                Vec2(Point(random.uniform(-9, 9), random.uniform(-9, 9)).cast<Real>()),
                static_cast<Real>(random.uniform(-5, 5)));
        }
        const auto sums = [&] {
            Point momentum(0, 0);
            double energy = 0, angular = 0;
            for (const Body& body : bodies)
                for (const ParticleId id : body.particles()) {
                    const ParticleInfo info = world.info(id);
                    const Point v = info.velocity.cast<double>();
                    const double mass = static_cast<double>(info.mass);
                    momentum += mass * v;
                    angular += mass * cross(info.position, v);
                    energy += mass * v.squaredNorm() / 2;
                }
            return std::tuple(momentum, angular, energy);
        };
        const auto [momentum, angular, energy] = sums();
        test::run(world, 2);
        const auto [momentumNow, angularNow, energyNow] = sums();
        EXPECT_LT((momentumNow - momentum).norm(), 1e-3) << round;
        EXPECT_NEAR(angularNow, angular, 1e-2) << round;
        EXPECT_LT(energyNow, 1.01 * energy) << round;
    }
}

TEST(Arcs, NothingFastPassesThroughThem) {
    for (int k = 0; k < 200; ++k) {
        WorldSettings settings;
        settings.gravity = {0, 0};
        World world(settings);
        world.add(arc({-2, 0}, {2, 0}, Real(k % 2 == 0 ? 2 : -2)));
        const double x = -1.5 + 3 * k / 200.0, way = k / 2 % 2 == 0 ? 1 : -1;
        const Body b = world.add(disc(0.05, {}), {.position = {x, -4 * way}});
        world.setVelocity(b, Vec2(0, static_cast<Real>(way * (20 + 2 * k))));
        test::run(world, 0.4);
        const Point p = world.position(b[0]);
        EXPECT_FALSE(way * p.y() > 1.8 && std::abs(p.x()) < 2) << k << ": " << p.transpose();
    }
}

TEST(Arcs, NothingCurvedPassesThroughThem) {
    const double radius = 3 / std::sin(1.25), top = radius - radius * std::cos(1.25);
    for (int k = 0; k < 60; ++k) {
        WorldSettings settings;
        settings.gravity = {0, 0};
        World world(settings);
        world.add(arc({-3, 0}, {3, 0}, Real(-2.5)));
        const Body b = world.add(rocker(), {.position = {0.05 * (k % 21 - 10), top + 4}});
        world.setVelocity(b, Vec2(0, static_cast<Real>(-20 - 4 * k)));
        test::run(world, 0.5);
        const Point p = world.centreOfMass(b);
        EXPECT_FALSE(p.y() < top - 0.2 && std::abs(p.x()) < 2.5) << k << ": " << p.transpose();
    }
}

/// With its middle above its flat side, and sides of 10 cm.
Blueprint tallRocker() {
    Blueprint plan = rocker();
    plan.particles[2].position = {0, Real(0.5)};
    for (JointSpec& joint : plan.joints) joint.radius = Real(0.05);
    return plan;
}

TEST(Arcs, WhatIsDeepInABulgeLeavesThroughIt) {
    // Half a disc whose curved side is to the right of the way along it, and to the left.
    for (const bool forth : {true, false}) {
        WorldSettings settings;
        settings.gravity = {0, 0};
        World world(settings);
        Blueprint plan = tallRocker();
        if (!forth) {
            std::swap(plan.joints[0].a, plan.joints[0].b);
            plan.joints[0].bend = -plan.joints[0].bend;
        }
        const Body b = world.add(plan);
        world.step();
        // It is put there when both have met already, as a blow would press it in.
        const Body bead = world.add(disc(0.05, {}), {.position = {0, -1.2}});
        world.step();
        world.setPosition(bead[0], {0, -0.8});
        test::run(world, 2);
        EXPECT_GT((world.position(bead[0]) - world.centreOfMass(b)).norm(), 0.9) << forth;
        EXPECT_LT(world.position(bead[0]).y(), -0.9) << forth;
    }
}

TEST(Arcs, LinksOfAChainAreStraightToAll) {
    struct Counter final : DebugDraw {
        void capsule(const Capsule&) override { ++pieces; }
        int pieces = 0;
    } counter;
    World world;
    Blueprint plan;
    plan.particles = {{.position = {-2, 0}, .pinned = true},
                      {.position = {0, 0}},
                      {.position = {2, 0}, .pinned = true}};
    plan.joints = {{.a = 0, .b = 1, .radius = Real(0.05), .bend = Real(-1.5)},
                   {.a = 1, .b = 2, .radius = Real(0.05), .bend = Real(-1.5)}};
    world.add(plan);
    const Body bead = world.add(disc(0.1, {}), {.position = {-1, 1}});
    test::run(world, 1);
    world.draw(counter);
    EXPECT_EQ(counter.pieces, 2);
    EXPECT_NEAR(world.position(bead[0]).y(), 0.15, 0.05);
    EXPECT_TRUE(world.overlap(QueryShape::circle({1, 0.5}, 0.1)).empty());
}

TEST(Arcs, ACurvedSideFallsThroughNoFloor) {
    for (int k = 0; k < 30; ++k) {
        World world;
        world.add(shapes::floor({-50, 0}, {50, 0}));
        const Body b = world.add(rocker(), {.position = {0, 6}, .angle = 0.1 * k});
        world.setVelocity(b, Vec2(0, static_cast<Real>(-5 * k)), static_cast<Real>(k - 15));
        for (int i = 0; i < 1000; ++i) {
            world.step();
            for (std::size_t j = 0; j < 2; ++j) ASSERT_GT(world.position(b[j]).y(), 0.05) << k;
        }
    }
}

TEST(Arcs, QueriesSeeThem) {
    World world;
    const Body b = world.add(arc({-2, 0}, {2, 0}, halfTurn));
    const double within = 0.05 / 100 + 1e-6;
    for (const double x : {-1.2, 0.0, 0.7}) {
        const auto hit = world.castSegment({x, 1}, {x, -5});
        ASSERT_TRUE(hit);
        EXPECT_NEAR((hit->point).norm(), 1.95, within);
        EXPECT_GT(static_cast<double>(hit->normal.dot(Vec2(-hit->point.cast<Real>()).normalized())),
                  0.99);
        EXPECT_NEAR(static_cast<double>(hit->along), 1 - std::acos(x / 1.95) / pi, 0.01);
    }
    const auto closest = world.closestPoint({0, 0}, 10);
    ASSERT_TRUE(closest);
    EXPECT_NEAR(closest->distance, 1.95, within);
    EXPECT_EQ(world.overlap(QueryShape::circle({0, -2}, 0.01)).size(), 1u);
    EXPECT_TRUE(world.overlap(QueryShape::circle({0, 0}, 0.5)).empty());
    const Bounds bounds = world.bounds(b);
    EXPECT_NEAR(bounds.low.y(), -2.05, 1e-6);
    EXPECT_NEAR(bounds.high.y(), 0.05, 1e-6);
}

TEST(Arcs, ABodyEndsAtItsCurvedSide) {
    WorldSettings settings;
    settings.gravity = {0, 0};
    World world(settings);
    const Blueprint plan = tallRocker();
    const Body b = world.add(plan);
    world.step();
    EXPECT_EQ(world.bodiesAt({0, -0.9}), std::vector<BodyId>{b});
    EXPECT_EQ(world.bodiesAt({0.6, -0.7}), std::vector<BodyId>{b});
    EXPECT_TRUE(world.bodiesAt({0, -1.2}).empty());
    EXPECT_TRUE(world.bodiesAt({0.9, -0.9}).empty());
    // From inside the way out leads through the nearest side, which may be the curved one.
    const auto out = world.closestPoint({0, -0.9}, 1);
    ASSERT_TRUE(out);
    EXPECT_NEAR(out->distance, -0.15, 1e-3);
}

TEST(Arcs, AreDrawnAsChords) {
    struct Counter final : DebugDraw {
        void capsule(const Capsule& c) override {
            ++chords;
            for (const Point& end : {c.a, c.b}) EXPECT_NEAR(end.norm(), 2, 1e-6);
        }
        int chords = 0;
    } counter;
    World world;
    world.add(arc({-2, 0}, {2, 0}, halfTurn));
    world.draw(counter);
    EXPECT_GT(counter.chords, 20);
}

TEST(Arcs, AreRememberedBySnapshotsAndCopies) {
    World world;
    world.add(arc({-2, 0}, {2, 0}, halfTurn, withFriction(1)));
    world.add(disc(0.1, withFriction(1)), {.position = {1, -1}});
    const Body rolling = world.add(rocker(), {.position = {0, -1}, .angle = 0.3});
    test::run(world, 0.5);
    World copy = world.clone();
    const auto snapshot = world.snapshot();
    test::run(world, 1);
    test::run(copy, 1);
    EXPECT_EQ(copy.hash(), world.hash());
    const auto hash = world.hash();
    world.restore(snapshot);
    test::run(world, 1);
    EXPECT_EQ(world.hash(), hash);
    EXPECT_NEAR(static_cast<double>(world.info(world.joints(rolling).front()).bend), pi, 1e-6);

    World straight, bent;
    straight.add(arc({-2, 0}, {2, 0}, 0));
    bent.add(arc({-2, 0}, {2, 0}, 1));
    EXPECT_NE(straight.hash(), bent.hash());
}

TEST(Arcs, LookTheSameToAnyInstructionsAndThreads) {
    const auto play = [] {
        World world;
        world.add(arc({-3, 0}, {3, 0}, halfTurn, withFriction(1)));
        for (int i = 0; i < 12; ++i)
            world.add(i % 2 == 0 ? rocker() : disc(0.2, withFriction(1)),
                      {.position = {0.3 * (i % 5) - 0.6, 0.5 * i}, .angle = 0.4 * i});
        test::run(world, 3);
        return world.hash();
    };
    const auto widest = play();
    detail::useKernelsUpTo(detail::Instructions::baseline);
    const auto narrowest = play();
    detail::useKernelsUpTo(detail::Instructions::avx512);
    EXPECT_EQ(widest, narrowest);
}

TEST(Arcs, AreOfRigidJointsWithARadius) {
    Blueprint plan = rocker();
    plan.joints[0].stiffness = 100;
    EXPECT_THROW(plan.validate(), Error);
    plan.joints[0].stiffness = infinite;
    plan.joints[0].radius = 0;
    EXPECT_THROW(plan.validate(), Error);
    plan.joints[0].radius = Real(0.05);
    plan.joints[0].bend = Real(3.2);
    EXPECT_THROW(plan.validate(), Error);
    plan.joints[0].bend = Real(-3);
    EXPECT_NO_THROW(plan.validate());
    EXPECT_THROW(shapes::ground({.points = {{0, 0}, {1, 0}}, .bends = {1, 1}}), Error);
    World world;
    const Body b = world.add(plan);
    const auto before = world.hash();
    EXPECT_THROW(world.setStiffness(world.joints(b).front(), 100), Error);
    EXPECT_EQ(world.hash(), before);
}

TEST(Arcs, GoWithTheirJoint) {
    World world;
    const Body floor = world.add(arc({-2, 0}, {2, 0}, halfTurn));
    const Body b = world.add(disc(0.1, {}), {.position = {0, -1.8}});
    test::run(world, 0.5);
    EXPECT_NEAR(world.position(b[0]).y(), -1.85, 1e-3);
    world.remove(world.joints(floor).front());
    test::run(world, 1);
    EXPECT_LT(world.position(b[0]).y(), -3);
}

}  // namespace
}  // namespace sulfur
