// A program that has threads of its own lends them to a world: it derives from sulfur::Tasks. (One
// that has none takes sulfur::ThreadPool, which is faster than this one.) Whoever does which piece
// of the work, the world comes out the same to the last bit.
#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <sulfur/sulfur.hpp>
#include <thread>
#include <vector>

#include "picture.hpp"

/// Two helpers that sleep until there is work.
class MyTasks final : public sulfur::Tasks {
public:
    std::size_t threads() const override { return 1 + helpers_.size(); }

    void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
        {
            const std::lock_guard lock(mutex_);
            count_ = count, task_ = task, context_ = context, next_ = 0;
            busy_ = helpers_.size();
            ++runs_;
        }
        wake_.notify_all();
        work();
        std::unique_lock lock(mutex_);
        done_.wait(lock, [&] { return busy_ == 0; });
    }

    /// How often a world has handed over work.
    unsigned runs() const { return runs_; }

private:
    void work() {
        for (std::size_t i = next_++; i < count_; i = next_++) task_(context_, i);
    }
    void help(const std::stop_token& stop) {
        for (unsigned seen = 0;;) {
            {
                std::unique_lock lock(mutex_);
                if (!wake_.wait(lock, stop, [&] { return runs_ != seen; })) return;
                seen = runs_;
            }
            work();
            const std::lock_guard lock(mutex_);
            if (--busy_ == 0) done_.notify_one();
        }
    }

    std::mutex mutex_;
    std::condition_variable_any wake_, done_;
    std::size_t count_ = 0, busy_ = 0;
    void (*task_)(void*, std::size_t) = nullptr;
    void* context_ = nullptr;
    std::atomic<std::size_t> next_ = 0;
    unsigned runs_ = 0;
    std::array<std::jthread, 2> helpers_{
        std::jthread([this](const std::stop_token& stop) { help(stop); }),
        std::jthread([this](const std::stop_token& stop) { help(stop); })};
};

void fill(sulfur::World& world) {
    using namespace sulfur;
    world.add(shapes::ground({.points = {{-4, 6}, {-4, 0}, {4, 0}, {4, 6}}}));
    const Blueprint jelly =
        shapes::jelly({.size = {0.8, 0.8}, .columns = 14, .rows = 14, .damping = 3});
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < 5; ++i)
            world.add(jelly,
                      {.position = {1.2 * i - 2.5, 0.9 * row + 0.8}, .angle = 0.1 * (5 * row + i)});
}

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-4.04, -0.2}, {4.04, 4.4});

    World alone, together;
    fill(alone);
    fill(together);
    MyTasks tasks;  // outlives its use
    together.setTasks(&tasks);
    while (alone.time() < 0.4) {
        alone.step();
        together.step();
    }
    together.setTasks(nullptr);
    picture.take(together);

    const bool same = alone.hash() == together.hash();
    std::printf("work was shared %u times; the worlds are %s\n", tasks.runs(),
                same ? "the same" : "different");
    return same && tasks.runs() > 0 ? 0 : 1;
}
