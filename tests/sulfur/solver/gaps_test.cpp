// What is attached over a gap comes together by moving places: nothing is thrown.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// A loop of rigid links round its front, one node of 20 g every 0.1 m.
Blueprint loop() {
    Blueprint plan;
    constexpr std::uint32_t count = 16;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Real along = Real(0.1) * static_cast<Real>(std::min(i, count - i));
        plan.particles.push_back({.position = {along, i % (count / 2) == 0 ? Real(0)
                                                      : i < count / 2      ? Real(0.02)
                                                                           : Real(-0.02)},
                                  .mass = Real(0.02)});
    }
    for (std::uint32_t i = 0; i < count; ++i) plan.joints.push_back({.a = i, .b = (i + 1) % count});
    return plan;
}

/// About the origin, kg m^2/s.
double angularMomentum(const World& world) {
    double sum = 0;
    for (const BodyId body : world.bodies())
        for (const ParticleId p : world.particles(body)) {
            const Point at = world.position(p);
            const Point v = world.velocity(p).cast<double>();
            sum += static_cast<double>(world.info(p).mass) * (at[0] * v[1] - at[1] * v[0]);
        }
    return sum;
}

double fastest(const World& world, std::initializer_list<BodyId> bodies) {
    double most = 0;
    for (const BodyId body : bodies)
        for (const ParticleId p : world.particles(body))
            most = std::max(most, static_cast<double>(world.velocity(p).norm()));
    return most;
}

/// J, what those of a mass (kg) may get by coming together at half a metre a second.
double closingEnergy(double mass) {
    return mass / 2 * 0.5 * 0.5;
}

TEST(Gaps, NobodyIsThrown) {
    World world({.gravity = {0, 0}});
    const Body crate = world.add(shapes::box());
    const Body rope =
        world.add(shapes::rope({.from = {0, 4}, .to = {0, 2}, .links = 20, .radius = 0}));
    world.attach(rope.back(), crate, {0, Real(0.5)});
    double most = 0;
    for (int i = 0; i < 2500; ++i) {
        world.step();
        most = std::max(most, fastest(world, {crate, rope}));
    }
    EXPECT_LT(most, 0.6);
    const Point knot = (world.position(crate[2]) + world.position(crate[3])) / 2;
    EXPECT_NEAR((world.position(rope.back()) - knot).norm(), 0.02, 1e-3);
}

/// A rope or a loop that moves beside a crate that does not. When gaps closed at 5 m/s they had
/// fifteen times their energy then.
TEST(Gaps, CloseNearlyWithoutEnergy) {
    for (const bool isLoop : {false, true})
        for (const int rate : {60, 240, 500})
            for (const double gap : {0.03, 0.15}) {
                World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
                const Body crate = world.add(shapes::box({.size = {Real(0.5), Real(0.5)}}));
                const Body other = world.add(
                    isLoop ? loop() : shapes::rope({.from = {0, 0}, .to = {2, 0}, .radius = 0}),
                    {.position = {0.25 + gap, 0.25}});
                world.setVelocity(other, {0, 1});
                const double energy = world.energy(), angular = angularMomentum(world);
                const double mass = static_cast<double>(crate.mass() + other.mass());
                world.attach(other.front(), crate, {Real(0.25), Real(0.25)});
                double most = 0;
                for (int i = 0; i < rate; ++i) {
                    world.step();
                    most = std::max(most, world.energy());
                }
                EXPECT_LT(most, energy + closingEnergy(mass)) << isLoop << rate << "Hz " << gap;
                EXPECT_NEAR(angularMomentum(world), angular, 0.06 * angular)
                    << isLoop << ' ' << rate << " Hz, " << gap;
                EXPECT_EQ(world.validate(), "");
            }
}

/// What is soft is bent by it, but holds no more energy afterwards.
TEST(Gaps, CloseAtASoftBodyToo) {
    for (const int rate : {60, 500}) {
        World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
        const Body jelly = world.add(shapes::jelly());
        const Body ball = world.add(shapes::ball({.radius = Real(0.02), .mass = Real(0.5)}),
                                    {.position = {-0.65, 0}});
        world.setCollision(jelly, ball, false);
        world.attach(ball.front(), jelly, {Real(-0.5), 0});
        double most = 0;
        for (int i = 0; i < 2 * rate; ++i) {
            world.step();
            most = std::max(most, world.energy());
        }
        EXPECT_LT(most, closingEnergy(1.5));  // 4.5 J when gaps closed at 5 m/s
        EXPECT_LT(world.energy(), 0.02);
    }
}

/// A crate that hangs is put 0.3 m aside and gets back to its rope, which lifts it by less than
/// that.
TEST(Gaps, OfWhatIsPutElsewhereCloseToo) {
    World world;
    const Body crate = world.add(shapes::box({.size = {Real(0.5), Real(0.5)}}));
    const Body rope = world.add(shapes::rope(
        {.from = {0, Real(1.5)}, .to = {0, Real(0.25)}, .radius = 0, .pinFirst = true}));
    world.attach(rope.back(), crate, {0, Real(0.25)});
    test::run(world, 1);
    crate.setPose({.position = crate.pose().position + Point(0.3, 0)});
    const double start = world.energy();
    double most = start;
    for (int i = 0; i < 1000; ++i) {
        world.step();
        most = std::max(most, world.energy());
    }
    EXPECT_LT(most, start + 0.3 * 9.81 + closingEnergy(1.5));
    EXPECT_LT(test::largestStrain(world, rope), 1e-4);
    const Point knot = (world.position(crate[2]) + world.position(crate[3])) / 2;
    EXPECT_NEAR((world.position(rope.back()) - knot).norm(), 0.02, 1e-3);
}

/// A crate that comes to hang on a rope over a gap comes to rest and sleeps.
TEST(Gaps, LeaveNothingThatVibrates) {
    World world;
    const Body crate = world.add(shapes::box({.size = {Real(0.5), Real(0.5)}}));
    const Body rope = world.add(
        shapes::rope({.from = {0, 4}, .to = {0, Real(0.55)}, .radius = 0, .pinFirst = true}));
    world.attach(rope.back(), crate, {0, Real(0.25)});
    for (int i = 0; i < 2500 && !world.asleep(crate); ++i) world.step();
    EXPECT_TRUE(world.asleep(crate));
    EXPECT_NEAR(world.centreOfMass(crate)[1], 0.3, 1e-2);
}

/// Somebody ties a crate on a floor to what is below: contacts hold it there.
TEST(Gaps, LeadThroughNoFloor) {
    for (const int rate : {60, 240, 500}) {
        World world({.tickRate = rate, .sleeping = false});
        world.add(shapes::floor({-5, 0}, {5, 0}, Real(0.03)));
        const Body crate =
            world.add(shapes::box({.size = {Real(0.4), Real(0.4)}}), {.position = {0, 0.23}});
        Blueprint nail;
        nail.particles.push_back({.pinned = true});
        world.attach(world.add(nail, {.position = {0, -1}}).front(), crate, {0, 0});
        for (int i = 0; i < 4 * rate; ++i) world.step();
        EXPECT_GT(crate.bounds().low[1], 0) << rate << " Hz";
    }
}

}  // namespace
}  // namespace sulfur
