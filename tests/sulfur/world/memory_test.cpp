// What a world holds in memory.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <sulfur/sulfur.hpp>

namespace sulfur {

namespace {

/// Crates, soft squares and ropes, `count` of each, apart.
std::unique_ptr<World> crowd(int count) {
    auto world = std::make_unique<World>();
    const Blueprint plans[] = {shapes::box(), shapes::jelly({.columns = 4, .rows = 4}),
                               shapes::rope({.to = {0, -5}, .links = 10, .pinFirst = true})};
    for (int i = 0; i < count; ++i)
        for (int kind = 0; kind < 3; ++kind)
            world->add(plans[kind], {.position = {10.0 * i, 10.0 * kind}});
    for (int i = 0; i < 10; ++i) world->step();
    return world;
}

MemoryUse useOf(const World& world, const char* name) {
    for (const MemoryUse& use : world.memory())
        if (std::strcmp(use.name, name) == 0) return use;
    ADD_FAILURE() << "no row of " << name;
    return {};
}

double all(const World& world) {
    double bytes = 0;
    for (const MemoryUse& use : world.memory()) bytes += static_cast<double>(use.bytes);
    return bytes;
}

}  // namespace

TEST(Memory, AHotParticleFitsIn96BytesAndAJointIn64) {
    const auto made = crowd(100);
    const World& world = *made;
    const MemoryUse particles = useOf(world, "particles: motion and surface");
    EXPECT_EQ(particles.items, world.statistics().particles);
    EXPECT_TRUE(particles.hot);
    const MemoryUse joints = useOf(world, "joints: what holds");
    EXPECT_EQ(joints.items, world.statistics().joints);
    if (sizeof(Real) == sizeof(double)) return;  // which is not what games are built with
    EXPECT_LE(particles.perItem(), 96);
    EXPECT_LE(joints.perItem(), 64);
    EXPECT_GE(particles.perItem(), 64);  // place, velocity, force, displacement and a mass
}

TEST(Memory, JointsInSweepsHaveNoMoreInTheirLanes) {
    World world;
    for (int i = 0; i < 50; ++i)
        world.add(shapes::jelly({.columns = 8, .rows = 8, .stiffness = Real(1e6)}),
                  {.position = {20.0 * i, 0}});
    world.step();
    const MemoryUse lanes = useOf(world, "joints in sweeps: their lanes");
    EXPECT_EQ(lanes.items, world.statistics().sweptJoints);
    EXPECT_GT(lanes.items, 5000u);
    if (sizeof(Real) == sizeof(double)) return;
    EXPECT_LE(lanes.perItem(), 64);
}

TEST(Memory, GrowsWithTheWorldAndNoFaster) {
    const double small = all(*crowd(100)), large = all(*crowd(800));
    EXPECT_GT(large, 7.9 * small);
    EXPECT_LT(large, 8.1 * small);
}

TEST(Memory, AnEmptyWorldHoldsNothing) {
    EXPECT_EQ(all(World()), 0);
}

}  // namespace sulfur
