// Removing costs what is removed and what it touched, whatever else is in the world. Counted in
// things that the stages look at, not in time.
#include <algorithm>
#include <numeric>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// Crates on a floor, apart, that sleep, and one ball far away that keeps the world awake.
class Dormitory {
public:
    explicit Dormitory(int count) {
        world.add(shapes::floor({-5, 0}, {static_cast<Real>(2 * count), 0}));
        for (int i = 0; i < count; ++i)
            crates.push_back(world.add(shapes::box(), {.position = {2.0 * i, 0.55}}));
        test::run(world, 2);
        for (const Body& crate : crates) EXPECT_TRUE(world.asleep(crate));
    }
    void keepAwake() {
        ball_ = world.add(shapes::ball(), {.position = {-100, 0}});
        world.setVelocity(ball_, {0, 1});
        for (int i = 0; i < 5; ++i) world.step();
    }
    /// What the stages of a tick looked at, in all.
    std::uint32_t tick() {
        world.step();
        const auto& items = world.statistics().items;
        return std::accumulate(items.begin(), items.end(), 0u);
    }

    World world;
    std::vector<Body> crates;

private:
    Body ball_;
};

/// What a tick looks at after one of so many sleeping crates was removed, beyond what it looks at
/// anyhow.
std::uint32_t afterRemoval(int count) {
    Dormitory hall(count);
    hall.keepAwake();
    const std::uint32_t usual = hall.tick();
    hall.world.remove(hall.crates[static_cast<std::size_t>(count) / 2]);
    const std::uint32_t after = hall.tick();
    EXPECT_EQ(hall.world.validate(), "");
    return after - std::min(after, usual);
}

TEST(RemovalCost, TheTickAfterItLooksAtNothingElse) {
    const std::uint32_t few = afterRemoval(20), many = afterRemoval(1000);
    EXPECT_LE(many, 40u) << "20 crates: " << few;
    EXPECT_LE(many, few + 10);
}

TEST(RemovalCost, NothingElseIsDrawnAnew) {
    Dormitory hall(200);
    hall.keepAwake();
    hall.tick();
    const auto usual = hall.world.statistics().boxes;
    hall.world.remove(hall.crates[100]);
    hall.tick();
    EXPECT_LE(hall.world.statistics().boxes, usual + 2);
}

/// Nobody's contacts are looked at again when something far away goes.
TEST(RemovalCost, WhatMovesElsewhereKeepsItsPairs) {
    World world({.sleeping = false});
    world.add(shapes::floor({-5, 0}, {500, 0}));
    std::vector<Body> crates;
    for (int i = 0; i < 200; ++i)
        crates.push_back(world.add(shapes::box(), {.position = {2.0 * i, 0.55}}));
    test::run(world, 1);
    const auto broadPhase = [&] {
        return world.statistics().items[static_cast<std::size_t>(Stage::broadPhase)];
    };
    std::uint32_t usual = 0;
    for (int i = 0; i < 50; ++i) {
        world.step();
        usual = std::max(usual, broadPhase());
    }
    world.remove(crates[100]);
    world.step();
    EXPECT_LE(broadPhase(), usual + 40);
    EXPECT_EQ(world.validate(), "");
}

/// A thousand crates side by side, also awake: who goes looks through no list, and the next tick
/// through each once, however many have gone.
TEST(RemovalCost, IsNoWorkForOthers) {
    for (const bool sleeping : {true, false}) {
        World world({.sleeping = sleeping});
        world.add(shapes::floor({-5, 0}, {2005, 0}));
        std::vector<Body> crates;
        for (int i = 0; i < 1000; ++i)
            crates.push_back(world.add(shapes::box(), {.position = {2.0 * i, 0.55}}));
        test::run(world, 1.5);
        EXPECT_EQ(world.asleep(crates[0]), sleeping);
        const auto before = world.statistics().upkeep;
        for (std::size_t i = 0; i < 1000; i += 4) world.remove(crates[i]);
        EXPECT_EQ(world.statistics().upkeep, before);
        world.step();
        EXPECT_LE(world.statistics().upkeep, before + (sleeping ? 0 : 6 * 1000));
        const auto after = world.statistics().upkeep;
        world.step();
        EXPECT_EQ(world.statistics().upkeep, after);
        EXPECT_EQ(world.bodies().size(), 751u);
        EXPECT_EQ(world.validate(), "");
    }
}

/// Gaps are closed when half of all is gaps, so that removing all of many costs a few looks at
/// each, and not one at all the others for each.
TEST(RemovalCost, OfAllIsThatOfEach) {
    World world;
    world.add(shapes::floor({-5, 0}, {2005, 0}));
    std::vector<Body> crates;
    for (int i = 0; i < 1000; ++i)
        crates.push_back(world.add(shapes::box(), {.position = {2.0 * i, 0.55}}));
    test::run(world, 1.5);
    for (const Body& crate : crates) world.remove(crate);
    EXPECT_EQ(world.bodies().size(), 1u);
    // A crate has four particles and six joints.
    EXPECT_LE(world.statistics().upkeep, 3u * 1000 * (1 + 4 + 6));
    world.step();
    EXPECT_EQ(world.validate(), "");
}

/// Whether somebody has asked where things are in between is nobody's business: the gaps that are
/// left are the same.
TEST(RemovalCost, AsksForNothingThatDecides) {
    const auto hashOf = [](bool asks) {
        World world({.sleeping = false});
        world.add(shapes::floor({-5, 0}, {205, 0}));
        std::vector<Body> crates;
        for (int i = 0; i < 100; ++i)
            crates.push_back(world.add(shapes::box(), {.position = {2.0 * i, 3}}));
        for (int i = 0; i < 90; ++i) {
            world.step();
            if (i % 3 != 0) continue;
            if (asks) world.centreOfMass(crates[99]);
            world.remove(crates[static_cast<std::size_t>(i)]);
            if (asks) world.centreOfMass(crates[98]);
            world.add(shapes::ball(), {.position = {2.0 * i, 9}});
        }
        return world.hash();
    };
    EXPECT_EQ(hashOf(true), hashOf(false));
}

}  // namespace
}  // namespace sulfur
