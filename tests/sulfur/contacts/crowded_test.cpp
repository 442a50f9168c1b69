// Many bodies at one place, as somebody makes them who pastes without moving the mouse.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

std::vector<Body> addAtOnePoint(World& world, const Blueprint& plan, int count) {
    std::vector<Body> bodies;
    for (int i = 0; i < count; ++i) bodies.push_back(world.add(plan, {Point(0, 2), 0}));
    return bodies;
}

std::size_t bytesOf(const World& world) {
    const auto uses = world.memory();
    return std::accumulate(uses.begin(), uses.end(), std::size_t{0},
                           [](std::size_t sum, const MemoryUse& use) { return sum + use.bytes; });
}

double fastestOf(const World& world, const std::vector<Body>& bodies) {
    double fastest = 0;
    for (const Body& body : bodies)
        for (const ParticleId p : body.particles())
            fastest = std::max(fastest, static_cast<double>(world.velocity(p).norm()));
    return fastest;
}

TEST(Crowded, PairsAndMemoryOfACrowdAreBounded) {
    constexpr std::size_t count = 800, mostPairs = 64, mostBytes = 32768;
    World world;
    addAtOnePoint(world, shapes::ball(), count);
    for (int i = 0; i < 10; ++i) {
        world.step();
        ASSERT_LE(world.statistics().candidates, mostPairs * count);
        ASSERT_LE(bytesOf(world), mostBytes * count);
    }
    EXPECT_EQ(world.validate(), "");
}

/// Where all are in each other, each has a quarter of the pairs that it might have.
TEST(Crowded, ACrowdHasFewPairs) {
    constexpr std::size_t count = 480, few = 64;
    World world;
    world.add(shapes::floor({-9, 0}, {9, 0}));
    addAtOnePoint(world, shapes::ball(), count);
    for (int i = 0; i < 40; ++i) {
        world.step();
        ASSERT_LE(world.statistics().candidates, 16 * (2 * count + few)) << i;
    }
}

/// What is so fast that everything may meet everything has a bounded number of rows, and of pairs
/// whose ways are looked at.
TEST(Crowded, TheFastestTangleHasABoundedPrice) {
    World world({.gravity = {0, -1e6}});
    world.add(shapes::floor({-3, 0}, {3, 0}));
    for (int i = 0; i < 10; ++i)
        world.add(shapes::rope({.from = {Real(-1.5), 0}, .to = {Real(1.5), 0}, .links = 40}),
                  {Point(0, 0.3 + 0.2 * i), 0});
    for (int i = 0; i < 40; ++i) {
        world.step();
        const Statistics& now = world.statistics();
        ASSERT_LE(now.contacts, 32 * now.particles) << i;
        ASSERT_LE(now.fastPairs, 16 * (now.particles + 64) + now.candidates) << i;
    }
    EXPECT_EQ(world.validate(), "");
}

/// The same where every side has many others in it: rows and looks are few for each particle.
TEST(Crowded, ClothsAtTheLimitOfSpeedHaveABoundedPrice) {
    World world({.gravity = {0, -1e6}});
    world.add(shapes::floor({-20, 0}, {20, 0}));
    for (int i = 0; i < 3; ++i) world.add(shapes::cloth(), {Point(1.2 * i, 1), 0});
    for (int i = 0; i < 20; ++i) {
        world.step();
        const Statistics& now = world.statistics();
        const std::uint32_t counted = now.particles + 64;
        ASSERT_LE(now.contacts, 17 * counted) << i;
        ASSERT_LE(now.looks, 4 * counted) << i;
    }
    EXPECT_EQ(world.validate(), "");
}

/// Who is in a crowd finds room for the floor.
TEST(Crowded, ACrowdStandsOnTheFloor) {
    World world;
    world.add(shapes::ground({.points = {{-6, 40}, {-6, 0}, {6, 0}, {6, 40}}}));
    const auto balls = addAtOnePoint(world, shapes::ball(), 200);
    test::run(world, 4);
    for (const Body& ball : balls) EXPECT_GT(world.position(ball[0])[1], 0);
}

TEST(Crowded, ALargeBodyTouchesAllThatLieOnIt) {
    World world;
    world.add(shapes::floor({-60, 0}, {60, 0}));
    std::vector<Body> balls;
    for (int i = 0; i < 200; ++i)
        balls.push_back(world.add(shapes::ball(), {Point(-55 + 0.55 * i, 0.31), 0}));
    test::run(world, 0.5);
    for (const Body& ball : balls) EXPECT_GT(world.position(ball[0])[1], 0.29);
}

TEST(Crowded, RopesAtOnePlaceHaveFewRows) {
    for (const int rate : {60, 500}) {
        World world({.tickRate = rate});
        const auto ropes = addAtOnePoint(world, shapes::rope(), 22);
        const std::size_t particles = ropes.size() * ropes[0].size();
        for (int i = 0; i < rate / 20; ++i) {
            world.step();
            ASSERT_LE(world.statistics().contacts, 20 * particles) << rate << " Hz, tick " << i;
        }
    }
}

TEST(Crowded, BodiesAtOnePointComeApartAndKeepStill) {
    struct Kind {
        std::string name;
        Blueprint plan;
        double apart;  // m, between centres
    };
    const std::vector<Kind> kinds{{"ball", shapes::ball(), 0.49},
                                  {"box", shapes::box(), 0.98},
                                  {"jelly", shapes::jelly(), 0.5},
                                  {"rope", shapes::rope(), 0.03}};
    for (const auto& [name, plan, apart] : kinds) {
        World world({.gravity = {0, 0}, .sleeping = false});
        const auto bodies = addAtOnePoint(world, plan, 6);
        test::run(world, 12);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_GT((world.centreOfMass(bodies[i]) - world.centreOfMass(bodies[k])).norm(),
                          apart)
                    << name << ' ' << k << " and " << i;
        EXPECT_LT(fastestOf(world, bodies), 0.5) << name;
    }
}

TEST(Crowded, WhatIsPressedIntoEachOtherAtTheLimitOfSpeedStaysFinite) {
    for (const double gravity : {1e5, 1e6})
        for (const int rate : {60, 500}) {
            World world({.gravity = {0, -static_cast<Real>(gravity)}, .tickRate = rate});
            world.add(shapes::floor({-20, 0}, {20, 0}));
            for (int i = 0; i < 120; ++i)
                world.add(shapes::box(), {Point(i % 10 * 1.2 - 6, 1 + 1.2 * (i / 10)), 0});
            for (int i = 0; i < 8; ++i) {
                world.step();
                ASSERT_EQ(world.validate(), "") << gravity << " m/s^2, " << rate << " Hz, " << i;
            }
        }
}

/// A rod that is put into the bottom of something heavy on the floor cannot go down: the other
/// rises.
TEST(Crowded, WhoeverStandsInTheWayIsNotLedThroughTheFloor) {
    for (const int rate : {60, 500}) {
        World world({.tickRate = rate, .sleeping = false});
        world.add(shapes::floor({-9, 0}, {9, 0}));
        const Real radius = Real(0.02);
        const Body wall = world.add(
            shapes::wall(
                {.size = {2, 1}, .columns = 4, .rows = 2, .radius = radius, .strength = 1e9}),
            {Point(0, 0.52), 0});
        test::run(world, 0.5);
        const Body rod = world.add(shapes::rope({.from = {Real(-0.3), radius - Real(0.003)},
                                                 .to = {Real(0.2), radius - Real(0.003)},
                                                 .links = 1,
                                                 .radius = radius}));
        test::run(world, 4);
        double lowest = 1;
        for (const ParticleId p : wall.particles()) lowest = std::min(lowest, world.position(p)[1]);
        const Point middle = (world.position(rod[0]) + world.position(rod[1])) / 2;
        EXPECT_GT(std::max(std::abs(middle[0]) - 1.3, lowest - middle[1]), 0.8 * 2 * 0.02) << rate;
        EXPECT_GT(middle[1], 0.9 * 0.02) << rate;
    }
}

}  // namespace
}  // namespace sulfur
