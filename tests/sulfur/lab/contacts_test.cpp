// The instruments of the scenes with contacts, on geometry that is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "battery/contacts/overlap.hpp"
#include "battery/contacts/shots.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/scenes.hpp"
#include "svg_scene.hpp"

namespace {

using namespace sulfur;
using namespace sulfur::lab;

/// Two bodies beside each other; nothing is stepped.
struct Two {
    Two(const Blueprint& first, const Blueprint& second, const Pose& pose)
        : a(world.add(first)), b(world.add(second, pose)) {}
    double overlap() const { return overlapOf(world, a, b); }

    World world;
    Body a, b;
};

TEST(Overlap, OfDiscsIsThatOfTheirRadii) {
    const Blueprint disc = shapes::ball({.radius = Real(0.5)});
    EXPECT_EQ(Two(disc, disc, {.position = Point(1.01, 0)}).overlap(), 0);
    EXPECT_NEAR(Two(disc, disc, {.position = Point(0.6, 0)}).overlap(), 0.4, 1e-6);
    EXPECT_NEAR(Two(disc, disc, {}).overlap(), 1, 1e-6);
}

TEST(Overlap, OfCratesGrowsWithTheirDepth) {
    EXPECT_NEAR(Two(crate(), crate(), {.position = Point(1.001, 0)}).overlap(), 0, 1e-9);
    // Capsules of 2 cm about axes that are within the faces by as much.
    EXPECT_NEAR(Two(crate(), crate(), {.position = Point(0.99, 0.3)}).overlap(), 0.01, 1e-6);
    EXPECT_NEAR(Two(crate(), crate(), {.position = Point(0.7, 0.3)}).overlap(), 0.3, 1e-6);
    const double corner = std::sqrt(0.5) * 0.96 + 0.04;  // between the axes of turned corners
    EXPECT_NEAR(
        Two(crate(), crate(),
            {.position = Point(0.48 + 0.02 + corner - 0.1, 0.01), .angle = std::numbers::pi / 4})
            .overlap(),
        0.08, 1e-3);
}

TEST(Overlap, KnowsWhatIsWithinABody) {
    const Blueprint disc = shapes::ball({.radius = Real(0.1)});
    for (const Blueprint& plan :
         {crate(), firmJelly(1, 1),
          shapes::wall({.size = vec2(1, 1), .columns = 1, .rows = 1, .radius = Real(0.02)})}) {
        const double radius = static_cast<double>(plan.joints.front().radius);
        // In the middle it would have to go to a side: half the width, and its own radius.
        EXPECT_NEAR(Two(plan, disc, {}).overlap(), 0.5 + 0.1, 0.003 + radius * 1e-3) << plan.name;
        EXPECT_EQ(Two(plan, disc, {.position = Point(0, 0.7)}).overlap(), 0) << plan.name;
    }
}

TEST(Overlap, OfAWallWithCellsCountsItsOuterSide) {
    const Blueprint wall = shapes::wall({.size = vec2(2, 2), .columns = 4, .rows = 4});
    const Blueprint disc = shapes::ball({.radius = Real(0.1)});
    EXPECT_NEAR(Two(wall, disc, {.position = Point(0.25, 0.25)}).overlap(), 0.85, 0.02);
    EXPECT_EQ(Two(wall, disc, {.position = Point(1.2, 0.25)}).overlap(), 0);
}

TEST(Overlap, LeavesOutWhatMayNotCollideAndTheSpaceInARope) {
    Blueprint one = crate(), other = crate();
    one.filter.group = other.filter.group = -1;
    EXPECT_EQ(Two(one, other, {}).overlap(), 0);
    const Blueprint rope =
        shapes::rope({.from = vec2(-1, 0.6), .to = vec2(1, 0.6), .radius = Real(0.01)});
    const Blueprint disc = shapes::ball({.radius = Real(0.1)});
    EXPECT_EQ(Two(rope, disc, {}).overlap(), 0);
    EXPECT_NEAR(Two(rope, disc, {.position = Point(0, 0.52)}).overlap(), 0.03, 1e-6);
}

TEST(Overlap, OfAllIsTheDeepestInSharesOfARadius) {
    World world;
    world.add(shapes::ball({.radius = Real(0.5)}));
    world.add(shapes::ball({.radius = Real(0.5)}), {.position = Point(0.9, 0)});
    const Body small =
        world.add(shapes::ball({.radius = Real(0.01)}), {.position = Point(0, 0.505)});
    const lab::Overlap worst = deepestOverlap(world);
    EXPECT_EQ(std::max(worst.a, worst.b), small.id());
    EXPECT_NEAR(worst.depth, 0.005, 1e-6);
    EXPECT_NEAR(worst.share, 0.5, 1e-4);
    const auto without = [&](BodyId a, BodyId b) { return a != small.id() && b != small.id(); };
    EXPECT_NEAR(deepestOverlap(world, without).share, 0.2, 1e-6);
}

TEST(WindingNumber, CountsTheTurnsOfALineThatCrossesItself) {
    const std::vector<Point> eight{{-2, -1}, {0, 0}, {2, 1}, {2, -1}, {0, 0}, {-2, 1}};
    EXPECT_EQ(windingNumber(eight, Point(1, 0)), -1);
    EXPECT_EQ(windingNumber(eight, Point(-1, 0)), 1);
    EXPECT_EQ(windingNumber(eight, Point(0, 0.5)), 0);
}

TEST(SpeedMeter, SeesTheWayThatABodyReallyMakes) {
    WorldSettings settings = still({}, 0);
    World world(settings);
    const std::vector<Body> bodies{world.add(crate())};
    SpeedMeter meter(world, bodies);
    EXPECT_EQ(meter.add(), 0);
    world.setVelocity(bodies.front(), vec2(3, 4));
    world.step();
    EXPECT_NEAR(meter.add(), 5, 1e-4);
    // Also one without a velocity.
    const Point place = world.position(bodies.front().front());
    world.setPosition(bodies.front().front(), place + Point(0, 0.01));
    EXPECT_NEAR(meter.add(), 0.01 * settings.tickRate, 1e-4);
}

TEST(Shots, AreRepeatedByTheirNumber) {
    for (const long number : {4L, 7L}) {
        const ShotReplay first = replayShot(number, {}), second = replayShot(number, {});
        ASSERT_FALSE(first.ticks.empty());
        EXPECT_EQ(asCsv(first), asCsv(second));
        EXPECT_EQ(first.result.target == "thin walls", number % 2 == 0);
        EXPECT_EQ(shoot(number, {}).energyGain, first.result.energyGain);
    }
}

TEST(Shots, CanMissNothing) {
    // Every one of them must meet its target while it is watched.
    int met = 0;
    for (long number = 1; number < 60; number += 2) {
        const ShotReplay replay = replayShot(number, {});
        met += std::any_of(replay.ticks.begin(), replay.ticks.end(),
                           [](const ShotTick& tick) { return tick.contacts > 0; })
                   ? 1
                   : 0;
    }
    EXPECT_EQ(met, 30);
}

TEST(Scene, IsDrawnWithEveryCapsuleAndDisc) {
    World world;
    world.add(shapes::ball({.radius = Real(0.5)}), {.position = Point(0, 3)});
    world.add(crate());
    const std::string svg = drawScene(world, "two");
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_NE(svg.find("two"), std::string::npos);
    // Four capsules, one disc; six joints of four corners and four to the core.
    std::size_t lines = 0;
    for (std::size_t at = svg.find("<path"); at != std::string::npos;
         at = svg.find("<path", at + 1))
        ++lines;
    EXPECT_EQ(lines, 4u + 1u + 10u);
}

}  // namespace
