#include "helpers.hpp"

namespace sulfur {
namespace {

/// The largest number of steps of a tick in so many seconds.
std::uint32_t mostSubsteps(World& world, double seconds) {
    std::uint32_t most = 0;
    const int ticks = static_cast<int>(seconds * world.settings().tickRate);
    for (int i = 0; i < ticks; ++i) {
        world.step();
        most = std::max(most, world.statistics().substeps);
    }
    return most;
}

WorldSettings settings(int rate) {
    return {.tickRate = rate, .sleeping = false};
}

TEST(Substeps, AreNeverNeededAt500Hz) {
    World world(settings(500));
    world.add(shapes::ground({.points = {{-5, 0}, {5, 0}}}));
    world.add(shapes::box(), {.position = {0, 3}});
    EXPECT_EQ(mostSubsteps(world, 2), 1u);
}

TEST(Substeps, DivideTicksForWhatIsFast) {
    World world(settings(120));
    world.add(shapes::ground({.points = {{-5, 0}, {5, 0}}}));
    world.add(shapes::box(), {.position = {0, 3}});
    EXPECT_EQ(mostSubsteps(world, 1), 4u);
    // It lies still: half a second later a tick is one step again.
    mostSubsteps(world, 2);
    EXPECT_EQ(mostSubsteps(world, 1), 1u);
}

TEST(Substeps, DivideTicksForWhatStandsOnSomething) {
    World world(settings(240));
    world.add(shapes::ground({.points = {{-5, 0}, {5, 0}}}));
    for (int i = 0; i < 5; ++i) world.add(shapes::box(), {.position = {0, 0.5 + i}});
    mostSubsteps(world, 2);
    EXPECT_EQ(world.statistics().substeps, 2u);
}

TEST(Substeps, LeaveASwingingRopeAlone) {
    World world(settings(120));
    world.add(shapes::rope({.from = {0, 0}, .to = {2, 0}, .radius = 0, .pinFirst = true}));
    mostSubsteps(world, 0.5);
    EXPECT_EQ(mostSubsteps(world, 2), 1u);
}

/// Nothing can touch these: a ghost has no surface.
Blueprint ghostly(Blueprint plan) {
    for (ParticleSpec& p : plan.particles) p.radius = 0;
    for (JointSpec& j : plan.joints) j.radius = 0;
    return plan;
}

TEST(Substeps, DivideTicksForNetworksOfStiffSprings) {
    World world(settings(120));
    world.setGravity({0, 0});
    const Body jelly = world.add(ghostly(shapes::jelly({.mass = 1, .stiffness = 1000})));
    EXPECT_EQ(mostSubsteps(world, 2), 4u);
    EXPECT_EQ(world.statistics().substeps, 4u);
    world.remove(jelly.id());
    mostSubsteps(world, 1);
    EXPECT_EQ(mostSubsteps(world, 1), 1u);
}

TEST(Substeps, LeaveSoftNetworksAndStiffTreesAlone) {
    World world(settings(120));
    world.setGravity({0, 0});
    world.add(ghostly(shapes::jelly({.mass = 1, .stiffness = 10, .damping = 0})));
    Blueprint spring;
    spring.particles = {{.position = {0, 0}}, {.position = {1, 0}}, {.position = {2, 0}}};
    spring.joints = {{.a = 0, .b = 1, .stiffness = 1e6f}, {.a = 1, .b = 2, .stiffness = 1e6f}};
    world.add(spring);
    EXPECT_EQ(mostSubsteps(world, 2), 1u);
}

/// What cannot move closes no cycle, and a spring inside of a rigid frame does nothing.
TEST(Substeps, LeaveAStiffRopeOnARoomAndABracedFrameAlone) {
    World world(settings(120));
    const Body room = world.add(
        ghostly(shapes::ground({.points = {{-5, -5}, {-5, 5}, {5, 5}, {5, -5}}, .closed = true})));
    Blueprint rope;
    rope.particles = {{.position = {5, 4}}, {.position = {5, 3}}};
    rope.joints = {{.a = 0, .b = 1, .stiffness = 1e6f}};
    const Body hanging = world.add(rope);
    world.connect(room[2], hanging[0], {.stiffness = 1e6f});
    Blueprint frame;
    frame.particles = {
        {.position = {0, 0}}, {.position = {1, 0}}, {.position = {1, 1}}, {.position = {0, 1}}};
    frame.joints = {{.a = 0, .b = 2, .stiffness = 1e6f},
                    {.a = 0, .b = 1},
                    {.a = 1, .b = 2},
                    {.a = 2, .b = 3},
                    {.a = 3, .b = 0},
                    {.a = 1, .b = 3}};
    world.add(frame);
    EXPECT_EQ(mostSubsteps(world, 1), 1u);
}

/// The order of joints must not matter: a component closes the cycle of springs that end in it.
TEST(Substeps, DivideTicksForStiffSpringsThatARigidPartJoins) {
    for (const bool rigidFirst : {true, false}) {
        World world(settings(120));
        Blueprint plan;
        plan.particles = {{.position = {0, 0}}, {.position = {1, 0}}, {.position = {0.5f, 1}}};
        if (rigidFirst) plan.joints.push_back({.a = 0, .b = 1});
        plan.joints.push_back({.a = 0, .b = 2, .stiffness = 1e6f});
        plan.joints.push_back({.a = 2, .b = 1, .stiffness = 1e6f});
        if (!rigidFirst) plan.joints.push_back({.a = 0, .b = 1});
        world.add(plan);
        EXPECT_EQ(mostSubsteps(world, 1), 4u) << rigidFirst;
    }
}

/// Falls, targets of kinematic bodies, the clock, and what is told are those of the tick.
TEST(Substeps, KeepWhatATickMeans) {
    World world(settings(120));
    world.add(shapes::ground({.points = {{-5, 0}, {5, 0}}}));
    const Body ball = world.add(shapes::ball(), {.position = {0, 8}});
    Blueprint plan = shapes::box();
    plan.kind = BodyKind::kinematic;
    const Body lift = world.add(plan, {.position = {3, 5}});
    for (int i = 1; i <= 60; ++i) {
        world.moveTo(lift.id(), {.position = {3 + 0.1 * i, 5}});
        world.step();
        EXPECT_EQ(world.statistics().substeps, 4u);
        EXPECT_NEAR(world.centreOfMass(lift.id())[0], 3 + 0.1 * i, 1e-5);
    }
    EXPECT_DOUBLE_EQ(world.time(), 0.5);
    EXPECT_FLOAT_EQ(static_cast<float>(world.tickDuration()), 1.f / 120);
    EXPECT_NEAR(world.position(ball.front())[1], 8 - 9.81 / 2 * 0.25, 1e-4);
    int begun = 0;
    for (int i = 0; i < 240; ++i) {
        world.step();
        begun += static_cast<int>(world.events().contactsBegun.size());
    }
    EXPECT_EQ(begun, 1);
}

TEST(Substeps, GoOnAfterASnapshot) {
    World world(settings(120));
    world.add(shapes::ground({.points = {{-5, 0}, {5, 0}}}));
    for (int i = 0; i < 3; ++i) world.add(shapes::box(), {.position = {0.1 * i, 1 + 1.2 * i}});
    mostSubsteps(world, 0.7);
    const auto saved = world.snapshot();
    mostSubsteps(world, 1);
    World other(settings(500));
    other.restore(saved);
    mostSubsteps(other, 1);
    EXPECT_EQ(other.hash(), world.hash());
}

}  // namespace
}  // namespace sulfur
