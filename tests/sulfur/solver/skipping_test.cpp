// What a scene does not have it does not pay for, as the counters tell.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>
#include <sulfur/sulfur.hpp>

#include "helpers.hpp"

namespace sulfur {

namespace {

std::uint32_t itemsOf(const World& world, Stage stage) {
    return world.statistics().items[static_cast<std::size_t>(stage)];
}

std::uint32_t allItems(const World& world) {
    const auto& items = world.statistics().items;
    return std::accumulate(items.begin(), items.end(), 0u);
}

/// Crates that lie on a floor, apart, until they sleep.
struct Dormitory : testing::Test {
    static constexpr int count = 40;
    World world;
    Body floor = world.add(shapes::floor({-5, 0}, {2.0 * count, 0}));
    std::vector<Body> crates;

    Dormitory() {
        for (int i = 0; i < count; ++i)
            crates.push_back(world.add(shapes::box(), {.position = {2.0 * i, 0.53}}));
        test::run(world, 2);
    }
    bool allSleep() const {
        return std::all_of(crates.begin(), crates.end(),
                           [&](const Body& body) { return world.asleep(body); });
    }
    /// Ticks that were skipped among the next ten.
    std::uint64_t idleInTen() {
        const auto before = world.statistics().idleTicks;
        for (int i = 0; i < 10; ++i) world.step();
        return world.statistics().idleTicks - before;
    }
};

TEST_F(Dormitory, NoStageRunsWhileAllSleep) {
    ASSERT_TRUE(allSleep());
    EXPECT_EQ(idleInTen(), 10u);
    EXPECT_EQ(allItems(world), 0u);
    EXPECT_EQ(world.events().contactsEnded.size(), 0u);
}

/// A restored world does not know yet that nothing moves, and runs all stages.
TEST_F(Dormitory, AnIdleTickGivesTheSameBitsAsAWholeOne) {
    ASSERT_TRUE(allSleep());
    for (int i = 0; i < 5; ++i) {
        World whole;
        whole.restore(world.snapshot());
        whole.step();
        world.step();
        EXPECT_EQ(whole.statistics().idleTicks, 0u);
        EXPECT_GT(world.statistics().idleTicks, 0u);
        EXPECT_EQ(whole.hash(), world.hash());
    }
}

TEST_F(Dormitory, EventsAreToldOnceOnly) {
    ASSERT_TRUE(allSleep());
    world.setVelocity(crates[0], {0, 3});
    int ended = 0, begun = 0;
    for (int i = 0; i < 2000; ++i) {
        world.step();
        ended += static_cast<int>(world.events().contactsEnded.size());
        begun += static_cast<int>(world.events().contactsBegun.size());
    }
    EXPECT_TRUE(allSleep());
    EXPECT_EQ(idleInTen(), 10u);
    EXPECT_GE(ended, 1);
    EXPECT_EQ(ended, begun) << "who touched the floor touches it again";
}

TEST_F(Dormitory, WhoeverWakesEndsTheIdling) {
    ASSERT_TRUE(allSleep());
    ASSERT_EQ(idleInTen(), 10u);
    world.setVelocity(crates[7], {0, 2});
    EXPECT_EQ(idleInTen(), 0u);
    EXPECT_EQ(itemsOf(world, Stage::velocities), 1u);
}

/// No stage looks at those that sleep, however many they are, while one is awake.
TEST_F(Dormitory, OneThatIsAwakeDoesNotMakeTheOthersCost) {
    ASSERT_TRUE(allSleep());
    world.setVelocity(crates[7], {0, 2});
    world.step();
    EXPECT_EQ(world.statistics().awakeParticles, crates[7].size());
    EXPECT_EQ(itemsOf(world, Stage::changes), 1u) << "who woke enters the lists";
    world.step();
    for (const Stage stage : {Stage::changes, Stage::forces, Stage::fields, Stage::breakage})
        EXPECT_EQ(itemsOf(world, stage), 0u) << name(stage);
    EXPECT_EQ(itemsOf(world, Stage::predict), 1u);
    EXPECT_EQ(itemsOf(world, Stage::broadPhase), 4u) << "its corners";
    // It, whether it rests, and who is near it, whether they have to wake.
    EXPECT_LE(itemsOf(world, Stage::sleep), 3u);
}

TEST_F(Dormitory, AKinematicBodyDisturbsNobodyWhileItRests) {
    const Blueprint plan = [] {
        Blueprint platform = shapes::box();
        platform.kind = BodyKind::kinematic;
        return platform;
    }();
    const Body platform = world.add(plan, {.position = {0, 20}});
    test::run(world, 1);
    ASSERT_TRUE(allSleep());
    EXPECT_EQ(idleInTen(), 10u);
    world.moveTo(platform, {.position = {0, 20.01}});
    EXPECT_LE(idleInTen(), 8u);
    EXPECT_EQ(idleInTen(), 10u);
    world.setVelocity(platform, {1, 0});
    EXPECT_EQ(idleInTen(), 0u);
}

TEST_F(Dormitory, ChangesByHandEndTheIdling) {
    ASSERT_TRUE(allSleep());
    const auto sleeping = world.snapshot();
    const std::vector<std::function<void()>> changes{
        [&] {
            world.setGravity({0, 1});
        },
        [&] { world.setTickRate(250); },
        [&] {
            world.add(shapes::ball(), {.position = {0, 30}});
        },
        [&] { world.remove(crates[3]); },
        [&] { world.remove(floor); },
        [&] { world.setPinned(crates[2][0], true); },
        [&] { world.setMass(crates[2][0], 3); },
        [&] {
            world.setPosition(crates[2][0], {4, 3});
        },
        [&] { world.setStrength(crates[2].joints()[0], 1000); },
        [&] {
            world.grab(crates[2][0], {4, 3});
        },
        [&] {
            world.applyForce(crates[2][0], {1, 0});
        },
        [&] {
            world.add(UniformField{.acceleration = {0, 1}});
        }};
    for (std::size_t i = 0; i < changes.size(); ++i) {
        world.restore(sleeping);
        ASSERT_EQ(idleInTen(), 9u) << "the first tick finds out";
        changes[i]();
        const auto before = world.statistics().idleTicks;
        world.step();
        EXPECT_EQ(world.statistics().idleTicks, before) << "change " << i;
    }
}

// --- features ------------------------------------------------------------------------------

Blueprint net(Real damping, Real strength) {
    Blueprint plan;
    for (unsigned i = 0; i < 4; ++i)
        plan.particles.push_back({.position = {Real(0.1) * Real(i), 0}, .mass = 1});
    for (unsigned i = 0; i < 3; ++i)
        plan.joints.push_back(
            {.a = i, .b = i + 1, .stiffness = 100, .damping = damping, .strength = strength});
    return plan;
}

std::unique_ptr<World> withNet(Real damping, Real strength) {
    auto world = std::make_unique<World>();
    world->add(net(damping, strength));
    for (int i = 0; i < 5; ++i) world->step();
    return world;
}

TEST(Skipping, DampersOnlyWhereJointsHaveOne) {
    EXPECT_EQ(withNet(0, infinite)->statistics().dampedJoints, 0u);
    EXPECT_EQ(withNet(0, infinite)->statistics().explicitJoints, 3u);
    EXPECT_EQ(withNet(1, infinite)->statistics().dampedJoints, 3u);
}

TEST(Skipping, BreakageOnlyWhereJointsMayBreak) {
    EXPECT_EQ(itemsOf(*withNet(0, infinite), Stage::breakage), 0u);
    EXPECT_EQ(withNet(0, infinite)->statistics().breakableJoints, 0u);
    EXPECT_EQ(itemsOf(*withNet(0, 1000), Stage::breakage), 3u);
    EXPECT_EQ(withNet(0, 1000)->statistics().breakableJoints, 3u);
}

/// Crates that fly apart, without gravity: nothing is near anything.
std::unique_ptr<World> flight(Real speed, bool wall) {
    auto world = std::make_unique<World>(WorldSettings{.gravity = {0, 0}});
    for (int i = 0; i < 3; ++i) {
        const Body ball =
            world->add(shapes::ball({.radius = Real(0.1)}), {.position = {0, 3.0 * i}});
        world->setVelocity(ball, {speed, 0});
    }
    if (wall) world->add(shapes::floor({3, -5}, {3, 20}));
    return world;
}

TEST(Skipping, ContactsOnlyWhereSomethingIsNear) {
    const auto flying = flight(1, false);
    World& world = *flying;
    for (int i = 0; i < 5; ++i) world.step();
    EXPECT_EQ(itemsOf(world, Stage::narrowPhase), 0u);
    EXPECT_EQ(itemsOf(world, Stage::constraints), 0u);
    EXPECT_EQ(world.statistics().contacts, 0u);
}

/// What has no surface touches nothing.
TEST(Skipping, TheBroadPhaseLooksAtSurfacesOnly) {
    EXPECT_EQ(withNet(0, infinite)->statistics().awakeParticles, 4u);
    EXPECT_EQ(itemsOf(*withNet(0, infinite), Stage::broadPhase), 0u);
}

TEST(Skipping, WaysAreLookedAtOnlyWhereSomethingIsFast) {
    std::uint32_t slow = 0, fast = 0;
    const auto atEase = flight(1, true), hurried = flight(200, true);
    for (int i = 0; i < 20; ++i) {
        atEase->step();
        hurried->step();
        slow += atEase->statistics().fastPairs;
        fast += hurried->statistics().fastPairs;
    }
    EXPECT_EQ(slow, 0u);
    EXPECT_GT(fast, 0u);
}

/// Candidates of what stays, and of what falls side by side, are left alone.
TEST(Skipping, OnlyTheWaysOfWhatIsFastAreLookedAt) {
    World world({.sleeping = false});
    world.add(shapes::floor({-5, 0}, {45, 0}));
    for (int i = 0; i < 10; ++i) world.add(shapes::box(), {.position = {4.0 * i, 0.54}});
    for (const double x : {1.0, 2.04}) {
        const Body crate = world.add(shapes::box(), {.position = {x, 60}});
        world.setVelocity(crate, Vec2(0, -30));
    }
    std::uint32_t most = 0, least = ~0u, watched = 0;
    for (int i = 0; i < 500; ++i) {
        world.step();
        const Statistics& statistics = world.statistics();
        EXPECT_LE(2 * statistics.fastPairs, statistics.candidates) << i;
        most = std::max(most, statistics.fastPairs);
        least = std::min(least, statistics.fastPairs);
        watched = std::max(watched, statistics.candidates);
    }
    EXPECT_EQ(least, 0u);
    EXPECT_GE(watched, 11u);

    Blueprint wall = shapes::floor({-3, 0}, {-3, 40});
    world.add(wall);
    const Body shot = world.add(shapes::ball({.radius = Real(0.1)}), {.position = {20, 20}});
    world.setVelocity(shot, Vec2(-200, 0));
    for (int i = 0; i < 100; ++i) {
        world.step();
        most = std::max(most, world.statistics().fastPairs);
        EXPECT_LT(2 * world.statistics().fastPairs, world.statistics().candidates) << i;
    }
    EXPECT_GT(most, 0u);
    EXPECT_GT(world.position(shot[0]).x(), -3);
}

TEST(Skipping, FieldsAndSensorsOnlyWhereThereAreAny) {
    const auto flying = flight(1, false);
    World& world = *flying;
    world.step();
    EXPECT_EQ(itemsOf(world, Stage::fields), 0u);
    EXPECT_EQ(itemsOf(world, Stage::sensors), 0u);
    world.add(UniformField{.acceleration = {0, 1}});
    Blueprint zone = shapes::box({.size = {20, 20}});
    zone.kind = BodyKind::fixed;
    zone.sensor = true;
    world.add(zone);
    world.step();
    EXPECT_EQ(itemsOf(world, Stage::fields), world.statistics().awakeParticles);
    EXPECT_GT(itemsOf(world, Stage::sensors), 0u);
}

}  // namespace

}  // namespace sulfur
