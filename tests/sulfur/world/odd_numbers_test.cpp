// What random calls have found: worlds of odd numbers and odd bodies stay sound.
#include <algorithm>
#include <vector>

#include "helpers.hpp"
#include "rigid/held_point.hpp"

namespace sulfur {
namespace {

/// Points that touch nothing.
Blueprint points(BodyKind kind) {
    Blueprint plan;
    plan.kind = kind;
    plan.particles = {{.position = {0, 0}}, {.position = {1, 0}}};
    return plan;
}

TEST(OddNumbers, AKinematicBodyMayHaveNoSurface) {
    World world;
    world.add(shapes::floor({-9, 0}, {9, 0}));
    const Body crate = world.add(shapes::box(), {.position = {0, 0.6}});
    std::vector<Body> ghosts;
    for (int i = 0; i < 40; ++i)
        ghosts.push_back(world.add(points(BodyKind::kinematic), {.position = {0, 0.1 * i}}));
    for (int i = 0; i < 100; ++i) {
        for (const Body& ghost : ghosts) world.moveTo(ghost, {.position = {0.01 * i, 0}});
        world.step();
    }
    EXPECT_EQ(world.validate(), "");
    EXPECT_NEAR(world.position(ghosts.back().front())[0], 0.99, 1e-6);
    EXPECT_NEAR(world.centreOfMass(crate)[1], 0.55, 0.01);
}

TEST(OddNumbers, TheNearestParticleIsNeverOneThatIsGone) {
    World world;
    std::vector<Body> crates;
    for (int i = 0; i < 10; ++i)
        crates.push_back(world.add(shapes::box(), {.position = {3.0 * i, 0}}));
    world.step();
    const Point there = world.position(crates[4].front());
    world.remove(crates[4]);
    const auto nearest = world.nearestParticle(there, 100);
    ASSERT_TRUE(nearest);
    EXPECT_TRUE(world.contains(*nearest));
    EXPECT_FALSE(world.nearestParticle(there, Real(0.5)));
}

/// Their moments of inertia have an inverse that is no number.
TEST(OddNumbers, WhatIsTinyFallsAsAllElse) {
    World world({.sleeping = false});
    Blueprint plan = shapes::ball({.radius = Real(1e-20), .mass = Real(1e-9)});
    const Body disc = world.add(plan);
    Blueprint dust;
    for (const Vec2& at : {Vec2(0, 0), Vec2(Real(1e-15), 0), Vec2(0, Real(1e-15))})
        dust.particles.push_back({.position = at, .mass = Real(1e-9)});
    dust.joints = {{.a = 0, .b = 1}, {.a = 1, .b = 2}, {.a = 2, .b = 0}};
    const Body speck = world.add(dust, {.position = {5, 0}});
    world.applyForce(disc.front(), {Real(1e-9), 0});
    world.applyForce(speck.front(), {Real(1e-9), 0});
    test::run(world, 0.5);
    EXPECT_EQ(world.validate(), "");
    for (const Body& body : {disc, speck})
        EXPECT_NEAR(world.centreOfMass(body)[1], -9.81 / 8, 0.01);
}

TEST(OddNumbers, ABlueprintReachesNoFartherThanAWorld) {
    World world;
    for (const Real far : {Real(6e8), Real(-3e38)}) {
        Blueprint plan = points(BodyKind::dynamic);
        plan.particles[1].position[1] = far;
        test::expectRefused(world, ErrorCode::outOfRange, [&] { world.add(plan); });
    }
    Blueprint plan = points(BodyKind::dynamic);
    plan.particles[1].position[0] = Real(5e8);
    EXPECT_NO_THROW(world.add(plan, {.position = {5e8, 0}}));
}

/// As World::velocity tells: particles, crates, discs, ropes and nets stop at 2000 m/s on an axis.
TEST(OddNumbers, NobodyIsFasterThanTheLimit) {
    World world({.sleeping = false});
    Blueprint point, disc, net;
    point.particles = {{}};
    disc.particles = {{.radius = Real(0.2)}};
    net.particles = {{.position = {0, 0}}, {.position = {1, 0}}, {.position = {0, 1}}};
    net.particles.push_back({.position = {1, 1}});
    net.joints = {{.a = 0, .b = 1}, {.a = 1, .b = 3}, {.a = 3, .b = 2}, {.a = 2, .b = 0}};
    std::vector<Body> bodies;
    for (const Blueprint& plan : {point, disc, net, shapes::box(), shapes::rope()})
        bodies.push_back(world.add(plan, {.position = {0, 100.0 * bodies.size()}}));
    double fastest = 0;
    for (int i = 0; i < 50; ++i) {
        for (const Body& body : bodies) {
            for (const ParticleId p : body.particles()) world.applyForce(p, {Real(1e9), 0});
            world.applyImpulse(body.front(), {0, Real(-1e9)});
        }
        world.step();
        for (const Body& body : bodies)
            for (const ParticleId p : body.particles()) {
                const Vec2 velocity = world.velocity(p);
                fastest = std::max(fastest, static_cast<double>(velocity.cwiseAbs().maxCoeff()));
            }
    }
    EXPECT_LE(fastest, 2000);
    EXPECT_GT(fastest, 1900);
    EXPECT_EQ(world.validate(), "");
}

/// What is held far outside of something light has a mobility whose determinant is no number.
TEST(OddNumbers, WhatIsMovedAllTooEasilyStaysFinite) {
    detail::Matrix2 mobility;
    mobility << Real(1e30), Real(0), Real(0), Real(1e30);
    const Vec2 impulse = detail::solve2(mobility, {Real(1e20), Real(-1e20)});
    EXPECT_TRUE(impulse.allFinite());
}

}  // namespace
}  // namespace sulfur
