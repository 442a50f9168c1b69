// Runs the checks that are written in C, and holds a scene made in C against the same in C++.
#include "../helpers.hpp"
#include "checks.h"

namespace sulfur {
namespace {

/// The scene of scene.c.
std::vector<Body> makeScene(World& world) {
    Material rough;
    rough.staticFriction = Real(0.75);
    world.add(shapes::ground({.points = {{-8, 9}, {-8, 0}, {8, 0}, {8, 9}}, .material = rough}));
    std::vector<Body> crates;
    for (int i = 0; i < 5; ++i)
        crates.push_back(
            world.add(shapes::box(), {.position = {-5, 0.6 + 1.1 * i}, .angle = 0.05 * i}));
    world.setUserData(crates[2], 99);
    const Body rope = world.add(shapes::rope({.from = {-2, 8}, .to = {1, 8}, .pinFirst = true}));
    const Body load = world.add(shapes::box({.size = {Real(0.75), Real(0.5)}, .mass = 5}),
                                {.position = {1, 7.75}});
    world.attach(rope.back(), load, {0, Real(0.25)});
    const Body jelly = world.add(shapes::jelly(), {.position = {-2, 2}, .angle = 0.25});
    world.add(shapes::wall({.strength = 300}), {.position = {5, 0.6}});
    const Body ball = world.add(shapes::ball(), {.position = {1.5, 1}});
    ball.setVelocity({20, 1}, -3);
    world.add(WindField{.velocity = {2, 0}, .drag = Real(0.125)});
    world.grab(jelly, {Real(0.25), Real(0.25)}, {-2, 4});
    return crates;
}

TEST(CInterface, ASceneMadeInCHasTheBitsOfTheSameInCpp) {
    World world({.gravity = {0, Real(-9.75)}, .airFriction = Real(0.0625)});
    const std::vector<Body> crates = makeScene(world);
    SulfurWorld* other = nullptr;
    SulfurBodyId ids[5];
    ASSERT_STREQ(c_make_scene(&other, ids), nullptr);
    std::uint64_t hash = 0;
    for (int i = 0; i < 500; ++i) {
        world.step();
        ASSERT_EQ(sulfur_world_step(other), SULFUR_OK) << sulfur_last_error();
        ASSERT_EQ(sulfur_world_hash(other, &hash), SULFUR_OK);
        ASSERT_EQ(hash, world.hash()) << i;
    }
    for (std::size_t i = 0; i < 5; ++i) {
        SulfurVec centre{};
        ASSERT_EQ(sulfur_body_centre_of_mass(other, ids[i], &centre), SULFUR_OK);
        EXPECT_EQ(centre.x, crates[i].centreOfMass().x());
        EXPECT_EQ(centre.y, crates[i].centreOfMass().y());
    }
    sulfur_world_destroy(other);
}

TEST(CInterface, Bodies) {
    EXPECT_STREQ(c_check_bodies(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Blueprints) {
    EXPECT_STREQ(c_check_blueprint(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Angles) {
    EXPECT_STREQ(c_check_angles(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Parts) {
    EXPECT_STREQ(c_check_parts(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Mechanisms) {
    EXPECT_STREQ(c_check_mechanisms(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Queries) {
    EXPECT_STREQ(c_check_queries(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Events) {
    EXPECT_STREQ(c_check_events(), nullptr) << sulfur_last_error();
}

TEST(CInterface, State) {
    EXPECT_STREQ(c_check_state(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Draw) {
    EXPECT_STREQ(c_check_draw(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Errors) {
    EXPECT_STREQ(c_check_errors(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Threads) {
    EXPECT_STREQ(c_check_threads(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Callbacks) {
    EXPECT_STREQ(c_check_callbacks(), nullptr) << sulfur_last_error();
}

/// What a callback in C answers arrives as it does in C++.
TEST(CInterface, CallbacksHaveTheBitsOfTheSameInCpp) {
    World world({.gravity = {0, Real(-9.75)}, .airFriction = Real(0.0625)});
    makeScene(world);
    world.setShouldCollide([](BodyId a, BodyId b) { return (a.index + b.index) % 3 != 0; });
    world.setPreSolve([](const PreSolveContact& contact, Material& surface) {
        surface.staticFriction = surface.kineticFriction = Real(0.125);
        surface.surfaceSpeed = contact.gap < Real(0.001) ? contact.speed : Real(1);
        return contact.a.index % 4 != 0;
    });
    SulfurWorld* other = nullptr;
    SulfurBodyId ids[5];
    ASSERT_STREQ(c_make_scene(&other, ids), nullptr);
    sulfur_world_set_should_collide(
        other, [](void*, SulfurBodyId a, SulfurBodyId b) { return (a.index + b.index) % 3 != 0; },
        nullptr);
    sulfur_world_set_pre_solve(
        other,
        [](void*, const SulfurPreSolveContact* contact, SulfurMaterial* surface) {
            surface->static_friction = surface->kinetic_friction = 0.125;
            const bool near = contact->gap < static_cast<double>(Real(0.001));
            surface->surface_speed = near ? contact->speed : 1;
            return contact->a.index % 4 != 0;
        },
        nullptr);
    std::uint64_t hash = 0;
    for (int i = 0; i < 250; ++i) {
        world.step();
        ASSERT_EQ(sulfur_world_step(other), SULFUR_OK) << sulfur_last_error();
        ASSERT_EQ(sulfur_world_hash(other, &hash), SULFUR_OK);
        ASSERT_EQ(hash, world.hash()) << i;
    }
    sulfur_world_destroy(other);
}

/// Exceptions of functions that the caller gave do not go through C.
TEST(CInterface, NoExceptionLeavesIt) {
    SulfurWorld* world = nullptr;
    SulfurBodyId ids[5];
    ASSERT_STREQ(c_make_scene(&world, ids), nullptr);
    SulfurQueryFilter filter = sulfur_query_filter_default();
    filter.accept = [](void*, SulfurBodyId) -> bool { throw 3; };
    std::size_t count = 77;
    EXPECT_EQ(sulfur_world_bodies_at(world, {-5, 0.6}, &filter, nullptr, 0, &count), SULFUR_FAILED);
    EXPECT_EQ(count, 77u);
    std::uint64_t ticks = 0;
    sulfur_world_set_should_collide(
        world, [](void*, SulfurBodyId, SulfurBodyId) -> bool { throw 3; }, nullptr);
    EXPECT_EQ(sulfur_world_step(world), SULFUR_FAILED);
    EXPECT_EQ(sulfur_world_ticks(world, &ticks), SULFUR_OK);
    EXPECT_EQ(ticks, 1u);
    sulfur_world_destroy(world);
}

}  // namespace
}  // namespace sulfur
