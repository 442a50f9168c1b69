// What is tied together in loops holds, at any load, and gains no energy.
#include <algorithm>
#include <cmath>

#include "helpers.hpp"
#include "random_numbers.hpp"

namespace sulfur {
namespace {

constexpr double pi = 3.14159265358979323846;

struct NetPlan {
    std::uint32_t side = 12;
    double load = 1;           // mass of the node in the middle, in that of the others
    bool secondCorner = true;  // whether it hangs by two corners
    Real radius = 0;           // m
};

/// A square net of rigid joints of 0.1 m between nodes of 10 g.
Blueprint net(const NetPlan& plan) {
    Blueprint blueprint;
    const auto side = plan.side;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const bool middle = i == side / 2 * side + side / 2;
        blueprint.particles.push_back(
            {.position = Real(0.1) * Vec2(Real(i % side), -Real(i / side)),
             .mass = Real(0.01) * static_cast<Real>(middle ? plan.load : 1),
             .pinned = i == 0 || (plan.secondCorner && i + 1 == side)});
    }
    for (std::uint32_t i = 0; i < side * side; ++i) {
        if (i % side + 1 < side)
            blueprint.joints.push_back({.a = i, .b = i + 1, .radius = plan.radius});
        if (i + side < side * side)
            blueprint.joints.push_back({.a = i, .b = i + side, .radius = plan.radius});
    }
    return blueprint;
}

TEST(Networks, ANetIsOneAndNothingOfItIsSwept) {
    World world;
    world.add(net({}));
    world.step();
    EXPECT_EQ(world.statistics().networks, 1u);
    EXPECT_EQ(world.statistics().sweptJoints, 0u);
}

/// Swept joint by joint it was stretched by 30 % under its own weight, and by 70 times its length
/// under 10,000 times the mass of a node.
TEST(Networks, ANetHoldsAnyLoad) {
    for (const int rate : {60, 500})
        for (const double load : {1.0, 1e2, 1e4, 1e6}) {
            World world({.tickRate = rate, .sleeping = false});
            const Body body = world.add(net({.load = load}));
            double worst = 0;
            for (int i = 0; i < 2 * rate; ++i) {
                world.step();
                worst = std::max(worst, test::largestStrain(world, body));
            }
            EXPECT_LT(worst, 1e-2) << load << " at " << rate;
            EXPECT_LT(test::largestStrain(world, body), load > 1e5 ? 2e-3 : 1e-3)
                << load << " at " << rate;
        }
}

/// A net that is let go at one corner falls and whips; nothing is torn or speeds up.
TEST(Networks, ANetThatSwingsKeepsItsLengths) {
    for (const double load : {1.0, 1e4}) {
        World world({.sleeping = false});
        const Body body = world.add(net({.side = 10, .load = load, .secondCorner = false}));
        const double start = world.energy(), scale = 9.81 * static_cast<double>(world.mass(body));
        double worst = 0, most = start;
        for (int i = 0; i < 1500; ++i) {
            world.step();
            worst = std::max(worst, test::largestStrain(world, body));
            most = std::max(most, world.energy());
        }
        EXPECT_LT(worst, 1e-2) << load;
        EXPECT_LT(most - start, 0.01 * scale) << load;
        EXPECT_EQ(world.validate(), "");
    }
}

/// Its energy at a calm swing stays: a ladder of 29 rungs with a weight.
TEST(Networks, ASwingingLadderKeepsEnergy) {
    World world({.sleeping = false});
    Blueprint plan;
    constexpr std::uint32_t rungs = 30;
    for (std::uint32_t i = 0; i < 2 * rungs; ++i)
        plan.particles.push_back({.position = Real(0.2) * Vec2(Real(i % 2), -Real(i / 2)),
                                  .mass = i + 2 == 2 * rungs ? 100 : Real(0.1),
                                  .pinned = i < 2});
    for (std::uint32_t i = 0; i + 2 < 2 * rungs; ++i) plan.joints.push_back({.a = i, .b = i + 2});
    for (std::uint32_t i = 2; i < 2 * rungs; i += 2) plan.joints.push_back({.a = i, .b = i + 1});
    const Body ladder = world.add(plan);
    world.setVelocity(ladder.back(), {3, 0});
    world.step();
    const double start = world.energy();
    double worst = 0;
    for (int i = 0; i < 2500; ++i) {
        world.step();
        worst = std::max(worst, test::largestStrain(world, ladder));
    }
    EXPECT_LT(worst, 1e-6);
    EXPECT_NEAR(world.energy(), start, 1e-2);
}

/// In free flight a spinning necklace keeps momentum and angular momentum.
TEST(Networks, ASpinningRingKeepsItsSpin) {
    World world({.gravity = {0, 0}, .sleeping = false});
    Blueprint plan;
    constexpr std::uint32_t count = 24;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 2 * pi * i / count;
        plan.particles.push_back({.position = {Real(std::cos(angle)), Real(std::sin(angle))},
                                  .mass = Real(0.1) * Real(1 + i % 3)});
        plan.joints.push_back({.a = i, .b = (i + 1) % count});
    }
    const Body ring = world.add(plan);
    for (const ParticleId p : ring.particles()) {
        const Point at = world.position(p);
        world.setVelocity(p, Vec2(static_cast<Real>(-5 * at[1]), static_cast<Real>(5 * at[0])));
    }
    const auto spin = [&] {
        const Point centre = world.centreOfMass(ring);
        double sum = 0;
        for (const ParticleId p : ring.particles()) {
            const ParticleInfo info = world.info(p);
            sum += static_cast<double>(info.mass) *
                   cross(Point(info.position - centre), info.velocity.cast<double>());
        }
        return sum;
    };
    const double start = spin(), energy = world.energy();
    test::run(world, 10);
    EXPECT_NEAR(spin(), start, 1e-3 * start);
    EXPECT_NEAR(world.energy(), energy, 1e-2 * energy);
    EXPECT_LT(test::largestStrain(world, ring), 1e-6);
}

/// A ring of rope round a fixed beam, with a crate in it that weighs 1 to 100 times as much.
TEST(Networks, ARingRoundABeamBearsACrate) {
    for (const double ratio : {1.0, 10.0, 100.0}) {
        World world;
        Blueprint plan;
        constexpr std::uint32_t count = 60;
        for (std::uint32_t i = 0; i < count; ++i) {
            const double angle = 2 * pi * i / count;
            plan.particles.push_back(
                {.position = Real(0.5) * Vec2(Real(std::cos(angle)), Real(std::sin(angle))),
                 .mass = Real(0.02)});
            plan.joints.push_back({.a = i, .b = (i + 1) % count, .radius = Real(0.015)});
        }
        const Body ring = world.add(plan);
        Blueprint beam = shapes::box({.size = {Real(0.6), Real(0.2)}});
        beam.kind = BodyKind::fixed;
        world.add(beam, {.position = {0, 0.2}});
        const Body crate = world.add(
            shapes::box({.size = {Real(0.4), Real(0.2)}, .mass = static_cast<Real>(1.2 * ratio)}),
            {.position = {0, -0.3}});
        double most = world.energy();
        const double start = most;
        for (int i = 0; i < 2000; ++i) {
            world.step();
            most = std::max(most, world.energy());
        }
        EXPECT_LT(most - start, 0.01 * 9.81 * 1.2 * (1 + ratio)) << ratio;
        EXPECT_LT(test::largestStrain(world, ring), 1e-2) << ratio;
        EXPECT_NEAR(world.centreOfMass(crate)[1], -0.624, 0.02) << ratio;
        for (const ParticleId p : ring.particles()) {
            const Point at = world.position(p);
            const double inside = std::min(0.3 - std::abs(at[0]), 0.1 - std::abs(at[1] - 0.2));
            EXPECT_LT(inside, 0) << ratio;  // overlap is less than the radius
        }
    }
}

struct Caught {
    double gained = 0, strain = 0;  // J and share of a length, at most
    double height = 0;              // m, of the crate in the end
};
struct Fall {
    Real mass = 0, x = 0, angle = 0;
    bool rubs = true;
};
/// A crate falls on the taut upper edge of a net.
Caught fallOnANet(const Fall& fall, int rate) {
    World world({.tickRate = rate});
    const Material material =
        fall.rubs ? Material{} : Material{.staticFriction = 0, .kineticFriction = 0};
    Blueprint plan = net({.side = 10, .radius = Real(0.01)});
    plan.material = material;
    const Body body = world.add(plan);
    const Body crate = world.add(
        shapes::box({.size = {Real(0.4), Real(0.4)}, .mass = fall.mass, .material = material}),
        {.position = {fall.x, 0.6}, .angle = static_cast<double>(fall.angle)});
    const double start = world.energy();
    Caught caught;
    for (int i = 0; i < 2 * rate; ++i) {
        world.step();
        caught.gained = std::max(caught.gained, world.energy() - start);
        caught.strain = std::max(caught.strain, test::largestStrain(world, body));
    }
    caught.height = world.centreOfMass(crate)[1];
    return caught;
}

TEST(Networks, ANetCatchesACrate) {
    for (const Real mass : {Real(2), Real(10)}) {
        const Caught caught = fallOnANet({mass, Real(0.5), Real(0.2)}, 500);
        EXPECT_LT(caught.gained, 0.01 * 9.81 * static_cast<double>(mass));
        EXPECT_LT(caught.strain, 5e-2);
        EXPECT_NEAR(caught.height, 0.21, 0.03);
    }
}

/// The nodes weigh 10 g. Swept as rows that see free nodes, such contacts threw them metres far:
/// half of these falls gained 1e6 J. The third meets the edge beside its pin.
TEST(Networks, ALightNetCatchesWhatIsHeavy) {
    const Fall falls[] = {{50, Real(0.5), Real(0.5)},
                          {200, Real(0.4), 0},
                          {500, Real(0.2), Real(0.1)},
                          {1000, Real(0.4), 0, false},
                          {10000, Real(0.3), Real(0.785)}};
    for (const int rate : {120, 500})
        for (const Fall& fall : falls) {
            const Caught caught = fallOnANet(fall, rate);
            EXPECT_LT(caught.gained, 0.01 * 9.81 * static_cast<double>(fall.mass))
                << fall.mass << " at " << rate;
            EXPECT_LT(caught.strain, 0.1) << fall.mass << " at " << rate;
        }
}

/// Nets of all sizes, hung in all ways, with crates, discs and blobs of up to a tonne: energy is
/// the referee.
TEST(Networks, CrowdsOnNetsGainNoEnergy) {
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        test::Random random(seed * 0x9e3779b97f4a7c15u);
        const auto between = [&](double low, double high) {
            return static_cast<Real>(random.uniform(low, high));
        };
        const int rates[] = {60, 120, 240, 500}, rate = rates[random.below(4)];
        World world({.tickRate = rate});
        world.add(shapes::floor({-9, -3}, {9, -3}));
        NetPlan plan{.side = static_cast<std::uint32_t>(3 + random.below(6)),
                     .secondCorner = random.below(2) == 0,
                     .radius = between(0.006, 0.014)};
        world.add(net(plan));
        double mass = 1;
        for (std::size_t k = 0; k <= random.below(4); ++k) {
            const Real each = std::pow(Real(10), between(-1, 3)), size = between(0.2, 0.4);
            const Pose at{.position = {static_cast<double>(between(-0.2, 0.9)),
                                       0.4 + 0.6 * static_cast<double>(k)},
                          .angle = static_cast<double>(between(-1, 1))};
            const std::size_t kind = random.below(3);
            if (kind == 0) world.add(shapes::ball({.radius = size / 2, .mass = each}), at);
            if (kind == 1) world.add(shapes::box({.size = {size, size}, .mass = each}), at);
            if (kind == 2) world.add(shapes::blob({.radius = size / 2 + Real(0.05)}), at);
            mass += static_cast<double>(each);
        }
        const double start = world.energy();
        double most = start;
        for (int i = 0; i < 2 * rate; ++i) {
            world.step();
            most = std::max(most, world.energy());
        }
        EXPECT_LT(most - start, 0.05 * 9.81 * mass) << seed << " at " << rate;
        EXPECT_EQ(world.validate(), "") << seed;
    }
}

/// Ropes of 6 m that are straight between two pins, with crates on them: the second half of this
/// took 64 steps a tick for ever, and more than a whole core.
/// Within five seconds all that bears a crate sleeps.
TEST(Networks, ATautRopeBearsCrates) {
    for (const int crates : {0, 1, 3}) {
        World world;
        const Body rope = world.add(shapes::rope(
            {.from = {-3, 2}, .to = {3, 2}, .slack = Real(0), .pinFirst = true, .pinLast = true}));
        for (int i = 0; i < crates; ++i)
            world.add(shapes::box({.size = {Real(0.5), Real(0.5)}}), {.position = {i - 1.0, 2.4}});
        std::uint32_t steps = 0;
        double worst = 0;
        for (int i = 0; i < 2500; ++i) {
            world.step();
            steps = std::max(steps, world.statistics().chainSteps);
            worst = std::max(worst, test::largestStrain(world, rope));
        }
        EXPECT_LE(steps, 2u) << crates;
        EXPECT_LT(worst, 2e-2) << crates;
        if (crates == 0) continue;  // the rope alone swings on
        for (const BodyId body : world.bodies()) EXPECT_TRUE(world.asleep(body)) << crates;
    }
}

/// A frame of which one side is longer than the three others: least squares, and a bounded pull. It
/// may get what closing at 5 m/s gives, and some whip, but not ever more.
TEST(Networks, ALoopThatCannotCloseIsBounded) {
    World world({.gravity = {0, 0}, .sleeping = false});
    Blueprint plan;
    for (const Vec2& place : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
        plan.particles.push_back({.position = place});
    for (std::uint32_t i = 0; i < 4; ++i) plan.joints.push_back({.a = i, .b = (i + 1) % 4});
    plan.joints[2].restLength = Real(4);
    const Body frame = world.add(plan);
    double force = 0, early = 0, late = 0;
    for (int i = 0; i < 4000; ++i) {
        world.step();
        double& most = i < 1000 ? early : late;
        most = std::max(most, world.energy());
        for (const JointId j : frame.joints())
            force = std::max(force, std::abs(static_cast<double>(world.info(j).force)));
    }
    EXPECT_LT(force, 1e5);
    EXPECT_LT(early, 10 * 0.5 * 4 * 5 * 5);
    EXPECT_LT(late, early / 2);
    EXPECT_EQ(world.validate(), "");
}

/// Two wheels that are pinned at their hubs, with rods between their rims: nothing of it has a mass
/// that moves but by turning. They turn together, whichever of them was pushed.
TEST(Networks, WheelsOnFixedHubsTurnTogether) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const auto wheel = [&](double x) {
        Blueprint plan = shapes::box({.size = {1, 1}});
        plan.filter.mask = 0;
        for (auto& p : plan.particles) p.pinned = p.position.isZero();
        return world.add(plan, {.position = {x, 0}});
    };
    const Body left = wheel(0), right = wheel(2);
    std::vector<JointId> rods;
    for (const std::size_t corner : {0u, 1u})
        rods.push_back(world.connect(left.particles()[corner], right.particles()[corner]));
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 at = world.position(left.particles()[i]).cast<Real>();
        world.setVelocity(left.particles()[i], Vec2(-3 * at[1], 3 * at[0]));
    }
    world.step();
    const double start = world.energy();
    EXPECT_GT(start, 0.1);
    double strain = 0, apart = 0;
    for (int i = 0; i < 1000; ++i) {
        world.step();
        for (const JointId rod : rods) {
            const JointInfo joint = world.info(rod);
            const double length = (world.position(joint.b) - world.position(joint.a)).norm();
            strain = std::max(strain, std::abs(length / 2 - 1));
        }
        const Point between = world.position(right.front()) - world.position(left.front());
        apart = std::max(apart, (between - Point(2, 0)).norm());
    }
    EXPECT_EQ(world.statistics().networks, 1u);
    EXPECT_LT(strain, 1e-5);
    EXPECT_LT(apart, 1e-4);
    EXPECT_NEAR(world.energy(), start, 1e-3 * start);
}

/// Crates, each attached to its neighbours, hung by some of the upper ones.
TEST(Networks, AGridOfCratesStaysClosed) {
    World world({.tickRate = 240, .sleeping = false});
    constexpr int side = 12;
    std::vector<Body> crates;
    for (int i = 0; i < side * side; ++i) {
        Blueprint plan = shapes::box({.size = {1, 1}});
        plan.filter.mask = 0;
        if (i < side && std::abs(i - side / 2) <= 1) plan.kind = BodyKind::fixed;
        crates.push_back(world.add(plan, {.position = Point(i % side, -(i / side))}));
    }
    const auto at = [&](int x, int y) { return crates[static_cast<std::size_t>(y * side + x)]; };
    std::vector<AttachmentId> pins;
    const auto pin = [&](const Body& a, const Body& b) {
        const Point place = world.position(a.front()) - world.centreOfMass(b);
        pins.push_back(world.attach(a.front(), b, place.cast<Real>()));
    };
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            if (x > 0) pin(at(x, y), at(x - 1, y));
            if (y > 0) pin(at(x, y), at(x, y - 1));
        }
    double gap = 0;
    for (int i = 0; i < 240; ++i) {
        world.step();
        for (const AttachmentId id : pins) {
            const AttachmentInfo info = world.info(id);
            Point support(0, 0);
            for (std::uint32_t k = 0; k < info.count; ++k)
                support += static_cast<double>(info.weights[k]) * world.position(info.supports[k]);
            gap = std::max(gap, (world.position(info.particle) - support).norm());
        }
    }
    EXPECT_EQ(world.statistics().networks, 1u);
    EXPECT_LT(gap, 1e-3);
}

/// Where everything is tied to everything, a factorisation has no bounded price: it is swept.
TEST(Networks, WhatIsTooDenseIsSwept) {
    World world({.gravity = {0, 0}});
    Blueprint plan;
    constexpr std::uint32_t count = 240;
    for (std::uint32_t i = 0; i < count; ++i)
        plan.particles.push_back({.position = {Real(i), Real(0)}});
    const Body body = world.add(plan);
    const auto p = body.particles();
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t k = 1; k <= 60; ++k)
            world.connect(
                p[i],
                p[(i * 37 + k * k) % count == i ? (i + 1) % count : (i * 37 + k * k) % count]);
    world.step();
    EXPECT_EQ(world.statistics().networks, 0u);
    EXPECT_EQ(world.validate(), "");
}

/// What is kept of factors from tick to tick is in snapshots.
TEST(Networks, ARestoredOneGoesOnAlike) {
    World world({.sleeping = false});
    world.add(net({.side = 8, .load = 100, .secondCorner = false, .radius = Real(0.01)}));
    world.add(shapes::floor({-3, -1}, {3, -1}));
    World other;
    for (int i = 0; i < 400; ++i) {
        if (i % 37 == 0) other.restore(world.snapshot());
        world.step();
        other.step();
        ASSERT_EQ(world.hash(), other.hash()) << i;
    }
}

}  // namespace
}  // namespace sulfur
