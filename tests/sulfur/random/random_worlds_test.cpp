// Fifty random worlds and the laws that they keep. `sulfur_lab stability --battery --group random`
// runs more of them, `--shrink` makes one that fails smaller.
#include <gtest/gtest.h>

#include <algorithm>

#include "battery/random/laws.hpp"
#include "battery/random/momenta.hpp"

namespace {

using namespace sulfur;
using namespace sulfur::lab;

constexpr std::uint64_t firstSeed = 1, lastSeed = 50;

/// The laws that the library keeps in all of these seeds, and below those that it does not keep
/// yet. A law moves up when it holds.
const std::vector<Law> lawsThatHold{Law::finite,   Law::valid,    Law::restore,
                                    Law::momentum, Law::sleeping, Law::rest};
const std::vector<Law> lawsToSwitchOn{Law::walls, Law::speed, Law::angularMomentum, Law::energy};

std::string textOf(const std::vector<Breach>& breaches) {
    std::string out;
    for (const Breach& b : breaches)
        out += std::string(name(b.law)) + " " + std::to_string(b.measured) + " at tick " +
               std::to_string(b.tick) + ", at most " + std::to_string(b.bound) + "; ";
    return out;
}

class RandomWorlds : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomWorlds, KeepTheLaws) {
    EXPECT_EQ(textOf(judge(sceneOf(GetParam()), lawsThatHold)), "");
}

INSTANTIATE_TEST_SUITE_P(Seed, RandomWorlds, testing::Range(firstSeed, lastSeed + 1),
                         [](const auto& seed) { return std::to_string(seed.param); });

TEST(RandomScenes, NoLawIsForgotten) {
    EXPECT_EQ(lawsThatHold.size() + lawsToSwitchOn.size(), allLaws().size());
    for (const Law law : allLaws()) EXPECT_EQ(lawOf(name(law)), law);
}

TEST(RandomScenes, ASeedIsAlwaysTheSame) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        EXPECT_EQ(asCode(sceneOf(seed)), asCode(sceneOf(seed)));
    EXPECT_NE(asCode(sceneOf(1)), asCode(sceneOf(11)));
}

/// What is soft on one side and in a rope that is divided into more steps on the other.
TEST(ScenesThatBroke, SpringsGiveBothSidesTheSame) {
    const Scene scene{
        .rate = 500,
        .ticks = 4,
        .things = {{.kind = Kind::elasticRope,
                    .size = 2.4,
                    .mass = 46,
                    .variant = 0.051,
                    .frequency = 35},
                   {.kind = Kind::elasticRope,
                    .size = 0.15,
                    .variant = 0.52,
                    .frequency = 741,
                    .place = {-2.647, -0.109},
                    .velocity = {5.6, -0.73}}},
        .ties = {{.kind = Tie::Kind::rod, .a = 1, .alongA = 0.5126, .alongB = 0.877}}};
    EXPECT_EQ(textOf(judge(scene, {Law::momentum, Law::angularMomentum})), "");
}

/// In these two a wall breaks into pieces that are rigid, but hang together by one particle. (What is
/// left is of the order of the bound: ropes lose it in steps of their own.)
TEST(RandomScenes, PiecesThatHangTogetherTurnEachByItself) {
    for (const std::uint64_t seed : {560, 1484})
        EXPECT_EQ(textOf(judge(sceneOf(seed), {Law::angularMomentum})), "");
}

/// The steps of a rope that whips become shorter and longer; it is as weightless in all of them.
TEST(ScenesThatBroke, ARopeWithoutGravityStaysWhereItIs) {
    World world;
    const Body rope = world.add(shapes::rope({.from = {0, 0}, .to = {1, 0}, .links = 20}));
    rope.setGravityScale(0);
    world.setVelocity(rope.particles().back(), Vec2(0, 60));
    world.setVelocity(rope.front(), Vec2(0, -60));
    std::uint32_t most = 0;
    for (int i = 0; i < 500; ++i) {
        world.step();
        most = std::max(most, world.statistics().chainSteps);
        EXPECT_LT(rope.meanVelocity().norm(), 1e-5) << "tick " << i;
    }
    EXPECT_GT(most, 1u);
}

/// Sleepers that are struck in the tick in which the caller throws something at them.
TEST(ScenesThatBroke, WhoIsMetAtOnceIsAwake) {
    const Thing crate{
        .kind = Kind::crate, .size = 0.11, .variant = 0.093, .place = {-0.0718, 0.0585}};
    const Thing ball{.size = 0.059, .place = {-0.0618, 0.1309}, .velocity = {33, -70}};
    for (const int rate : {60, 240, 500, 2000}) {
        const Scene scene{
            .rate = rate, .ticks = 5, .sleeping = true, .calm = 2, .things = {crate, ball}};
        EXPECT_EQ(textOf(judge(scene, {Law::momentum, Law::angularMomentum})), "") << rate;
    }
}

/// A row of sleepers that do not touch: each is struck by the one before.
TEST(ScenesThatBroke, WhoIsMetByWhatWasJustStruckIsAwake) {
    const Scene scene{
        .rate = 500,
        .ticks = 12,
        .sleeping = true,
        .calm = 2,
        .things = {{.kind = Kind::crate, .size = 0.22, .variant = 0.33, .angle = -1.73},
                   {.kind = Kind::crate,
                    .size = 0.25,
                    .mass = 100,
                    .variant = 0.56,
                    .place = {0.0996, -0.2432}},
                   {.kind = Kind::crate,
                    .size = 0.22,
                    .mass = 510,
                    .variant = 0.36,
                    .place = {0.178, -0.4447},
                    .velocity = {0, 16}}}};
    EXPECT_EQ(textOf(judge(scene, {Law::momentum, Law::angularMomentum, Law::energy})), "");
}

/// Without gravity and air nothing rests that moves, however slowly.
TEST(ScenesThatBroke, WhatDriftsGoesOn) {
    const Scene scene{
        .rate = 60,
        .ticks = 200,
        .sleeping = true,
        .things = {{.kind = Kind::rod,
                    .size = 0.23,
                    .mass = 81,
                    .variant = 0.93,
                    .place = {-0.0063, -0.0655},
                    .angle = 2.865},
                   {.size = 0.225, .place = {-0.0155, -0.2065}, .velocity = {0.0084, 0.039}}}};
    EXPECT_EQ(textOf(judge(scene, {Law::momentum, Law::sleeping})), "");
}

/// A crate that bounces falls onto a blob so soft that it is pressed flat on the floor.
TEST(ScenesThatBroke, WhatIsPressedFlatGivesNoEnergy) {
    const Scene scene{.rate = 500,
                      .ticks = 400,
                      .gravity = 10,
                      .room = 0.71,
                      .things = {{.kind = Kind::blob,
                                  .size = 0.21,
                                  .variant = 0.23,
                                  .frequency = 15.8,
                                  .place = {-0.3348, -0.0871}},
                                 {.kind = Kind::crate,
                                  .size = 0.2,
                                  .variant = 0.8,
                                  .restitution = 0.677,
                                  .place = {-0.3543, 0.1387}}}};
    EXPECT_EQ(textOf(judge(scene, {Law::energy, Law::walls})), "");
}

/// The referee sees what is there: two crates that pass each other far away keep everything.
TEST(RandomScenes, WhatOnlyFliesBreaksNoLaw) {
    for (const int rate : {60, 500, 2000}) {
        const Scene scene{.rate = rate,
                          .things = {{.kind = Kind::crate, .velocity = {3, 0}, .spin = 30},
                                     {.kind = Kind::wheel, .mass = 5, .place = {9, 9}, .spin = -90},
                                     {.kind = Kind::ball, .place = {-9, 3}, .velocity = {0, 80}}}};
        EXPECT_EQ(textOf(judge(scene, allLaws())), "") << rate;
    }
}

/// What is driven into a wall that is not there breaks the law of walls; shrinking leaves only it.
TEST(RandomScenes, ShrinkingLeavesWhatBreaksTheLaw) {
    Scene scene{.ticks = 60, .room = 3};
    scene.things = {{.kind = Kind::crate, .place = {0, 2}},
                    {.kind = Kind::ball, .size = 0.4, .place = {4, 0}, .velocity = {9, 0}},
                    {.kind = Kind::jelly, .place = {0, -1.5}}};
    ASSERT_NE(textOf(judge(scene, {Law::walls})), "");
    const Scene small = shrink(scene, Law::walls);
    EXPECT_EQ(small.things.size(), 1u);
    EXPECT_EQ(small.things.front().kind, Kind::ball);
    EXPECT_NE(textOf(judge(small, {Law::walls})), "");
    EXPECT_LT(small.ticks, scene.ticks);
}

/// What turns keeps its spin and its energy, whatever a tick's chords make of them.
TEST(RandomScenes, TheSpinOfWhatTurnsFastIsMeasured) {
    for (const int rate : {60, 500, 2000})
        for (const double omega : {10.0, 100.0, 1000.0}) {
            World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
            const Body crate = world.add(shapes::box({.size = {1, 1}, .mass = 6}));
            for (const ParticleId id : crate.particles()) {
                const Point r = world.position(id);
                world.setVelocity(id, (omega * Point(-r.y(), r.x())).cast<Real>());
            }
            for (int i = 0; i < 7; ++i) {
                const Momenta now = momentaOf(world, {0, 0});
                EXPECT_NEAR(now.angular, omega, 1e-5 * omega) << rate << " Hz";
                EXPECT_NEAR(now.energy, omega * omega / 2, 1e-4 * omega * omega) << rate << " Hz";
                world.step();
            }
        }
}

}  // namespace
