#include <atomic>
#include <sulfur/tbb_tasks.hpp>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

TEST(TbbTasks, CallEachPieceOnce) {
    TbbTasks tasks(3);
    EXPECT_EQ(tasks.threads(), 3u);
    std::vector<std::atomic<int>> calls(100);
    tasks.run(
        calls.size(),
        [](void* context, std::size_t i) {
            ++(*static_cast<std::vector<std::atomic<int>>*>(context))[i];
        },
        &calls);
    for (const auto& count : calls) EXPECT_EQ(count, 1);
}

TEST(TbbTasks, AreAsManyAsTheMachineHas) {
    EXPECT_GE(TbbTasks().threads(), 1u);
}

TEST(TbbTasks, RefuseNonsense) {
    EXPECT_THROW(TbbTasks(100000), Error);
}

TEST(TbbTasks, GiveTheSameHash) {
    const auto play = [](Tasks* tasks) {
        World world;
        world.setTasks(tasks);
        world.add(shapes::ground({.points = {{-40, 0}, {40, 0}}}));
        for (int i = 0; i < 600; ++i)
            world.add(shapes::box(), {.position = {-30 + 1.05 * (i % 60), 0.5 + i / 60}});
        for (int i = 0; i < 30; ++i) world.step();
        return world.hash();
    };
    TbbTasks tasks(4);
    EXPECT_EQ(play(&tasks), play(nullptr));
}

}  // namespace
}  // namespace sulfur
