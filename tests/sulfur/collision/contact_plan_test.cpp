// What contacts keep from tick to tick changes nothing but the time that a tick takes.
#include "collision/contact_plan.hpp"

#include "helpers.hpp"

namespace sulfur {
namespace {

Body addGround(World& world) {
    return world.add(shapes::ground({.points = {{-20, 9}, {-20, 0}, {0, -1}, {20, 0}, {20, 9}}}));
}

/// Crates side by side and on each other.
void addPile(World& world) {
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4 - row; ++column)
            world.add(shapes::box(), {.position = {(column + row / 2.0) * 1.1, 0.52 + 1.02 * row}});
}

TEST(ContactPlans, NothingIsLookedUpAtRest) {
    World world({.sleeping = false});
    world.add(shapes::ground({.points = {{-20, 0}, {20, 0}}}));
    addPile(world);
    test::run(world, 1);
    EXPECT_GT(world.statistics().contacts, 20u);
    for (int i = 0; i < 100; ++i) {
        world.step();
        EXPECT_EQ(world.statistics().plannedContacts, 0u) << i;
    }
}

TEST(ContactPlans, EverythingIsLookedUpAgainOnceWhereMaterialsChange) {
    World world({.sleeping = false});
    const Body floor = world.add(shapes::ground({.points = {{-20, 0}, {20, 0}}}));
    addPile(world);
    test::run(world, 1);
    world.setMaterial(floor, Material{});
    world.step();
    EXPECT_GE(world.statistics().plannedContacts, world.statistics().contacts);
    world.step();
    EXPECT_EQ(world.statistics().plannedContacts, 0u);
    world.setMaterial(floor.joints()[0], Material{});
    world.step();
    EXPECT_GE(world.statistics().plannedContacts, world.statistics().contacts);
}

TEST(ContactPlans, ContactsThatStandTakeUpNewMaterials) {
    World world({.sleeping = false});
    const Body floor = world.add(shapes::ground({.points = {{-20, 0}, {20, 0}}}));
    const Body crate = world.add(shapes::box(), {.position = {0, 0.5}});
    test::run(world, 0.5);
    const double before = world.position(crate.front()).x();
    world.setMaterial(floor, Material{.surfaceSpeed = 1});
    test::run(world, 1);
    EXPECT_GT(std::abs(world.position(crate.front()).x() - before), 0.5);
}

/// Falls, rolls, slides, hangs, breaks, is driven, and rests.
struct Scene {
    explicit Scene(World& w) : world(w) {
        ground = addGround(world);
        addPile(world);
        for (int i = 0; i < 6; ++i) {
            world.add(shapes::box({.size = {Real(0.9), Real(0.4)}, .strength = 500}),
                      {.position = {-12 + 2.1 * i, 5 + i}, .angle = 0.5 * i});
            world.add(shapes::blob({.radius = Real(0.4)}), {.position = {4 + 2.0 * i, 3}});
        }
        world.add(shapes::jelly({.columns = 4, .rows = 4}), {.position = {-6, 3}});
        const Body slider = world.add(shapes::box(), {.position = {-17, 1.5}});
        world.setVelocity(slider, {12, 0});
        world.add(shapes::rope({.from = {-4, 6}, .to = {4, 6}, .pinFirst = true}));
        Blueprint plan = shapes::box({.size = {3, Real(0.3)}});
        plan.kind = BodyKind::kinematic;
        paddle = world.add(plan, {.position = {-10, 2}});
        world.setVelocity(paddle, {2, 0});
    }

    void step(int tick) {
        if (tick == 150) world.setVelocity(paddle, {-1, Real(0.5)});
        if (tick % 90 == 30)
            world.add(shapes::box({.size = {Real(0.6), Real(0.6)}}),
                      {.position = {-3 + tick / 100.0, 8}});
        world.step();
    }

    World& world;
    Body ground, paddle;
};

TEST(ContactPlans, LookingEverythingUpInEachTickGivesTheSameBits) {
    World kept({.sleeping = false}), renewed({.sleeping = false});
    Scene a(kept), b(renewed);
    std::uint64_t lookedUp = 0, lookedUpAnew = 0;
    for (int tick = 0; tick < 700; ++tick) {
        renewed.setMaterial(b.ground, renewed.material(b.ground));
        a.step(tick);
        b.step(tick);
        ASSERT_EQ(kept.hash(), renewed.hash()) << tick;
        lookedUp += kept.statistics().plannedContacts;
        lookedUpAnew += renewed.statistics().plannedContacts;
    }
    EXPECT_LT(3 * lookedUp, lookedUpAnew);
}

TEST(ContactPlans, ALoadedWorldGoesOnTheSame) {
    World world;
    Scene scene(world);
    for (int tick = 0; tick < 400; ++tick) scene.step(tick);
    World loaded;
    loaded.restore(world.snapshot());
    for (int tick = 0; tick < 200; ++tick) {
        world.step();
        loaded.step();
        ASSERT_EQ(world.hash(), loaded.hash()) << tick;
    }
}

}  // namespace
}  // namespace sulfur
