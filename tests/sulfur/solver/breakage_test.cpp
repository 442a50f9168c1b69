#include <set>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// A rope of rigid links that hangs from its first particle, and breaks in one link.
Body weakRope(World& world, std::uint32_t weak, Real radiusOfLast = 0) {
    Blueprint plan = shapes::rope(
        {.from = {0, 0}, .to = {0, -1}, .links = 10, .mass = Real(1.1), .pinFirst = true});
    plan.joints[weak].strength = Real(0.5);
    plan.particles.back().radius = radiusOfLast;
    return world.add(plan);
}

TEST(Breakage, ARopeBecomesTwoBodies) {
    World world;
    const Body rope = weakRope(world, 4);
    world.setUserData(rope, 42);
    std::vector<BodySplit> splits;
    for (int i = 0; i < 50; ++i) {
        world.step();
        const auto& now = world.events().bodiesSplit;
        splits.insert(splits.end(), now.begin(), now.end());
    }
    ASSERT_EQ(splits.size(), 1u);
    EXPECT_EQ(splits[0].body, rope.id());
    const Body piece = world.body(splits[0].piece);
    // The heavier part, the lower six particles, keeps the handle.
    EXPECT_EQ(rope.size(), 6u);
    EXPECT_EQ(rope.joints().size(), 5u);
    EXPECT_EQ(piece.size(), 5u);
    EXPECT_EQ(piece.joints().size(), 4u);
    EXPECT_EQ(world.userData(piece), 42u);
    EXPECT_EQ(world.bodies().size(), 2u);
    EXPECT_EQ(world.validate(), "");
    test::run(world, 1);
    EXPECT_LT(world.centreOfMass(rope)[1], -4);
    EXPECT_GT(world.centreOfMass(piece)[1], -1);
    for (const BodyId id : {rope.id(), piece.id()})
        for (const JointId joint : world.joints(id)) EXPECT_EQ(world.info(joint).body, id);
}

/// All of its links are overloaded in the same tick, and one that breaks relieves the others: they
/// all went, and the rope with them.
TEST(Breakage, ARopeTearsAtOnePlace) {
    for (const bool pinLast : {false, true}) {
        World world;
        Blueprint plan = shapes::rope(
            {.from = {0, 0}, .to = {2, Real(pinLast ? -0.2 : 0)}, .links = 20, .pinFirst = true});
        for (auto& joint : plan.joints) joint.strength = 300;
        plan.particles.back().pinned = pinLast;
        if (!pinLast) plan.particles.back().mass = 20;
        world.add(plan);
        if (pinLast) world.add(shapes::box({.mass = 50}), {.position = {1, 2}});
        std::size_t broken = 0;
        for (int i = 0; i < 1500 && broken == 0; ++i) {
            world.step();
            broken = world.events().jointsBroken.size();
        }
        EXPECT_EQ(broken, 1u) << pinLast;
        EXPECT_EQ(world.validate(), "");
    }
}

TEST(Breakage, AParticleWithoutJointsGoesUnlessItIsADisc) {
    for (const Real radius : {Real(0), Real(0.1)}) {
        World world;
        const Body rope = weakRope(world, 9, radius);
        const ParticleId last = rope.back();
        int lost = 0, split = 0;
        for (int i = 0; i < 50; ++i) {
            world.step();
            for (const ParticleLost& event : world.events().particlesLost) {
                ++lost;
                EXPECT_EQ(event.particle, last);
                EXPECT_EQ(event.body, rope.id());
                EXPECT_NEAR(event.point[1], -1, 0.05);
            }
            split += static_cast<int>(world.events().bodiesSplit.size());
        }
        EXPECT_EQ(lost, radius == 0 ? 1 : 0);
        EXPECT_EQ(split, radius == 0 ? 0 : 1);
        EXPECT_EQ(world.contains(last), radius > 0);
        EXPECT_EQ(rope.size(), 10u);
        EXPECT_EQ(world.validate(), "");
    }
}

/// A wall that was shot at left pieces from which corners without a surface hung on diagonals,
/// through the floor.
TEST(Breakage, WhatLosesTheLastOfItsSurfaceLosesItsBracesToo) {
    World world;
    Blueprint plan;
    plan.particles = {{.position = {0, 0}, .mass = 1, .pinned = true},
                      {.position = {1, 0}, .mass = 1, .pinned = true},
                      {.position = {1, 1}, .mass = 1},
                      {.position = {0, 1}, .mass = 1}};
    const Real radius = Real(0.02);
    plan.joints = {{.a = 0, .b = 1, .radius = radius},
                   {.a = 1, .b = 2, .radius = radius},
                   {.a = 2, .b = 3, .radius = radius, .strength = Real(0.01)},
                   {.a = 3, .b = 0, .radius = radius, .strength = Real(0.01)},
                   {.a = 0, .b = 2},
                   {.a = 1, .b = 3}};
    const Body body = world.add(plan);
    const ParticleId corner = body[3];
    int broken = 0, lost = 0;
    for (int i = 0; i < 50; ++i) {
        world.step();
        broken += static_cast<int>(world.events().jointsBroken.size());
        lost += static_cast<int>(world.events().particlesLost.size());
    }
    EXPECT_EQ(broken, 3);
    EXPECT_EQ(lost, 1);
    EXPECT_FALSE(world.contains(corner));
    EXPECT_EQ(body.size(), 3u);
    EXPECT_EQ(body.joints().size(), 3u);
    EXPECT_EQ(world.validate(), "");
}

/// But not a corner on which another body hangs.
TEST(Breakage, WhatHoldsAnotherBodyKeepsItsBraces) {
    World world;
    Blueprint plan;
    plan.particles = {{.position = {0, 0}, .mass = 1, .pinned = true},
                      {.position = {1, 0}, .mass = 1, .pinned = true},
                      {.position = {0, 1}, .mass = 1}};
    plan.joints = {{.a = 0, .b = 2, .radius = Real(0.02), .strength = Real(0.01)},
                   {.a = 1, .b = 2}};
    const Body frame = world.add(plan);
    const Body ball =
        world.add(shapes::ball({.radius = Real(0.1), .mass = 1}), {.position = Point(0, -1)});
    const ParticleId corner = frame[2];
    world.connect(corner, ball[0]);
    test::run(world, 0.1);
    EXPECT_TRUE(world.contains(corner));
    EXPECT_EQ(frame.size(), 2u);  // the other end of what broke is gone
    EXPECT_EQ(frame.joints().size(), 1u);
    EXPECT_EQ(world.validate(), "");
}

TEST(Breakage, SkinsAreCutWithTheirBodies) {
    World world;
    Blueprint plan = shapes::jelly({.size = {4, 1}, .columns = 5, .rows = 2, .stiffness = 2000});
    plan.skin = Skin{.texture = "jelly"};
    for (const auto& p : plan.particles) plan.skin->uv.push_back({p.position[0], p.position[1]});
    for (std::uint32_t c = 0; c < 4; ++c) plan.skin->triangles.push_back({c, c + 1, c + 5});
    // Everything between the third and the fourth column is weak.
    for (auto& joint : plan.joints) {
        const auto a = joint.a % 5, b = joint.b % 5;
        if (std::min(a, b) == 2 && std::max(a, b) == 3) joint.strength = Real(0.01);
    }
    plan.particles[0].pinned = plan.particles[5].pinned = true;
    const Body body = world.add(plan);
    test::run(world, 1);
    ASSERT_EQ(world.bodies().size(), 2u);
    const BodyId piece = world.bodies()[1];
    EXPECT_EQ(world.skin(body)->triangles.size(), 2u);
    EXPECT_EQ(world.skin(piece)->triangles.size(), 1u);
    EXPECT_EQ(world.skin(piece)->uv.size(), world.particles(piece).size());
    for (const auto& triangle : world.skin(piece)->triangles)
        for (const auto corner : triangle) EXPECT_LT(corner, world.particles(piece).size());
    EXPECT_EQ(world.validate(), "");
}

/// The joints of a rigid crate are not solved, yet they carry it and break.
TEST(Breakage, ARigidCrateKnowsWhatItsJointsCarry) {
    World world({.airFriction = 3, .sleeping = false});
    Blueprint plan = shapes::box({.mass = 2, .strength = 1000});
    plan.particles[3].pinned = true;
    const Body crate = world.add(plan);
    test::run(world, 15);
    EXPECT_EQ(world.statistics().clusters, 1u);
    EXPECT_EQ(world.statistics().rigidJoints, 0u);
    for (const ParticleId p : crate.particles()) {
        const ParticleInfo info = world.info(p);
        if (info.pinned) continue;
        Point sum(0, -9.81 * static_cast<double>(info.mass));
        for (const JointId j : crate.joints()) {
            const JointInfo joint = world.info(j);
            if (joint.a != p && joint.b != p) continue;
            const Point other = world.position(joint.a == p ? joint.b : joint.a);
            sum += static_cast<double>(joint.force) * (other - info.position).normalized();
        }
        EXPECT_NEAR(sum.norm(), 0, 0.002);
    }
}

TEST(Breakage, ARigidCrateShattersWhenItFallsHard) {
    for (const double height : {0.3, 30.0}) {
        World world;
        world.add(shapes::floor({-20, 0}, {20, 0}));
        world.add(shapes::box({.mass = 2, .strength = 3000}), {.position = {0, height + 0.6}});
        std::size_t broken = 0;
        for (int i = 0; i < 2000; ++i) {
            world.step();
            broken += world.events().jointsBroken.size();
        }
        EXPECT_EQ(broken > 0, height > 1) << height << " " << broken;
        EXPECT_EQ(world.validate(), "");
    }
}

/// A piece that breaks off is a rigid component of its own.
TEST(Breakage, PiecesOfARigidBodyMoveAsOne) {
    World world({.gravity = {0, 0}, .sleeping = false});
    Blueprint plan = shapes::wall({.size = {4, 1}, .columns = 4, .rows = 1});
    for (auto& joint : plan.joints) joint.strength = infinite;
    for (auto& joint : plan.joints) {
        const auto a = joint.a % 5, b = joint.b % 5;
        if (std::min(a, b) == 1 && std::max(a, b) == 2) joint.strength = 10;
    }
    const Body wall = world.add(plan);
    world.step();
    EXPECT_EQ(world.statistics().clusters, 1u);
    for (std::size_t i = 0; i < wall.size(); ++i)
        world.applyForce(wall[i], {i % 5 < 2 ? Real(-2000) : Real(2000), 0});
    test::run(world, 0.1);
    EXPECT_EQ(world.bodies().size(), 2u);
    EXPECT_EQ(world.statistics().clusters, 2u);
    EXPECT_EQ(world.validate(), "");
}

}  // namespace
}  // namespace sulfur
