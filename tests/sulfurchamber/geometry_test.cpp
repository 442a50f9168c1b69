#include <gtest/gtest.h>

#include <sulfur/shapes.hpp>

#include "model/geometry.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::Real;

TEST(Geometry, TheInsideOfABoxBelongsToIt) {
    sulfur::World world;
    const auto box = world.add(sulfur::shapes::box({.size = {2, 1}}), {.position = {5, 3}});
    EXPECT_EQ(bodyAt(world, {5.6, 3.2}, 0.01), box.id());
    EXPECT_EQ(bodyAt(world, {6.05, 3}, 0.1), box.id()) << "within reach of the surface";
    EXPECT_FALSE(bodyAt(world, {6.3, 3}, 0.1));
    EXPECT_FALSE(bodyAt(world, {5, 4}, 0.1));
}

TEST(Geometry, AnOutlineGoesOnceAroundTheCorners) {
    sulfur::World world;
    const auto box = world.add(sulfur::shapes::box());
    const auto loops = outlines(world, box);
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_EQ(loops[0].size(), 4u);
    const auto jelly = world.add(sulfur::shapes::jelly({.columns = 5, .rows = 4}));
    const auto around = outlines(world, jelly);
    ASSERT_EQ(around.size(), 1u);
    EXPECT_EQ(around[0].size(), 2u * (5 + 4) - 4);
    const auto rope = world.add(sulfur::shapes::rope());
    EXPECT_TRUE(outlines(world, rope).empty());
}

TEST(Geometry, ACutOutlineIsOpen) {
    sulfur::World world;
    const auto box = world.add(sulfur::shapes::box());
    world.remove(world.joints(box)[0]);
    EXPECT_TRUE(outlines(world, box).empty());
}

TEST(Geometry, AStrokeCrossesTheJointsBetween) {
    sulfur::World world;
    world.add(sulfur::shapes::rope({.from = {0, 0}, .to = {0, -2}, .links = 10}));
    EXPECT_EQ(jointsCrossing(world, {-1, -0.9}, {1, -0.9}).size(), 1u);
    EXPECT_TRUE(jointsCrossing(world, {-1, -3}, {1, -3}).empty());
    world.add(sulfur::shapes::floor({-5, -3}, {5, -3}));
    EXPECT_TRUE(jointsCrossing(world, {0, -4}, {0, -2.5}).empty()) << "ground cannot be cut";
}

TEST(Geometry, AFrameTakesWhatLiesWhollyInIt) {
    sulfur::World world;
    const auto a = world.add(sulfur::shapes::box(), {.position = {0, 0}});
    world.add(sulfur::shapes::box(), {.position = {2, 0}});
    const auto found = bodiesIn(world, {1.2, 1}, {-1, -1});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], a.id());
}

TEST(Geometry, BoundsShowWhatMovesAndTheGroundBelow) {
    sulfur::World world;
    EXPECT_FALSE(interestingBounds(world));
    world.add(sulfur::shapes::floor({-100, 0}, {100, 0}));
    EXPECT_FALSE(interestingBounds(world)) << "a floor alone is room to build";
    EXPECT_NEAR(floorHeight(world), 0.05, 1e-6);
    world.add(sulfur::shapes::box(), {.position = {3, 4}});
    const auto bounds = interestingBounds(world);
    ASSERT_TRUE(bounds);
    EXPECT_LT(bounds->size().x(), 3);
    EXPECT_LE(bounds->low.y(), 0);
    EXPECT_GE(bounds->high.y(), 4.4);
}

TEST(Geometry, PinsOfMechanismsAreNoBodiesOfTheirOwn) {
    sulfur::World world;
    const auto a = world.add(sulfur::shapes::box(), {.position = {0, 0}});
    const auto b = world.add(sulfur::shapes::box(), {.position = {1, 0}});
    const Totals before = totals(world);
    world.weld(a, b, {0.4, 0.1});
    ASSERT_EQ(world.bodies().size(), 3u) << "a pin holds both where neither has a particle";
    EXPECT_EQ(pinsOf(world).size(), 1u);
    EXPECT_EQ(totals(world).bodies, before.bodies);
    EXPECT_EQ(totals(world).particles, before.particles);
}

}  // namespace
}  // namespace sulfurchamber
