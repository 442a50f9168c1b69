// Rows of contacts: stacks, rebounds, friction, corners, what is made in each other.
#include <algorithm>
#include <cmath>

#include "helpers.hpp"
#include "kernels/joint_sweep.hpp"
#include "model/contact_core.hpp"

namespace sulfur {
namespace {

Blueprint crate(double size = 1, Real mass = 1, const Material& material = {}) {
    return shapes::box({.size = Vec2(static_cast<Real>(size), static_cast<Real>(size)),
                        .mass = mass,
                        .material = material});
}

std::vector<Body> stackOf(World& world, int count) {
    world.add(
        shapes::ground({.points = {{-20, Real(-0.05)}, {20, Real(-0.05)}}, .radius = Real(0.05)}));
    std::vector<Body> crates;
    for (int i = 0; i < count; ++i)
        crates.push_back(world.add(crate(), {.position = {0, 0.5 + i}}));
    return crates;
}

TEST(Rows, AStackOfTwentyStandsAtAnyRate) {
    for (const int rate : {60, 240, 500, 1000}) {
        World world({.tickRate = rate, .sleeping = false});
        const auto crates = stackOf(world, 20);
        test::run(world, 5);
        for (int i = 0; i < 20; ++i) {
            const Point at = world.centreOfMass(crates[static_cast<std::size_t>(i)]);
            EXPECT_NEAR(at.y(), 0.5 + i, 0.001) << rate << " Hz, crate " << i;
            EXPECT_NEAR(at.x(), 0, 0.001) << rate << " Hz, crate " << i;
        }
    }
}

TEST(Rows, AHeavyTopStands) {
    World world;
    auto crates = stackOf(world, 9);
    crates.push_back(world.add(crate(1, 100), {.position = {0, 9.5}}));
    test::run(world, 5);
    for (std::size_t i = 0; i < crates.size(); ++i)
        EXPECT_NEAR(world.centreOfMass(crates[i]).y(), 0.5 + static_cast<double>(i), 0.01);
}

/// Slides with g (sin a - mu cos a) from rest beyond the static angle, and holds below it.
TEST(Rows, ASlopeHoldsToTheStaticAngle) {
    constexpr double g = 9.81, mu = 0.6, kinetic = 0.5;
    const Material rough{.staticFriction = Real(mu), .kineticFriction = Real(kinetic)};
    const auto way = [&](double angle) {
        World world({.gravity = {static_cast<Real>(g * std::sin(angle)),
                                 static_cast<Real>(-g * std::cos(angle))},
                     .sleeping = false});
        world.add(shapes::ground({.points = {{-20, Real(-0.05)}, {40, Real(-0.05)}},
                                  .radius = Real(0.05),
                                  .material = rough}));
        const Body body = world.add(crate(1, 1, rough), {.position = {0, 0.5}});
        test::run(world, 2);
        return world.centreOfMass(body).x();
    };
    EXPECT_LT(way(0.97 * std::atan(mu)), 0.001);
    const double steep = 1.1 * std::atan(mu);
    const double exact = g * (std::sin(steep) - kinetic * std::cos(steep)) * 2 * 2 / 2;
    EXPECT_NEAR(way(steep), exact, 0.02 * exact);
}

/// Particles of a body that a capsule or disc covers; all others touch nothing.
std::vector<ParticleId> surfaceOf(const Blueprint& plan, const Body& body) {
    std::vector<bool> covered;
    for (const ParticleSpec& p : plan.particles) covered.push_back(p.radius > 0);
    for (const JointSpec& joint : plan.joints)
        if (joint.radius > 0) covered[joint.a] = covered[joint.b] = true;
    std::vector<ParticleId> ids;
    for (std::size_t i = 0; i < covered.size(); ++i)
        if (covered[i]) ids.push_back(body[i]);
    return ids;
}

TEST(Rows, NothingPassesThroughAThinWall) {
    for (const double speed : {30.0, 100.0, 300.0})
        for (const Blueprint& plan :
             {crate(0.3), shapes::ball({.radius = Real(0.05)}),
              shapes::jelly({.size = {Real(0.4), Real(0.4)}, .columns = 2, .rows = 2}),
              shapes::rope({.from = {Real(-0.2), 0}, .to = {Real(0.2), 0}, .links = 1})}) {
            World world({.gravity = {0, 0}});
            world.add(shapes::ground({.points = {{3, -20}, {3, 20}}, .radius = Real(0.01)}));
            const Body body = world.add(plan, {.angle = 0.4});
            world.setVelocity(body, {static_cast<Real>(speed), 0});
            const auto farthest = [&] {
                double most = -1e9;
                for (const ParticleId id : surfaceOf(plan, body))
                    most = std::max(most, world.position(id).x());
                return most;
            };
            for (int tick = 0; tick < 250; ++tick) {
                world.step();
                ASSERT_LT(farthest(), 3)
                    << plan.particles.size() << " particles, " << speed << " m/s, tick " << tick;
            }
        }
}

/// Its ends come down along a circle that never reaches the floor, although their velocity points
/// through it.
TEST(Rows, WhatSpinsBesideAFloorIsNotBraked) {
    World world({.gravity = {0, 0}});
    world.add(
        shapes::ground({.points = {{-20, Real(-0.5)}, {20, Real(-0.5)}}, .radius = Real(0.02)}));
    const Body rod =
        world.add(shapes::rope({.from = {Real(-0.3), 0}, .to = {Real(0.3), 0}, .links = 1}));
    for (const ParticleId id : rod.particles())
        world.setVelocity(id, {0, static_cast<Real>(500 * world.position(id).x())});
    world.step();
    const double energy = world.energy();
    test::run(world, 1);
    EXPECT_NEAR(world.energy(), energy, 1e-4 * energy);
}

TEST(Rows, SeamsOfOneLineAreNotFelt) {
    std::vector<Vec2> line;
    for (int i = 0; i <= 100; ++i) line.emplace_back(static_cast<Real>(-2 + 0.25 * i), Real(-0.05));
    const Material slick{.staticFriction = 0, .kineticFriction = 0};
    for (const Blueprint& plan :
         {crate(1, 1, slick), shapes::ball({.radius = Real(0.5), .material = slick})}) {
        World world;
        world.add(shapes::ground({.points = line, .radius = Real(0.05), .material = slick}));
        const Body body = world.add(plan, {.position = {0, 0.5}});
        test::run(world, 1);
        world.setVelocity(body, {2, 0});
        for (int tick = 0; tick < 2500; ++tick) {
            world.step();
            ASSERT_NEAR(static_cast<double>(world.meanVelocity(body).y()), 0, 0.002)
                << world.centreOfMass(body).x();
        }
    }
}

TEST(Rows, WhatIsMadeInEachOtherComesApartGently) {
    World world({.sleeping = false});
    stackOf(world, 0);
    std::vector<Body> discs;
    for (int i = 0; i < 10; ++i)
        discs.push_back(world.add(shapes::ball({.radius = Real(0.25)}),
                                  {.position = {0.004 * i, 0.3 + 0.003 * (i % 3)}}));
    test::run(world, 4);
    for (std::size_t i = 0; i < discs.size(); ++i) {
        EXPECT_GT(world.centreOfMass(discs[i]).y(), 0.24);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT((world.centreOfMass(discs[i]) - world.centreOfMass(discs[j])).norm(), 0.49);
    }
}

TEST(Rows, ALandingIsToldOnceAtAnyRate) {
    for (const int rate : {60, 240, 500}) {
        World world({.tickRate = rate, .sleeping = false});
        stackOf(world, 0);
        const Body body = world.add(crate(), {.position = {0, 1}});
        std::size_t begun = 0, ended = 0;
        double impulse = 0;
        for (int tick = 0; tick < rate; ++tick) {
            world.step();
            begun += world.events().contactsBegun.size();
            ended += world.events().contactsEnded.size();
            for (const auto& e : world.events().contactsBegun)
                impulse += static_cast<double>(e.impulse);
        }
        EXPECT_EQ(begun, 1u) << rate;
        EXPECT_EQ(ended, 0u) << rate;
        // sqrt(2 g s), and the weight in the tick of the landing.
        EXPECT_NEAR(impulse, std::sqrt(2 * 9.81 * 0.5), 0.2) << rate;
        EXPECT_TRUE(world.contains(body));
    }
}

/// Crates, a jelly and a rope in a heap.
void addHeap(World& world) {
    world.add(shapes::ground(
        {.points = {{-5, 3}, {-3, Real(-0.05)}, {3, Real(-0.05)}, {5, 3}}, .radius = Real(0.05)}));
    for (int i = 0; i < 12; ++i)
        world.add(crate(0.5), {.position = {0.3 * (i % 4) - 0.5, 0.5 + 0.7 * i}, .angle = 0.3 * i});
    world.add(shapes::jelly({.size = {1, 1}}), {.position = {0.2, 10}});
    world.add(shapes::rope({.from = {-1, 0}, .to = {1, 0}}), {.position = {0, 9}});
}

TEST(Rows, ARestoredWorldGoesOnToTheBit) {
    World world;
    addHeap(world);
    test::run(world, 1.5);
    World other;
    other.restore(world.snapshot());
    for (int tick = 0; tick < 500; ++tick) {
        world.step();
        other.step();
        ASSERT_EQ(world.hash(), other.hash()) << tick;
    }
}

TEST(Rows, EveryProcessorGivesTheSameBits) {
    const auto hashAfter = [](detail::Instructions most) {
        detail::useKernelsUpTo(most);
        World world;
        addHeap(world);
        test::run(world, 2);
        detail::useKernelsUpTo(detail::Instructions::avx512);
        return world.hash();
    };
    EXPECT_EQ(hashAfter(detail::Instructions::baseline), hashAfter(detail::Instructions::avx2));
}

TEST(Rows, KeepsWhatLiesOnGroundThatSomethingThickIsTiedTo) {
    World world;
    const Body ground = world.add(shapes::ground({.points = {{0, 6}, {0, 0}, {8, 0}}}));
    const Body ball =
        world.add(shapes::ball({.radius = Real(0.2), .mass = 5}), {.position = {1.5, 0}});
    world.connect(world.particles(ground)[1], ball.front(),
                  {.stiffness = infinite, .radius = Real(0.02)});
    std::vector<Body> boxes;
    for (int i = 0; i < 30; ++i)
        boxes.push_back(
            world.add(shapes::box({.size = {Real(0.3), Real(0.3)}}),
                      {.position = {0.5 + 0.24 * i, 0.2 + 0.5 * (i % 2)}, .angle = 0.1}));
    for (int tick = 0; tick < 700; ++tick) {
        World restored;
        if (tick % 10 == 0) restored.restore(world.snapshot());
        world.step();
        if (tick % 10 != 0) continue;
        restored.step();
        ASSERT_EQ(restored.hash(), world.hash()) << tick;
    }
    for (const Body& box : boxes) EXPECT_GT(world.centreOfMass(box)[1], 0);
}

/// The end of a thin rod is as thick as a joint to another body, also for what that body lets pass.
TEST(Rows, HoldsOffWhatTouchesAnEndThatAnotherBodysJointMakesThick) {
    for (const double speed : {0.5, 2.0}) {
        World world({.gravity = {0, 0}});
        const Body rod = world.add(shapes::chain({.to = {2, 0}, .links = 1, .pinFirst = true}),
                                   {.position = {0, 3}});
        Blueprint plan = shapes::ball({.radius = Real(0.05), .mass = 1});
        plan.filter.mask = 0;
        const Body other = world.add(plan, {.position = {2, 5}});
        plan.filter = {};
        world.connect(other.front(), rod.back(), {.stiffness = infinite, .radius = Real(0.5)});
        const Body visitor = world.add(plan, {.position = {4, 1}});
        world.setVelocity(visitor, Point(-speed, speed).cast<Real>());
        double nearest = 9;
        for (int tick = 0; tick < 2500 / speed; ++tick) {
            world.step();
            nearest = std::min(nearest,
                               (world.position(rod.back()) - world.centreOfMass(visitor)).norm());
        }
        EXPECT_NEAR(nearest, 0.55, 0.005) << speed;
    }
}

}  // namespace
}  // namespace sulfur
