// Angular joints: what they bend by, what they keep, when they go.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr double pi = std::numbers::pi;

Real real(double x) {
    return static_cast<Real>(x);
}

/// A line of rigid links along x, one particle of `mass` (kg) every `link` metres.
struct Strip {
    int links = 20;
    double link = 0.05;
    double mass = 0.05;
    double stiffness = 0;  // N m/rad
    double damping = 0;    // N m s/rad

    Blueprint plan() const {
        Blueprint plan;
        for (int i = 0; i <= links; ++i)
            plan.particles.push_back({.position = {real(link * i), 0}, .mass = real(mass)});
        for (std::uint32_t i = 0; i + 1 < plan.particles.size(); ++i)
            plan.joints.push_back({.a = i, .b = i + 1, .radius = Real(0.01)});
        for (std::uint32_t i = 0; i + 2 < plan.particles.size(); ++i)
            plan.angles.push_back({i, i + 1, i + 2, real(stiffness), real(damping), Real(0)});
        return plan;
    }

    /// The same, clamped at the beginning of its second link. Half of a link bends there, so that
    /// it is twice as stiff.
    Blueprint cantilever() const {
        Blueprint one = plan();
        one.particles[0].pinned = one.particles[1].pinned = true;
        one.angles[0].stiffness *= 2;
        return one;
    }

    double free() const { return link * (links - 1); }  // m of a cantilever
    double density() const { return mass / link; }      // kg/m
    double rigidity() const {
        return stiffness * link;
    }  // N m^2, Young's modulus times area moment
};

double kinetic(const World& world) {
    double sum = 0;
    for (const BodyId body : world.bodies())
        for (const ParticleId p : world.particles(body))
            sum += static_cast<double>(world.info(p).mass) / 2 *
                   world.velocity(p).cast<double>().squaredNorm();
    return sum;
}

/// About the origin, kg m^2/s.
double angularMomentum(const World& world, BodyId body) {
    double sum = 0;
    for (const ParticleId p : world.particles(body)) {
        const Point at = world.position(p);
        const Point v = world.velocity(p).cast<double>();
        sum += static_cast<double>(world.info(p).mass) * (at[0] * v[1] - at[1] * v[0]);
    }
    return sum;
}

TEST(Angles, WhatCannotBeIsRefused) {
    const auto refused = [](auto change) {
        Blueprint plan = Strip{.links = 3}.plan();
        change(plan);
        World world;
        EXPECT_THROW(world.add(plan), Error);
        EXPECT_EQ(world.bodies().size(), 0u);
    };
    refused([](Blueprint& p) { p.angles[1].c = 4; });
    refused([](Blueprint& p) { p.angles[1].c = p.angles[1].a; });
    refused([](Blueprint& p) { p.angles[1].stiffness = -1; });
    refused([](Blueprint& p) { p.angles[1].stiffness = Real(2e12); });
    refused([](Blueprint& p) { p.angles[1].damping = std::nanf(""); });
    refused([](Blueprint& p) { p.angles[1].restAngle = Real(3.2); });
    refused([](Blueprint& p) {
        p.joints.clear();
        p.particles[2].position = p.particles[1].position;
    });
}

TEST(Angles, TellsWhatItIs) {
    Blueprint plan = Strip{.links = 2, .stiffness = 3, .damping = 1}.plan();
    plan.particles[2].position = {Real(0.05), Real(0.05)};
    plan.angles[0].restAngle = std::nullopt;
    World world({.gravity = {0, 0}});
    const Body bent = world.add(plan);
    const auto angles = world.angles(bent);
    ASSERT_EQ(angles.size(), 1u);
    EXPECT_EQ(angles[0].b, bent[1]);
    EXPECT_EQ(angles[0].body, bent.id());
    EXPECT_EQ(angles[0].drive.stiffness, 3);
    EXPECT_EQ(angles[0].drive.damping, 1);
    EXPECT_NEAR(static_cast<double>(angles[0].drive.rest), pi / 2, 1e-6);
    EXPECT_NEAR(angles[0].angle, pi / 2, 1e-6);
}

/// Three particles of mass m, arms l: w^2 = 6 k / (m l^2). From soft to stiff, where the period has
/// at least 30 steps.
TEST(Angles, SwingsAtTheFrequencyOfTheory) {
    for (const double w : {3.0, 30.0, 100.0}) {
        const double m = 0.4, l = 0.5, k = w * w * m * l * l / 6;
        Blueprint plan = Strip{.links = 2, .link = l, .mass = m, .stiffness = k}.plan();
        World world({.gravity = {0, 0}, .sleeping = false});
        const Body body = world.add(plan);
        world.setVelocity(body[1], {0, real(-0.01 * w)});
        int crossings = 0;
        double first = 0, last = 0, before = -1;
        while (crossings < 11) {
            world.step();
            const double now = world.angles(body)[0].angle;
            if ((now > 0) != (before > 0) && world.time() > 0.01) {
                const double at =
                    world.time() - static_cast<double>(world.tickDuration()) * now / (now - before);
                if (crossings++ == 0) first = at;
                last = at;
            }
            before = now;
            ASSERT_LT(world.time(), 30 * 2 * pi / w) << w;
        }
        EXPECT_NEAR(pi * 10 / (last - first) / w, 1, 0.01) << w;
    }
}

/// F L^3 / (3 E I) at the end, where rows from soft to stiff bend by a hundredth of their length.
TEST(Angles, ACantileverBendsAsEulerAndBernoulliSay) {
    for (const double stiffness : {0.5, 50.0, 5000.0}) {
        const Strip strip{.links = 21, .stiffness = stiffness};
        const double length = strip.free();
        // Of the slowest oscillation, which air brakes without an overshoot.
        const double w = 3.516 / (length * length) * std::sqrt(strip.rigidity() / strip.density());
        World world({.gravity = {0, 0}, .airFriction = real(2 * w), .sleeping = false});
        const Body body = world.add(strip.cantilever());
        const double force = 0.01 * 3 * strip.rigidity() / (length * length);
        while (world.time() < std::max(2.0, 12 / w)) {
            world.applyForce(body.back(), {0, real(-force)});
            world.step();
        }
        EXPECT_NEAR(-world.position(body.back())[1] / (0.01 * length), 1, 0.005) << stiffness;
        const auto angles = world.angles(body);
        EXPECT_NEAR(static_cast<double>(angles[0].torque) / (force * length), 1, 0.01) << stiffness;
    }
}

/// A column that is clamped below bears pi^2 E I / (4 L^2).
TEST(Angles, AColumnBucklesAtEulersLoad) {
    const auto bendsUnder = [](double share) {
        const Strip strip{.links = 21, .mass = 0.01, .stiffness = 40, .damping = 1};
        World world({.gravity = {0, 0}, .sleeping = false});
        const Body body = world.add(strip.cantilever(), {.position = {0, 0}, .angle = pi / 2});
        const double length = strip.free();
        const double load = share * pi * pi * strip.rigidity() / (4 * length * length);
        world.applyImpulse(body.back(), {Real(1e-5), 0});
        for (int i = 0; i < 10000; ++i) {
            world.applyForce(body.back(), {0, real(-load)});
            world.step();
        }
        return std::abs(world.position(body.back())[0]) / length;
    };
    EXPECT_LT(bendsUnder(0.98), 1e-3);
    EXPECT_GT(bendsUnder(1.02), 0.1);
}

TEST(Angles, WhatIsFreeKeepsItsSpinAndGainsNothing) {
    for (const int rate : {60, 240, 500})
        for (const double stiffness : {0.02, 2.0, 200.0, 20000.0})
            for (const double spin : {0.0, 5.0, 40.0}) {
                World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
                const Body body = world.add(Strip{.links = 10, .stiffness = stiffness}.plan());
                const Point centre = world.centreOfMass(body);
                for (const ParticleId p : body.particles()) {
                    const double x = world.position(p)[0] - centre[0];
                    world.setVelocity(p, {0, real(spin * x + 2 * x * x)});
                }
                const double put = kinetic(world), turning = angularMomentum(world, body);
                double most = 0;
                for (int i = 0; i < 3 * rate; ++i) {
                    world.step();
                    most = std::max(most, kinetic(world));
                }
                const std::string where = "rate " + std::to_string(rate) + " stiffness " +
                                          std::to_string(stiffness) + " spin " +
                                          std::to_string(spin);
                EXPECT_LT(most, 1.01 * put) << where;
                EXPECT_NEAR(angularMomentum(world, body), turning, 1e-4 * std::abs(turning) + 1e-6)
                    << where;
                EXPECT_EQ(world.validate(), "") << where;
            }
}

/// Arms of soft links are pressed to nothing, where an angle turns round. A damper alone made
/// 7,779 J of 4.
TEST(Angles, OnSoftArmsItMakesNoEnergy) {
    for (const int rate : {60, 500, 2000})
        for (const double stiffness : {0.0, 1.0, 10.0})
            for (const double damping : {0.0, 10.0, 50.0}) {
                Blueprint plan =
                    Strip{.links = 2, .link = 0.2, .mass = 1, .stiffness = stiffness}.plan();
                plan.joints[0].stiffness = plan.joints[1].stiffness = 100;
                plan.angles[0].damping = real(damping);
                World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
                const Body body = world.add(plan);
                world.setVelocity(body[0], {2, Real(0.3)});
                world.setVelocity(body[1], {0, Real(-0.5)});
                world.setVelocity(body[2], {-2, Real(0.2)});
                const double put = world.energy();
                double most = put;
                for (int i = 0; i < 4 * rate; ++i) {
                    world.step();
                    most = std::max(most, world.energy());
                }
                EXPECT_LT(most, 1.05 * put) << rate << " Hz, " << stiffness << ", " << damping;
            }
}

/// Their loads are beyond what a float holds.
TEST(Angles, ArmsThatAreNextToNothingStayFinite) {
    for (const Real arm : {Real(1e-30), Real(1e-20), Real(1e-12)}) {
        Blueprint plan = Strip{.links = 2, .mass = 1e-6, .stiffness = 1e12}.plan();
        plan.joints.clear();
        for (ParticleSpec& particle : plan.particles) particle.position *= arm;
        World world;
        world.add(plan);
        for (int i = 0; i < 10; ++i) world.step();
        EXPECT_EQ(world.validate(), "") << arm;
    }
}

TEST(Angles, GoesWithTheJointsAlongIt) {
    Blueprint plan = Strip{.links = 6, .stiffness = 1}.plan();
    World world({.gravity = {0, 0}});
    const Body other = world.add(Strip{.links = 4, .stiffness = 5}.plan());
    const Body body = world.add(plan, {.position = {0, 1}});
    world.remove(world.joints(body)[2]);
    world.step();
    EXPECT_EQ(world.validate(), "");
    // Of five, without those at both of its ends.
    EXPECT_EQ(world.angles(body).size(), 3u);
    EXPECT_EQ(world.angles(other).size(), 3u);
    for (const AngleInfo& info : world.angles(body)) EXPECT_EQ(info.drive.stiffness, 1);
    world.remove(other);
    test::run(world, 0.1);
    EXPECT_EQ(world.validate(), "");
}

TEST(Angles, GoesWhenAJointBreaks) {
    Blueprint plan = Strip{.links = 6, .stiffness = 1}.plan();
    plan.particles[0].pinned = true;
    plan.joints[3].strength = 10;
    World world;
    const Body body = world.add(plan, {.position = {0, 5}, .angle = -pi / 2});
    world.applyImpulse(body.back(), {0, -2});
    test::run(world, 0.2);
    EXPECT_EQ(world.validate(), "");
    ASSERT_EQ(world.bodies().size(), 2u);
    EXPECT_EQ(world.angles(world.bodies()[0]).size() + world.angles(world.bodies()[1]).size(), 3u);
}

TEST(Angles, GoOnAfterRestoreToTheBit) {
    for (const double stiffness : {0.1, 1000.0}) {
        World world;
        world.add(shapes::floor({-5, 0}, {5, 0}));
        world.add(Strip{.stiffness = stiffness, .damping = 0.01}.plan(), {.position = {0, 1}});
        world.add(shapes::rope({.from = {0, 2}, .to = {1, 2}}));
        test::run(world, 0.3);
        const Snapshot snapshot = world.snapshot();
        World other;
        other.restore(snapshot);
        EXPECT_EQ(other.hash(), world.hash());
        test::run(world, 0.5);
        test::run(other, 0.5);
        EXPECT_EQ(other.hash(), world.hash());
    }
}

/// Without bending 143 of their links are folded at rest.
TEST(Angles, RopesFallIntoCoilsAndSleep) {
    int folded = 0;
    for (int k = 0; k < 12; ++k) {
        World world;
        world.add(shapes::floor({-20, 0}, {20, 0}));
        const double length = 0.8 + 0.5 * (k % 4), angle = 0.3 + 0.45 * k;
        const Body rope =
            world.add(shapes::rope({.from = {0, Real(0.3)},
                                    .to = {real(length * std::cos(angle)),
                                           real(0.3 + length * std::abs(std::sin(angle)))}}));
        for (const ParticleId p : rope.particles())
            world.setVelocity(p, {real(1 - k % 3), real(2 * world.position(p)[0])});
        test::run(world, 20);
        EXPECT_TRUE(world.asleep(rope)) << k;
        for (const AngleInfo& info : world.angles(rope))
            folded += std::abs(static_cast<double>(info.angle)) > 1.0 ? 1 : 0;
    }
    EXPECT_LT(folded, 12);
}

/// A rope that is bent and let go without gravity: how far its end goes beyond the straight.
double overshootOf(Real bendingDamping) {
    World world({.gravity = {0, 0}});
    const Body rope = world.add(
        shapes::rope({.to = {1, 0}, .links = 5, .bendingDamping = bendingDamping}));
    const auto particles = rope.particles();
    for (std::size_t i = 2; i < particles.size(); ++i) {
        const double turn = 0.1 * static_cast<double>(i - 1);
        const Point link(0.2 * std::cos(turn), 0.2 * std::sin(turn));
        world.setPosition(particles[i], world.position(particles[i - 1]) + link);
    }
    double least = 1;
    for (int tick = 0; tick < 1000; ++tick) {
        world.step();
        double turn = 0;
        for (const AngleInfo& info : world.angles(rope)) turn += static_cast<double>(info.angle);
        least = std::min(least, turn);
    }
    return -least;
}

TEST(Angles, ARopeSpringsBackAsItsBendingIsDamped) {
    EXPECT_GT(overshootOf(0), 0.3);
    EXPECT_GT(overshootOf(Real(0.3)), 0.05);
    EXPECT_LT(overshootOf(10), 1e-3);
    EXPECT_LT(overshootOf(100), 1e-3);
    EXPECT_THROW(shapes::rope({.bendingDamping = 101}), Error);
}

}  // namespace
}  // namespace sulfur
