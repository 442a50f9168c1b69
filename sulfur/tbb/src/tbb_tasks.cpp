#include "sulfur/tbb_tasks.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <string>
#include <sulfur/error.hpp>

namespace sulfur {

namespace {

constexpr std::size_t mostThreads = 1024;

int checked(std::size_t threads) {
    if (threads > mostThreads)
        throw Error(ErrorCode::outOfRange, "the number of threads is " + std::to_string(threads) +
                                               "; allowed are 0 to " + std::to_string(mostThreads));
    return threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads);
}

}  // namespace

struct TbbTasks::Arena {
    explicit Arena(int threads) : arena(threads) {}
    tbb::task_arena arena;
};

TbbTasks::TbbTasks(std::size_t threads) : arena_(std::make_unique<Arena>(checked(threads))) {}
TbbTasks::~TbbTasks() = default;

std::size_t TbbTasks::threads() const {
    return static_cast<std::size_t>(arena_->arena.max_concurrency());
}

void TbbTasks::run(std::size_t count, void (*task)(void* context, std::size_t i), void* context) {
    // One piece a task, each to the thread that had its neighbours before if it can be.
    arena_->arena.execute([&] {
        tbb::parallel_for(
            std::size_t{0}, count, [&](std::size_t i) { task(context, i); },
            tbb::static_partitioner());
    });
}

}  // namespace sulfur
