// A particle with a radius is a disc: it rolls, spins, and keeps what it turns with.
#include <numbers>

#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr double radius = 0.25, gravity = 9.81;

Body addFloor(World& world, const Material& material) {
    return world.add(shapes::ground({.points = {{-100, 0}, {100, 0}}, .material = material}));
}

/// On a floor whose surface is its radius above its axis.
Body addDisc(World& world, const Material& material, double x = 0) {
    const double thickness =
        static_cast<double>(world.info(world.joints(world.bodies().front()).front()).radius);
    return world.add(shapes::ball({.radius = Real(radius), .material = material}),
                     {.position = {x, radius + thickness}});
}

double speedOf(const World& world, const Body& disc) {
    return static_cast<double>(world.velocity(disc.front()).x());
}
double spinOf(const World& world, const Body& disc) {
    return world.info(disc.front()).spin;
}

TEST(Disc, RollsDownASlopeAtTwoThirdsOfWhatSlides) {
    const double angle = 0.3, pull = gravity * std::sin(angle);
    const Material rough{.staticFriction = 1, .kineticFriction = Real(0.8)};
    World world({.gravity = {Real(pull), Real(-gravity * std::cos(angle))}, .sleeping = false});
    addFloor(world, rough);
    const Body disc = addDisc(world, rough);
    const double energy = world.energy();
    test::run(world, 2);
    const double speed = 2.0 / 3 * pull * 2;
    EXPECT_NEAR(speedOf(world, disc), speed, 0.005 * speed);
    EXPECT_NEAR(spinOf(world, disc), -speed / radius, 0.005 * speed / radius);
    EXPECT_NEAR(world.energy(), energy, 0.01 * speed * speed);
}

/// The finer a wheel is, the less it loses at its corners. Sides that are shorter than the rim is
/// thick once made it stand, because a corner that two pieces share counted as two: with 48
/// segments it went at 0.5 m/s.
TEST(Disc, AFineWheelRollsLikeOne) {
    double before = 1.8;
    for (const int segments : {24, 32, 48, 64}) {
        World world({.sleeping = false});
        world.add(shapes::floor({-40, 0}, {40, 0}), {.angle = -0.35});
        const Body wheel = world.add(
            shapes::wheel({.radius = Real(0.25), .segments = segments, .rimRadius = Real(0.02)}),
            {.position = 0.3 * Point(std::sin(0.35), std::cos(0.35))});
        test::run(world, 1);
        const double speed = static_cast<double>(world.meanVelocity(wheel).norm());
        EXPECT_GT(speed, before) << segments;
        before = speed;
    }
}

/// Sliding friction brakes it and spins it up until the point that touches stands still.
TEST(Disc, SlidesUntilItRolls) {
    const Material smooth{.staticFriction = Real(0.3), .kineticFriction = Real(0.3)};
    World world({.gravity = {0, Real(-gravity)}, .sleeping = false});
    addFloor(world, smooth);
    const Body disc = addDisc(world, smooth);
    test::run(world, 0.2);
    world.setVelocity(disc, {3, 0});
    const double until = 3 / (3 * 0.3 * gravity);  // s
    test::run(world, until / 2);
    EXPECT_NEAR(speedOf(world, disc), 3 - 0.3 * gravity * until / 2, 0.02);
    test::run(world, until);
    EXPECT_NEAR(speedOf(world, disc), 2, 0.01);
    EXPECT_NEAR(spinOf(world, disc), -2 / radius, 0.01 * 2 / radius);
    test::run(world, 5);
    EXPECT_NEAR(speedOf(world, disc), 2, 0.01);
}

TEST(Disc, SpinningInPlaceItDoesNotFallAsleep) {
    World world({.gravity = {0, 0}});
    const Body disc = world.add(shapes::ball({.radius = Real(radius)}));
    const Body other = world.add(shapes::ball(), {.position = {9, 9}});
    disc.setVelocity({0, 0}, 0.1);
    other.setVelocity({0, 0}, 0.0001);
    test::run(world, 3);
    EXPECT_EQ(spinOf(world, disc), 0.1);
    EXPECT_TRUE(world.asleep(other)) << "its rim goes 0.025 mm/s";
}

/// N m s, of discs about the origin.
double angularMomentum(const World& world, const std::vector<Body>& discs) {
    double sum = 0;
    for (const Body& disc : discs) {
        const ParticleInfo p = world.info(disc.front());
        const double mass = static_cast<double>(p.mass), r = static_cast<double>(p.radius);
        sum += mass * cross(p.position, p.velocity.cast<double>()) + mass * r * r / 2 * p.spin;
    }
    return sum;
}

TEST(Disc, RubbingDiscsKeepAngularMomentum) {
    for (const Real rebound : {Real(0), Real(0.5)}) {
        const Material rough{
            .staticFriction = 1, .kineticFriction = Real(0.8), .restitution = rebound};
        World world({.gravity = {0, 0}, .sleeping = false});
        const Blueprint plan = shapes::ball({.radius = Real(0.5), .mass = 1, .material = rough});
        const std::vector<Body> discs{world.add(plan), world.add(plan, {.position = {-1.3, -0.7}})};
        world.setVelocity(discs[1], {5, 0});
        const double before = angularMomentum(world, discs), energy = world.energy();
        test::run(world, 1);
        EXPECT_NEAR(angularMomentum(world, discs), before, 1e-5 * before);
        EXPECT_LT(world.energy(), energy);
        // Gears would turn against each other; what is struck turns with who strikes.
        EXPECT_GT(spinOf(world, discs[0]), 0.1);
        EXPECT_NEAR(spinOf(world, discs[0]), spinOf(world, discs[1]), 1e-4);
    }
}

TEST(Disc, KeepsItsSpinWhenOthersComeAndGo) {
    const Material rough{.staticFriction = 1, .kineticFriction = 1};
    World world({.gravity = {0, Real(-gravity)}, .sleeping = false});
    addFloor(world, rough);
    const Body disc = addDisc(world, rough);
    world.setVelocity(disc, {3, 0});
    test::run(world, 1);
    const double spin = spinOf(world, disc);
    EXPECT_LT(spin, -1);
    const Body other = addDisc(world, rough, -10);
    world.step();
    EXPECT_NEAR(spinOf(world, disc), spin, 1e-3);
    world.remove(other);
    world.step();
    EXPECT_NEAR(spinOf(world, disc), spin, 1e-3);
    World restored({.sleeping = false});
    restored.restore(world.snapshot());
    EXPECT_EQ(restored.info(disc.front()).spin, spinOf(world, disc));
    EXPECT_EQ(restored.info(disc.front()).angle, world.info(disc.front()).angle);
}

TEST(Disc, APinnedOneDoesNotTurn) {
    const Material rough{.staticFriction = 1, .kineticFriction = 1};
    World world({.gravity = {0, Real(-gravity)}, .sleeping = false});
    Blueprint peg = shapes::ball({.radius = Real(radius), .material = rough});
    peg.particles.front().pinned = true;
    const Body pegBody = world.add(peg);
    const Body plank =
        world.add(shapes::box({.size = {2, Real(0.1)}, .radius = Real(0.02), .material = rough}),
                  {.position = {0, radius + 0.071}});
    world.setVelocity(plank, {Real(0.5), 0});
    test::run(world, 0.3);
    EXPECT_EQ(spinOf(world, pegBody), 0);
}

}  // namespace
}  // namespace sulfur
