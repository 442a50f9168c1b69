// World::step takes no memory from the system once it has warmed up.
//
// Every allocation of this program is counted: those of operator new, and where the C library is
// glibc and no sanitizer stands in its place, those of malloc too, which Eigen calls itself.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <new>
#include <sulfur/sulfur.hpp>
#include <thread>

namespace {

std::size_t allocations = 0;

}  // namespace

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
extern "C" {
void* __libc_malloc(std::size_t size);  // NOLINT: glibc's own name

void* malloc(std::size_t size) {
    ++allocations;
    return __libc_malloc(size);
}
}
#endif

void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace sulfur {

namespace {

constexpr Real rigid = std::numeric_limits<Real>::infinity();

/// Expects that the ticks after a warm-up allocate nothing.
void expectNoAllocations(World& world) {
    for (int i = 0; i < 200; ++i) world.step();
    const std::size_t before = allocations;
    for (int i = 0; i < 500; ++i) world.step();
    EXPECT_EQ(allocations - before, 0u);
}

/// Particles side by side and above each other, each held to its neighbours.
Blueprint net(unsigned side, Real stiffness) {
    Blueprint plan;
    for (unsigned i = 0; i < side * side; ++i)
        plan.particles.push_back(
            {.position = Vec2(Real(0.1) * Real(i % side), Real(0.1) * Real(i / side)),
             .mass = Real(0.05)});
    for (unsigned i = 0; i < side * side; ++i) {
        if (i % side + 1 < side)
            plan.joints.push_back({.a = i, .b = i + 1, .stiffness = stiffness});
        if (i + side < side * side)
            plan.joints.push_back({.a = i, .b = i + side, .stiffness = stiffness});
    }
    return plan;
}

Blueprint rope(unsigned links, Real radius = 0) {
    Blueprint plan;
    for (unsigned i = 0; i <= links; ++i)
        plan.particles.push_back(
            {.position = Vec2(Real(0.1) * Real(i), 0), .mass = Real(0.05), .pinned = i == 0});
    for (unsigned i = 0; i < links; ++i)
        plan.joints.push_back({.a = i, .b = i + 1, .stiffness = rigid, .radius = radius});
    return plan;
}

}  // namespace

TEST(Allocation, IsCounted) {
    const std::size_t before = allocations;
    delete new World();
    EXPECT_GT(allocations, before);
}

TEST(Allocation, NoneByRopes) {
    World world;
    for (int i = 0; i < 10; ++i) world.add(rope(40), {.position = {5.0 * i, 0}});
    expectNoAllocations(world);
}

TEST(Allocation, NoneByAJelly) {
    World world;
    const Body body = world.add(net(10, 1e6));
    world.setPinned(body[90], true);
    world.setPinned(body[99], true);
    expectNoAllocations(world);
    EXPECT_GT(world.statistics().implicitJoints, 0u);
}

TEST(Allocation, NoneByARigidMesh) {
    World world;
    const Body body = world.add(net(10, rigid));
    world.setPinned(body[90], true);
    world.setPinned(body[99], true);
    expectNoAllocations(world);
    EXPECT_GT(world.statistics().rigidJoints, 0u);
}

/// They fall, and lie, and fall asleep.
TEST(Allocation, NoneByCratesThatLieOnTheFloor) {
    World world;
    world.add(shapes::floor({-20, 0}, {20, 0}));
    for (int i = 0; i < 5; ++i) world.add(shapes::box(), {.position = {3.0 * i - 6, 0.55}});
    expectNoAllocations(world);
}

/// Each step of a tick tells events.
TEST(Allocation, NoneByTicksOfSeveralSteps) {
    World world({.tickRate = 120, .sleeping = false, .tellPersisting = true});
    world.add(shapes::floor({-20, 0}, {20, 0}));
    for (int i = 0; i < 5; ++i)
        world.add(shapes::ball({.material = {.restitution = 1}}), {.position = {3.0 * i - 6, 3}});
    for (int i = 0; i < 10; ++i)
        world.add(shapes::box(), {.position = {3.0 * (i / 2) - 4.5, 0.55 + i % 2}});
    for (int i = 0; i < 1000; ++i) world.step();
    std::size_t begun = 0, persisted = 0, ended = 0;
    const std::size_t before = allocations;
    for (int i = 0; i < 500; ++i) {
        world.step();
        begun += world.events().contactsBegun.size();
        persisted += world.events().contactsPersisted.size();
        ended += world.events().contactsEnded.size();
    }
    EXPECT_EQ(allocations - before, 0u);
    EXPECT_GT(begun, 5u);
    EXPECT_GT(persisted, 500u);
    EXPECT_GT(ended, 5u);
}

/// All that can be divided is. (By one thread, so that allocations are counted one by one.)
TEST(Allocation, NoneByDividedWork) {
    struct Divided final : Tasks {
        std::size_t threads() const override { return 3; }
        double overhead() const override { return 0.01; }
        void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
            for (std::size_t i = count; i-- > 0;) task(context, i);
        }
    } tasks;
    World world({.sleeping = false});
    world.setTasks(&tasks);
    world.add(shapes::floor({-40, 0}, {40, 0}));
    for (int row = 0; row < 12; ++row)
        for (int column = 0; column < 12 - row; ++column)
            world.add(shapes::box(), {.position = {0.5 * row + 1.05 * column - 6, 0.5 + row}});
    for (int i = 0; i < 10; ++i)
        world.add(shapes::jelly({.size = {1, 1}, .columns = 3, .rows = 3}),
                  {.position = {10 + 1.2 * (i % 5), 0.6 + 1.2 * (i / 5)}});
    for (int i = 0; i < 2500; ++i) world.step();  // until the jellies rest
    expectNoAllocations(world);
}

TEST(Allocation, NoneByCratesInFreeFall) {
    World world;
    for (int i = 0; i < 5; ++i) world.add(shapes::box(), {.position = {3.0 * i, 0}});
    expectNoAllocations(world);
}

/// Their joints' loads are recovered in every tick.
TEST(Allocation, NoneByCratesThatCanBreak) {
    World world({.sleeping = false});
    world.add(shapes::floor({-20, 0}, {20, 0}));
    for (int i = 0; i < 3; ++i)
        world.add(shapes::box({.strength = Real(1e6)}), {.position = {3.0 * i - 6, 0.55}});
    expectNoAllocations(world);
}

/// Those of rigid components of several sizes, in turn.
TEST(Allocation, NoneByCratesAndWheelsThatCanBreak) {
    World world({.sleeping = false});
    world.add(shapes::floor({-20, 0}, {20, 0}));
    for (int i = 0; i < 3; ++i) {
        world.add(shapes::box({.strength = Real(1e6)}), {.position = {6.0 * i - 9, 0.55}});
        world.add(shapes::wheel({.strength = Real(1e6)}), {.position = {6.0 * i - 6, 0.55}});
    }
    expectNoAllocations(world);
}

/// Scratch memory belongs to the world, so that a thread that has stepped none before needs none.
TEST(Allocation, NoneInAnotherThread) {
    World world({.sleeping = false});
    world.add(shapes::floor({-20, 0}, {20, 0}));
    for (int i = 0; i < 2; ++i) {
        world.add(shapes::box({.strength = Real(1e6)}), {.position = {2.0 * i - 10, 0.55}});
        world.add(shapes::jelly({.size = {1, 1}, .columns = 3, .rows = 3}),
                  {.position = {2.0 * i - 5, 0.6}});
        world.add(rope(20, Real(0.02)), {.position = {4.0 * i, 0.3}});
        const Body line = world.add(rope(20), {.position = {4.0 * i, 10}});
        const Body crate = world.add(shapes::box(), {.position = {4.0 * i + 2.5, 10}});
        if (i == 1) world.attach(line[20], crate.id(), Vec2(Real(-0.5), 0));
    }
    for (int i = 0; i < 200; ++i) world.step();
    std::size_t taken = 1;
    std::thread([&] {
        const std::size_t before = allocations;
        for (int i = 0; i < 100; ++i) world.step();
        taken = allocations - before;
    }).join();
    EXPECT_EQ(taken, 0u);
}

TEST(Allocation, NoneByARopeWithACrate) {
    World world;
    const Body line = world.add(rope(20));
    const Body crate = world.add(shapes::box(), {.position = {2.5, 0}});
    world.attach(line[20], crate.id(), Vec2(Real(-0.5), 0));
    expectNoAllocations(world);
}

/// A rope that lies across a pole: capsules against capsules.
TEST(Allocation, NoneByARopeThatLies) {
    World world;
    world.add(shapes::floor({-20, 0}, {20, 0}));
    world.add(rope(20, Real(0.02)), {.position = {0, 0.3}});
    expectNoAllocations(world);
}

TEST(Allocation, NoneByBallsThatComeAndGoInASensor) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    Blueprint zone = shapes::box({.size = {8, Real(0.1)}});
    zone.kind = BodyKind::fixed;
    zone.sensor = true;
    world.add(zone, {.position = {0, 0.2}});
    for (int i = 0; i < 6; ++i)
        world.add(shapes::ball({.radius = Real(0.02), .material = {.restitution = 1}}),
                  {.position = {i - 3.0, 0.33 + 0.01 * i}});
    std::size_t told = 0;
    for (int i = 0; i < 200; ++i) {
        world.step();
        told += world.events().sensorsEntered.size() + world.events().sensorsLeft.size();
    }
    EXPECT_GT(told, 6u);
    expectNoAllocations(world);
}

}  // namespace sulfur
