#include <utility>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// Most of what a world may hold: what is rigid, soft, tied, driven, felt, blown at and grabbed.
void fillMixed(World& world) {
    world.add(shapes::ground({.points = {{-8, 9}, {-8, 0}, {8, 0}, {8, 9}}}));
    for (int i = 0; i < 12; ++i) {
        const Pose pose{{-5 + 0.9 * i, 1.5 + 1.3 * (i % 4)}, 0.2 * i};
        if (i % 3 == 0) world.add(shapes::box({.size = {Real(0.8), Real(0.6)}}), pose);
        if (i % 3 == 1) world.add(shapes::jelly({.size = {Real(0.7), Real(0.7)}}), pose);
        if (i % 3 == 2) world.add(shapes::ball(), pose);
    }
    const Body rope = world.add(shapes::rope({.from = {-3, 8}, .to = {1, 8}, .pinFirst = true}));
    const Body load = world.add(shapes::box({.mass = 5}), {.position = {1, 7}});
    world.attach(rope.back(), load, {0, Real(0.5)});
    world.setCollision(rope, load, false);
    Blueprint glass = shapes::jelly({.strength = 40});
    glass.name = "glass";
    glass.skin =
        Skin{"glass.png", std::vector<Vec2>(glass.particles.size(), Vec2(0, 1)), {{0, 1, 2}}};
    world.setUserData(world.add(glass, {.position = {5, 5}}), 77);
    Blueprint paddle = shapes::box({.size = {2, Real(0.2)}});
    paddle.kind = BodyKind::kinematic;
    const Body turning = world.add(paddle, {.position = {-6, 2}});
    turning.setVelocity({0, 0}, 2);
    Blueprint gate = shapes::box({.size = {3, 3}});
    gate.kind = BodyKind::fixed;
    gate.sensor = true;
    world.add(gate, {.position = {3, 2}});
    world.add(WindField{.velocity = {3, 0}, .drag = Real(0.5)});
    world.grab(world.bodies()[2], {0, 0}, {0, 6});
    load.setGravityScale(Real(0.5));
}

/// Both go on for 500 ticks, to the bit, and end with the same events.
void expectTwins(World& a, World& b) {
    ASSERT_EQ(a.hash(), b.hash());
    ASSERT_EQ(a.snapshot(), b.snapshot());
    for (int i = 0; i < 500; ++i) {
        a.step();
        b.step();
        ASSERT_EQ(a.hash(), b.hash()) << "tick " << i;
        ASSERT_EQ(a.events().contactsBegun.size(), b.events().contactsBegun.size()) << i;
        ASSERT_EQ(a.events().sensorsEntered.size(), b.events().sensorsEntered.size()) << i;
    }
    EXPECT_EQ(a.snapshot(), b.snapshot());
}

TEST(Clone, OfAMixedWorldGoesOnLikeIt) {
    World world({.airFriction = Real(0.1), .tellPersisting = true, .sweeps = 6});
    fillMixed(world);
    World young = world.clone();
    expectTwins(world, young);
    World grown = world.clone();
    EXPECT_EQ(grown.settings().sweeps, 6);
    EXPECT_TRUE(grown.settings().tellPersisting);
    expectTwins(world, grown);
}

TEST(Clone, OfAMixedWorldAtALowRateGoesOnLikeIt) {
    World world({.tickRate = 60});
    fillMixed(world);
    test::run(world, 0.5);
    World clone = world.clone();
    expectTwins(world, clone);
}

TEST(Clone, OfASleepingWorldSleepsAndWakesLikeIt) {
    World world;
    world.add(shapes::floor({-9, 0}, {9, 0}));
    for (int i = 0; i < 4; ++i) world.add(shapes::box(), {.position = {0, 0.6 + 1.001 * i}});
    test::run(world, 4);
    ASSERT_EQ(world.statistics().awakeParticles, 0u);
    World clone = world.clone();
    for (const BodyId id : clone.bodies()) EXPECT_EQ(clone.asleep(id), world.asleep(id));
    for (World* w : {&world, &clone})
        w->setVelocity(w->add(shapes::ball(), {.position = {-3, 1}}), {8, 0});
    expectTwins(world, clone);
    EXPECT_GT(world.statistics().awakeParticles, 1u) << "the ball must strike the stack";
}

TEST(Clone, InMidFlightKeepsPlacesVelocitiesAndWhatIsDrawn) {
    World world;
    const Body crate = world.add(shapes::box(), {.position = {0, 50}, .angle = 1});
    crate.setVelocity({30, 5}, 7);
    test::run(world, 0.5);
    crate.applyForce({100, 3}, {15, 51});
    World clone = world.clone();
    const Body twin = clone.body(crate);
    EXPECT_EQ(twin.centreOfMass(), crate.centreOfMass());
    EXPECT_EQ(twin.meanVelocity(), crate.meanVelocity());
    EXPECT_EQ(twin.angularVelocity(), crate.angularVelocity());
    EXPECT_EQ(twin.interpolatedPose(0.25).position, crate.interpolatedPose(0.25).position);
    EXPECT_EQ(twin.interpolatedPose(0.25).angle, crate.interpolatedPose(0.25).angle);
    EXPECT_EQ(clone.interpolated(twin[0], 0.5), world.interpolated(crate[0], 0.5));
    expectTwins(world, clone);
}

TEST(Clone, KeepsNamesSkinsUserDataAndEvents) {
    World world;
    world.add(shapes::floor({-9, 0}, {9, 0}));
    Blueprint plan = shapes::jelly();
    plan.name = "pudding";
    plan.skin =
        Skin{"pudding.png", std::vector<Vec2>(plan.particles.size(), Vec2(1, 0)), {{2, 1, 0}}};
    const Body pudding = world.add(plan, {.position = {0, 1}});
    world.setUserData(pudding, 42);
    while (world.events().contactsBegun.empty()) world.step();
    const World clone = world.clone();
    EXPECT_EQ(clone.name(pudding), "pudding");
    EXPECT_EQ(clone.userData(pudding), 42u);
    ASSERT_TRUE(clone.skin(pudding));
    EXPECT_EQ(clone.skin(pudding)->texture, "pudding.png");
    EXPECT_EQ(clone.skin(pudding)->uv, plan.skin->uv);
    ASSERT_EQ(clone.events().contactsBegun.size(), 1u);
    EXPECT_EQ(clone.events().contactsBegun[0].impulse, world.events().contactsBegun[0].impulse);
    EXPECT_EQ(clone.statistics().contacts, world.statistics().contacts);
    EXPECT_EQ(clone.ticks(), world.ticks());
}

TEST(Clone, AndItsOriginalDoNotKnowEachOther) {
    World world;
    const Body crate = world.add(shapes::box(), {.position = {0, 9}});
    World clone = world.clone();
    const auto before = clone.hash();
    test::run(world, 0.2);
    world.remove(crate);
    EXPECT_EQ(clone.hash(), before);
    EXPECT_TRUE(clone.contains(crate.id()));
}

/// Threads of which somebody can tell that they were asked for.
struct NotedTasks final : Tasks {
    int runs = 0;
    std::size_t threads() const override { return 2; }
    double overhead() const override { return 0.01; }  // divide all that can be
    void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
        ++runs;
        for (std::size_t i = 0; i < count; ++i) task(context, i);
    }
};

TEST(Clone, HasNoThreadsUntilItIsLentSome) {
    NotedTasks tasks;
    World world;
    world.setTasks(&tasks);
    for (int i = 0; i < 200; ++i) world.add(shapes::jelly(), {.position = {2.0 * i, 0}});
    world.step();
    ASSERT_GT(tasks.runs, 0);
    World clone = world.clone();
    tasks.runs = 0;
    clone.step();
    EXPECT_EQ(tasks.runs, 0);
    clone.setTasks(&tasks);
    clone.step();
    EXPECT_GT(tasks.runs, 0);
    world.step();
    world.step();
    EXPECT_EQ(clone.hash(), world.hash());
}

TEST(Move, BodiesAndHandlesFollowTheWorld) {
    World twin;
    World world;
    for (World* w : {&twin, &world}) fillMixed(*w);
    const Body crate = world.body(world.bodies()[1]);
    World moved(std::move(world));
    const Pose before = crate.pose();
    twin.body(crate).applyImpulse({3, 1}, before.position);
    crate.applyImpulse({3, 1}, before.position);
    expectTwins(twin, moved);
    EXPECT_NE(crate.pose().position, before.position);
    EXPECT_EQ(crate.pose().position, moved.pose(crate).position);
    world = std::move(moved);
    moved = World();
    expectTwins(twin, world);
    EXPECT_EQ(crate.centreOfMass(), world.centreOfMass(crate));
    EXPECT_TRUE(moved.bodies().empty());
}

TEST(Move, ARestoredWorldKeepsItsBodies) {
    World world;
    const Body crate = world.add(shapes::box(), {.position = {0, 9}});
    const Snapshot start = world.snapshot();
    test::run(world, 0.5);
    World moved(std::move(world));
    moved.restore(start);
    EXPECT_EQ(crate.centreOfMass().y(), 9);
}

TEST(Move, WorldsLiveInAVectorAndSwap) {
    std::vector<World> worlds;
    std::vector<Body> balls;
    for (int i = 0; i < 9; ++i) {
        worlds.emplace_back();
        balls.push_back(worlds.back().add(shapes::ball(), {.position = {1.0 * i, 0}}));
    }
    std::swap(worlds.front(), worlds.back());
    for (int i = 0; i < 9; ++i)
        EXPECT_EQ(balls[static_cast<std::size_t>(i)].pose().position.x(), i);
    EXPECT_EQ(worlds.front().centreOfMass(balls.back()).x(), 8);
}

}  // namespace
}  // namespace sulfur
