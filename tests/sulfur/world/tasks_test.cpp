// Threads that a host lends change nothing but the time that a tick takes.
#include <algorithm>
#include <sulfur/thread_pool.hpp>
#include <thread>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// Pieces in the wrong order, by the caller.
class Backwards final : public Tasks {
public:
    explicit Backwards(std::size_t threads) : threads_(threads) {}
    std::size_t threads() const override { return threads_; }
    double overhead() const override { return 0.01; }  // divide all that can be
    void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
        ++runs;
        for (std::size_t i = count; i-- > 0;) task(context, i);
    }
    int runs = 0;

private:
    std::size_t threads_;
};

/// A thread for each piece.
class Threads final : public Tasks {
public:
    std::size_t threads() const override { return 4; }
    double overhead() const override { return 0.01; }
    void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
        std::vector<std::thread> threads;
        for (std::size_t i = 0; i < count; ++i) threads.emplace_back(task, context, i);
        for (std::thread& thread : threads) thread.join();
    }
};

/// Enough of everything that all stages divide their work: two colours of contacts with 275 blocks
/// each, of which two are pieces enough; and a pile, jellies and a rope for what is not divided.
void buildMuch(World& world) {
    world.add(shapes::ground({.points = {{-2000, 0}, {2000, 0}}}));
    for (int i = 0; i < 2200; ++i) world.add(shapes::box(), {.position = {-1800 + 1.5 * i, 0.5}});
    constexpr int base = 12;
    for (int row = 0; row < base; ++row)
        for (int column = 0; column < base - row; ++column)
            world.add(shapes::box(),
                      {.position = {1600 + (column - (base - row) / 2.0) * 1.05, 0.5 + row}});
    for (int i = 0; i < 20; ++i)
        world.add(shapes::jelly({.size = {1, 1}, .columns = 3, .rows = 3}),
                  {.position = {1700 + 1.2 * (i % 5), 1 + 1.2 * (i / 5)}});
    world.add(shapes::rope({.from = {1800, 10}, .to = {1808, 10}, .pinFirst = true}));
}

std::uint64_t play(Tasks* tasks, int ticks) {
    World world;
    buildMuch(world);
    world.setTasks(tasks);
    for (int i = 0; i < ticks; ++i) world.step();
    return world.hash();
}

TEST(Tasks, ThreadsDoNotMatter) {
    constexpr int ticks = 12;
    const auto alone = play(nullptr, ticks);
    for (const std::size_t threads : {1u, 2u, 3u, 4u, 7u}) {
        Backwards tasks(threads);
        EXPECT_EQ(play(&tasks, ticks), alone) << threads;
        EXPECT_EQ(tasks.runs > 3 * ticks, threads > 1) << "the work is divided: " << threads;
    }
    Threads threads;
    EXPECT_EQ(play(&threads, ticks), alone);
}

/// What is very large stands in a grid of its own, and touches colliders of all pieces.
TEST(Tasks, StayLentWhenAWorldIsRestored) {
    World world;
    buildMuch(world);
    Backwards tasks(2);
    world.setTasks(&tasks);
    world.step();
    world.restore(world.snapshot());
    const int before = tasks.runs;
    world.step();
    EXPECT_GT(tasks.runs, before);
}

TEST(Tasks, DoNotMatterAmongThingsOfAllSizes) {
    const auto playRoof = [](Tasks* tasks) {
        World world;
        world.add(shapes::ground({.points = {{-40, 0}, {40, 0}}}));
        for (int i = 0; i < 40; ++i) world.add(shapes::box(), {.position = {-30 + 1.5 * i, 0.5}});
        Blueprint roof = shapes::box({.size = {20000, 1}});
        roof.kind = BodyKind::kinematic;
        const Body body = world.add(roof, {.position = {0, 1.53}});
        world.setVelocity(body, Vec2(1, Real(-0.5)));
        world.setTasks(tasks);
        for (int i = 0; i < 40; ++i) world.step();
        EXPECT_GT(world.statistics().contacts, 100u);
        return world.hash();
    };
    const auto alone = playRoof(nullptr);
    for (const std::size_t threads : {2u, 3u, 4u, 7u}) {
        Backwards tasks(threads);
        EXPECT_EQ(playRoof(&tasks), alone) << threads;
    }
}

/// Soft bodies in parts, which a stone presses flat, and crates in trees of contacts.
void buildHeap(World& world) {
    world.add(shapes::ground({.points = {{-40, 0}, {40, 0}}}));
    for (int i = 0; i < 60; ++i)
        world.add(shapes::jelly({.size = {1, 1}, .columns = 4, .rows = 4, .stiffness = 200}),
                  {.position = {-12 + 1.2 * (i % 20), 0.6 + 1.2 * (i / 20)}});
    for (int i = 0; i < 8; ++i) {
        const Body stone = world.add(shapes::ball({.radius = Real(0.5), .mass = 50}),
                                     {.position = {-11 + 3.0 * i, 5}});
        world.setVelocity(stone, Vec2(0, -10));
    }
    for (int i = 0; i < 100; ++i)
        world.add(shapes::box(), {.position = {16 + 1.02 * (i % 10), 0.5 + i / 10}});
}

TEST(Tasks, DoNotMatterForSoftBodiesAndStacks) {
    constexpr int ticks = 120;
    std::uint32_t pressed = 0, touching = 0;
    const auto playHeap = [&](Tasks* tasks) {
        World world;
        buildHeap(world);
        world.setTasks(tasks);
        for (int i = 0; i < ticks; ++i) {
            world.step();
            pressed = std::max(pressed, world.statistics().pressedTriangles);
            touching = std::max(touching, world.statistics().contacts);
        }
        return world.hash();
    };
    const auto alone = playHeap(nullptr);
    EXPECT_GT(pressed, 20u);
    EXPECT_GT(touching, 100u);
    for (const std::size_t threads : {2u, 3u, 4u, 7u}) {
        Backwards tasks(threads);
        EXPECT_EQ(playHeap(&tasks), alone) << threads;
    }
    ThreadPool pool(3);
    EXPECT_EQ(playHeap(&pool), alone);
}

/// Boxes, balls and jellies that fall among each other, turn, bounce and are struck by a rod:
/// looks, refreshes, sweeps and the search for what is fast are divided, in colours of all lengths.
TEST(Tasks, DoNotMatterWhereManyFallAndAreStruck) {
    std::uint32_t looks = 0, fast = 0;
    const auto playRain = [&](Tasks* tasks) {
        World world;
        world.add(shapes::ground({.points = {{-30, 12}, {-30, 0}, {30, 0}, {30, 12}}}));
        Blueprint box = shapes::box();
        box.material.restitution = Real(0.3);
        for (int i = 0; i < 500; ++i) {
            const Point at(-28 + 1.5 * (i % 38), 1 + 1.5 * (i / 38));
            const Body body = world.add(i % 9 == 0 ? shapes::ball({.radius = Real(0.4)}) : box,
                                        {.position = at, .angle = 0.37 * i});
            world.setVelocity(body, Vec2(Real(5 - i % 11), -10));
        }
        for (int i = 0; i < 10; ++i)
            world.add(shapes::jelly({.size = {1, 1}, .columns = 3, .rows = 3}),
                      {.position = {-20 + 4.0 * i, 23}});
        Blueprint rod = shapes::box({.size = {20, Real(0.3)}});
        rod.kind = BodyKind::kinematic;
        world.setVelocity(world.add(rod, {.position = {0, 30}}), Vec2(0, -40), 5);
        world.setTasks(tasks);
        for (int i = 0; i < 150; ++i) {
            world.step();
            looks = std::max(looks, world.statistics().looks);
            fast = std::max(fast, world.statistics().fastPairs);
        }
        return world.hash();
    };
    const auto alone = playRain(nullptr);
    EXPECT_GT(looks, 200u);
    EXPECT_GT(fast, 2u);
    for (const std::size_t threads : {2u, 3u, 7u}) {
        Backwards tasks(threads);
        EXPECT_EQ(playRain(&tasks), alone) << threads;
    }
    ThreadPool pool(3);
    EXPECT_EQ(playRain(&pool), alone);
}

TEST(Tasks, CanBeTakenAway) {
    World world;
    buildMuch(world);
    {
        Backwards tasks(2);
        world.setTasks(&tasks);
        world.step();
        world.setTasks(nullptr);
    }
    world.step();
    EXPECT_EQ(world.hash(), play(nullptr, 2));
}

}  // namespace
}  // namespace sulfur
