// What rolls is slowed down by its contacts, against theory.
#include "core/trigonometry.hpp"
#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr double g = 9.81;

Blueprint rolling(Blueprint plan, double c) {
    plan.material.rollingResistance = static_cast<Real>(c);
    return plan;
}

/// A disc of half a metre that rolls on a floor without slipping.
Body addRoller(World& world, double c, double speed) {
    world.add(shapes::floor({-50, 0}, {50, 0}));
    const Body disc = world.add(rolling(test::disc(), c), {.position = {0, 0.6}});
    test::run(world, 0.5);
    disc.setVelocity({static_cast<Real>(speed), 0}, -speed / 0.5);
    return disc;
}

/// c N is the force at its axle: without one, its moment of inertia is slowed down too.
TEST(RollingResistance, DeceleratesADiscAsTheorySays) {
    for (const int rate : {60, 120, 500, 2000})
        for (const double c : {0.01, 0.05, 0.2}) {
            World world({.tickRate = rate, .sleeping = false});
            const Body disc = addRoller(world, c, 3);
            test::run(world, 0.1);
            const double start = static_cast<double>(disc.meanVelocity().x());
            test::run(world, 0.5);
            const double end = static_cast<double>(disc.meanVelocity().x());
            EXPECT_NEAR((start - end) / 0.5, 2.0 / 3 * c * g, 0.01 * c * g) << rate << ' ' << c;
            EXPECT_NEAR(disc.angularVelocity(), -end / 0.5, 0.02);
        }
}

/// At a constant speed, a force of c N at the axle.
TEST(RollingResistance, IsBalancedByItsForce) {
    World world({.sleeping = false});
    const Body disc = addRoller(world, 0.1, 2);
    const Real weight = disc.mass() * Real(g);
    for (int i = 0; i < 500; ++i) {
        disc.applyForce({Real(0.1) * weight, 0}, disc.centreOfMass());
        world.step();
    }
    EXPECT_NEAR(static_cast<double>(disc.meanVelocity().x()), 2, 0.02);
}

TEST(RollingResistance, ComesToRestAndSleeps) {
    for (const int rate : {60, 500}) {
        World world({.tickRate = rate});
        const Body disc = addRoller(world, 0.1, 1);
        // v^2 / (2 a)
        const double way = 1 / (2 * 2.0 / 3 * 0.1 * g), start = disc.centreOfMass().x();
        test::run(world, 4);
        EXPECT_NEAR(disc.centreOfMass().x() - start, way, 0.02 * way + 2.0 / rate);
        EXPECT_TRUE(disc.asleep()) << rate;
        EXPECT_EQ(world.validate(), "");
    }
}

/// m, along a slope in two seconds from rest.
double wayDown(double c, double tangent, int rate) {
    World world({.tickRate = rate, .sleeping = false});
    const double angle = detail::angleOf(Point(1, tangent).normalized());
    world.add(shapes::floor({-50, 0}, {50, 0}), {.angle = -angle});
    const Point normal = detail::unitVector(1.5707963267948966 - angle);
    const Body disc = world.add(rolling(test::disc(), c), {.position = 0.5501 * normal});
    test::run(world, 0.5);
    disc.setVelocity({0, 0}, 0);
    const Point start = disc.centreOfMass();
    test::run(world, 2);
    return (disc.centreOfMass() - start).norm();
}

TEST(RollingResistance, HoldsOnSlopesBelowItsAngle) {
    for (const int rate : {60, 500})
        for (const double c : {0.05, 0.3}) {
            EXPECT_LT(wayDown(c, 0.95 * c, rate), 1e-3) << rate << ' ' << c;
            EXPECT_GT(wayDown(c, 1.3 * c, rate), 0.05) << rate << ' ' << c;
        }
}

/// Two discs that are pressed against each other and turn: both momenta stay what they are.
TEST(RollingResistance, KeepsMomentumBetweenTwo) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body a = world.add(rolling(test::disc(), 0.3), {.position = {-0.5, 0}});
    const Body b = world.add(rolling(test::disc(), 0), {.position = {0.5, 0}});
    a.setVelocity({0, 0}, 4);
    b.setVelocity({0, 0}, -4);  // as gears
    const auto angular = [&] {
        double sum = 0;
        for (const Body& body : {a, b}) {
            const Point at = body.centreOfMass(), v = body.meanVelocity().cast<double>();
            sum += static_cast<double>(body.mass()) * cross(at, v) +
                   static_cast<double>(body.inertia()) * body.angularVelocity();
        }
        return sum;
    };
    for (int i = 0; i < 500; ++i) {
        a.applyForce({20, 0}, a.centreOfMass());
        b.applyForce({-20, 0}, b.centreOfMass());
        world.step();
    }
    EXPECT_LT(std::abs(a.angularVelocity() - b.angularVelocity()), 1);  // 8 without
    EXPECT_NEAR(angular(), 0, 1e-3);
    EXPECT_NEAR(static_cast<double>((a.meanVelocity() + b.meanVelocity()).norm()), 0, 1e-4);
}

TEST(RollingResistance, TheLargerOneCounts) {
    World world({.sleeping = false});
    const Body disc = addRoller(world, 0, 2);
    const BodyId floor = world.bodies().front();
    test::run(world, 0.2);
    const double before = static_cast<double>(disc.meanVelocity().x());
    EXPECT_NEAR(before, 2, 1e-3);
    Material rough = world.material(floor);
    rough.rollingResistance = Real(0.1);
    world.setMaterial(floor, rough);
    test::run(world, 0.5);
    EXPECT_NEAR(static_cast<double>(disc.meanVelocity().x()), before - 0.5 * 2.0 / 3 * 0.1 * g,
                0.02);
    rough.rollingResistance = -1;
    EXPECT_THROW(world.setMaterial(floor, rough), Error);
}

TEST(RollingResistance, IsPartOfTheState) {
    World world;
    const Body disc = addRoller(world, 0.1, 2);
    test::run(world, 0.2);
    World other = world.clone();
    test::run(world, 0.5);
    test::run(other, 0.5);
    EXPECT_EQ(world.hash(), other.hash());
    const auto hash = world.hash();
    Material smooth = disc.material();
    smooth.rollingResistance = Real(0.2);
    disc.setMaterial(smooth);
    EXPECT_NE(world.hash(), hash);
}

}  // namespace
}  // namespace sulfur
