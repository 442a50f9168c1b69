// Surfaces, friction models, self-collision and vetoes, as whole worlds show them.
#include <limits>

#include "core/segments.hpp"
#include "helpers.hpp"

namespace sulfur {
namespace {

const Material rough{.staticFriction = Real(0.8), .kineticFriction = Real(0.8)};
const Material ice{.staticFriction = 0, .kineticFriction = 0};

Body addFloor(World& world, const Material& material, const Pose& pose = {}) {
    Blueprint plan = shapes::floor({-50, 0}, {50, 0}, Real(0.05));
    plan.material = material;
    return world.add(plan, pose);
}

/// A crate of 1 m that lies on a floor at 0, its middle at x.
Body addCrate(World& world, const Material& material, double x = 0) {
    return world.add(shapes::box({.material = material}), {.position = {x, 0.5501}});
}

double speedOf(const World& world, BodyId body) {
    return static_cast<double>(world.meanVelocity(body)[0]);
}

/// What brakes a sliding crate, as a share of g.
double braking(const Material& below, const Material& above) {
    World world({.sleeping = false});
    addFloor(world, below);
    const Body crate = addCrate(world, above);
    test::run(world, 0.1);
    world.setVelocity(crate, {4, 0});
    test::run(world, 0.1);
    const double before = speedOf(world, crate);
    test::run(world, 0.3);
    return (before - speedOf(world, crate)) / 0.3 / 9.81;
}

TEST(Materials, FrictionIsTheGeometricMean) {
    const Material other{.staticFriction = Real(0.2), .kineticFriction = Real(0.2)};
    EXPECT_NEAR(braking(rough, rough), 0.8, 0.008);
    EXPECT_NEAR(braking(rough, other), 0.4, 0.004);
    EXPECT_NEAR(braking(other, rough), 0.4, 0.004);
    EXPECT_NEAR(braking(rough, ice), 0, 1e-4);
}

TEST(Materials, RestitutionIsTheLarger) {
    for (const bool floorIsLively : {true, false}) {
        World world({.sleeping = false});
        const Material lively{.restitution = Real(0.8)}, dull{.restitution = Real(0.2)};
        addFloor(world, floorIsLively ? lively : dull);
        const Body ball = world.add(shapes::ball({.material = floorIsLively ? dull : lively}),
                                    {.position = {0, 1.3}});
        double highest = 0;
        bool rose = false;
        for (int i = 0; i < 500; ++i) {
            world.step();
            const auto v = world.velocity(ball.front())[1];
            if (rose && v < 0) break;
            rose |= v > 0;
            if (rose) highest = std::max(highest, world.position(ball.front())[1] - 0.3);
        }
        EXPECT_NEAR(highest, 0.64, 0.02);
    }
}

/// From rest to the belt's speed with kinetic friction, and no further.
TEST(Materials, ABeltCarriesWhatLiesOnItToItsSpeed) {
    World world({.sleeping = false});
    addFloor(world, {.surfaceSpeed = 2});
    const Body crate = addCrate(world, {});
    test::run(world, 0.2);
    EXPECT_NEAR(speedOf(world, crate), 0.5 * 9.81 * 0.2, 0.06);
    double fastest = 0;
    for (int i = 0; i < 1500; ++i) {
        world.step();
        fastest = std::max(fastest, speedOf(world, crate));
    }
    EXPECT_NEAR(speedOf(world, crate), 2, 0.002);
    EXPECT_LT(fastest, 2.02);
    EXPECT_NEAR(world.centreOfMass(crate)[1], 0.55, 0.005);
}

TEST(Materials, TheUndersideOfABeltRunsTheOtherWay) {
    World world({.gravity = {0, Real(9.81)}, .sleeping = false});
    addFloor(world, {.surfaceSpeed = 2});
    const Body crate = world.add(shapes::box(), {.position = {0, -0.5501}});
    test::run(world, 3);
    EXPECT_NEAR(speedOf(world, crate), -2, 0.002);
}

/// A crate on tracks drives on a floor; on a belt it is that much faster.
TEST(Materials, SurfaceSpeedsAddUp) {
    for (const Real belt : {Real(0), Real(2), Real(-1)}) {
        World world({.sleeping = false});
        addFloor(world, {.surfaceSpeed = belt});
        const Body crate = addCrate(world, {.surfaceSpeed = 1});
        test::run(world, 3);
        EXPECT_NEAR(speedOf(world, crate), 1 + static_cast<double>(belt), 0.003) << belt;
    }
}

TEST(Materials, OneJointOfAFloorMayBeIcy) {
    for (const bool inBlueprint : {true, false}) {
        World world({.sleeping = false});
        Blueprint plan = shapes::ground({.points = {{-50, 0}, {0, 0}, {50, 0}}, .material = rough});
        if (inBlueprint) plan.joints[1].material = ice;
        const Body floor = world.add(plan);
        if (!inBlueprint) world.setMaterial(floor.joints()[1], ice);
        EXPECT_EQ(world.material(floor.joints()[0]), rough);
        EXPECT_EQ(world.material(floor.joints()[1]), ice);
        const Body held = addCrate(world, rough, -30), slides = addCrate(world, rough, 10);
        test::run(world, 0.1);
        for (const Body& crate : {held, slides}) world.setVelocity(crate, {2, 0});
        test::run(world, 1);
        EXPECT_NEAR(speedOf(world, held), 0, 1e-3);
        EXPECT_NEAR(speedOf(world, slides), 2, 1e-3);
        world.setMaterial(floor.joints()[1], std::nullopt);
        EXPECT_EQ(world.material(floor.joints()[1]), rough);
        test::run(world, 1);
        EXPECT_NEAR(speedOf(world, slides), 0, 1e-3);
    }
}

/// The corners of a crate show the surface of its sides, not of its body.
TEST(Materials, ACornerShowsTheSurfaceOfItsCapsule) {
    World world({.sleeping = false});
    addFloor(world, rough);
    Blueprint plan = shapes::box({.material = rough});
    for (JointSpec& joint : plan.joints)
        if (joint.radius > 0) joint.material = ice;
    const Body crate = world.add(plan, {.position = {0, 0.5501}});
    test::run(world, 0.1);
    world.setVelocity(crate, {1, 0});
    test::run(world, 1);
    EXPECT_NEAR(speedOf(world, crate), 1, 1e-3);
}

/// m dv/dt = -n mu v with n contacts, so that v = v0 exp(-n mu t / m); one for a ball, two for a
/// crate.
TEST(SlidingFriction, BrakesExponentially) {
    const Material oiled{.staticFriction = Real(0.5), .kineticFriction = Real(0.5)};
    for (const bool round : {true, false}) {
        World world({.sleeping = false, .friction = Friction::sliding});
        addFloor(world, oiled);
        const Body thing =
            round ? world.add(shapes::ball({.mass = 2, .material = oiled}), {.position = {0, 0.3}})
                  : world.add(shapes::box({.mass = 2, .material = oiled}), {.position = {0, 0.55}});
        test::run(world, 0.5);
        const std::size_t contacts = world.contacts().size();
        EXPECT_EQ(contacts, round ? 1u : 2u);
        world.setVelocity(thing, {3, 0});
        const double rate = static_cast<double>(contacts) * 0.5 / 2;
        for (int half = 1; half <= 10; ++half) {
            test::run(world, 0.5);
            EXPECT_NEAR(speedOf(world, thing) / (3 * std::exp(-rate * half / 2)), 1, 0.01) << half;
        }
    }
}

TEST(SlidingFriction, NeverReversesAndNeverHolds) {
    const Material tar{.staticFriction = Real(1e5), .kineticFriction = Real(1e5)};
    World world({.sleeping = false, .friction = Friction::sliding});
    addFloor(world, tar);
    const Body ball = world.add(shapes::ball({.material = tar}), {.position = {0, 0.3}});
    test::run(world, 0.2);
    world.setVelocity(ball, {5, 0});
    for (int i = 0; i < 500; ++i) {
        world.step();
        EXPECT_GE(speedOf(world, ball), -1e-9) << i;
    }
    EXPECT_LT(speedOf(world, ball), 1e-3);
    // Oil does not hold on a slope: it lets slide at the speed where m g sin = mu v.
    World slope({.gravity = {1, Real(-9.81)}, .sleeping = false, .friction = Friction::sliding});
    const Material oil{.staticFriction = 2, .kineticFriction = 2};
    addFloor(slope, oil);
    const Body disc = slope.add(shapes::ball({.material = oil}), {.position = {0, 0.3}});
    test::run(slope, 6);
    EXPECT_NEAR(speedOf(slope, disc), 0.5, 0.005);
}

/// Pairs of links of a rope that are not neighbours and overlap by more than half.
int overlaps(const World& world, const Body& rope, double radius) {
    const auto particles = rope.particles();
    const auto at = [&](std::size_t i) { return world.position(particles[i]); };
    const auto to = [](const Point& p, const Point& u, const Point& v) {
        return (p - (u + detail::nearestAlong<Point>(p, u, v) * (v - u))).norm();
    };
    int found = 0;
    for (std::size_t i = 0; i + 1 < particles.size(); ++i) {
        for (std::size_t k = i + 3; k + 1 < particles.size(); ++k) {
            const Point a = at(i), b = at(i + 1), c = at(k), d = at(k + 1);
            const double gap = std::min({to(a, c, d), to(b, c, d), to(c, a, b), to(d, a, b)});
            if (gap < radius || detail::segmentsCross(a, b, c, d)) ++found;
        }
    }
    return found;
}

/// The most at any time; `lean`: m, by which the rope's upper end is beside the lower.
int overlapsOfADroppedRope(bool selfCollision, Real lean) {
    World world({.sleeping = false});
    addFloor(world, {});
    const Real radius = Real(0.03);
    Blueprint plan = shapes::rope({.from = {0, 0}, .to = {lean, 3}, .links = 30, .radius = radius});
    plan.selfCollision = selfCollision;
    const Body rope = world.add(plan, {.position = {0, 0.1}});
    EXPECT_EQ(world.selfCollision(rope), selfCollision);
    int most = 0;
    for (int i = 0; i < 30; ++i) {
        test::run(world, 0.1);
        most = std::max(most, overlaps(world, rope, static_cast<double>(radius)));
    }
    return most;
}

TEST(SelfCollision, KeepsTheLinksOfARopeApart) {
    // How a rope falls is chance, and one in forty is pressed into itself for a moment.
    int pressed = 0;
    for (int i = 0; i < 10; ++i) {
        const Real lean = Real(0.2) + Real(0.01) * static_cast<Real>(i);
        EXPECT_GT(overlapsOfADroppedRope(false, lean), 5);
        pressed += overlapsOfADroppedRope(true, lean) > 0 ? 1 : 0;
    }
    EXPECT_LE(pressed, 1);
}

TEST(SelfCollision, LeavesABodyAtRestAlone) {
    World world({.gravity = {0, 0}, .sleeping = false});
    for (const Blueprint& shape :
         {shapes::jelly(), shapes::wheel(), shapes::box(), shapes::wall()}) {
        Blueprint plan = shape;
        plan.selfCollision = true;
        const Body body =
            world.add(plan, {.position = {20.0 * static_cast<double>(world.bodies().size()), 0}});
        test::run(world, 0.2);
        EXPECT_TRUE(world.contacts().empty()) << plan.name;
        EXPECT_LT(world.meanVelocity(body).norm(), 1e-6) << plan.name;
    }
}

TEST(Veto, LetsPassUntilItIsTakenBack) {
    World world({.sleeping = false});
    const Body upper = addFloor(world, {}), lower = addFloor(world, {}, {.position = {0, -4}});
    const Body crate = world.add(shapes::box(), {.position = {0, 1}});
    const Body other = world.add(shapes::box(), {.position = {5, 1}});
    world.setCollision(crate, upper, false);
    world.setCollision(lower, crate, false);
    EXPECT_FALSE(world.collision(upper, crate));
    ASSERT_EQ(world.vetoes().size(), 2u);
    test::run(world, 0.6);
    EXPECT_LT(world.centreOfMass(crate)[1], -0.6);
    EXPECT_NEAR(world.centreOfMass(other)[1], 0.55, 0.01);
    world.setCollision(crate, lower, true);
    EXPECT_TRUE(world.collision(crate, lower));
    test::run(world, 2);
    EXPECT_NEAR(world.centreOfMass(crate)[1], -3.45, 0.01);
    world.remove(upper);
    EXPECT_TRUE(world.vetoes().empty());
    EXPECT_EQ(world.validate(), "");
}

TEST(Materials, WhatStandsTakesUpNewMaterials) {
    World world({.sleeping = false});
    const Body floor = world.add(shapes::ground({.points = {{-20, 0}, {20, 0}}}));
    const Body crate = world.add(shapes::box(), {.position = {0, 0.5}});
    test::run(world, 0.5);
    const double before = world.position(crate.front()).x();
    world.setMaterial(floor, Material{.surfaceSpeed = 1});
    test::run(world, 1);
    EXPECT_GT(std::abs(world.position(crate.front()).x() - before), 0.5);
}

TEST(Materials, RefusesBadValues) {
    World world;
    const Body floor = addFloor(world, {});
    const Body crate = addCrate(world, {});
    const Body ball = world.add(shapes::ball(), {.position = {3, 3}});
    const Material slippery{.staticFriction = Real(0.1), .kineticFriction = Real(0.2)};
    for (const Material& bad :
         {slippery, Material{.kineticFriction = -1}, Material{.restitution = Real(1.1)},
          Material{.restitution = -1}, Material{.surfaceSpeed = 1001},
          Material{.rollingResistance = -1}, Material{.rollingResistance = 1001},
          Material{.staticFriction = Real(2e6)}}) {
        const auto refused = [&](auto&& call) {
            test::expectRefused(world, ErrorCode::outOfRange, call);
        };
        refused([&] { world.setMaterial(crate, bad); });
        refused([&] { world.setMaterial(crate.joints()[0], bad); });
        refused([&] { world.connect(crate.front(), ball.front(), {.material = bad}); });
    }
    test::expectRefused(world, ErrorCode::notFinite, [&] {
        world.setMaterial(crate, {.surfaceSpeed = std::numeric_limits<Real>::quiet_NaN()});
    });
    test::expectRefused(world, ErrorCode::degenerate,
                        [&] { world.setCollision(crate, crate, false); });
    world.remove(ball);
    test::expectRefused(world, ErrorCode::staleHandle,
                        [&] { world.setCollision(floor, ball, false); });
    test::expectRefused(world, ErrorCode::staleHandle, [&] { world.setSelfCollision(ball, true); });
}

}  // namespace
}  // namespace sulfur
