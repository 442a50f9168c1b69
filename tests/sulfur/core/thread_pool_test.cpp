#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <sulfur/error.hpp>
#include <sulfur/thread_pool.hpp>
#include <thread>
#include <vector>

namespace sulfur {
namespace {

void expectEachOnce(Tasks& tasks, std::size_t count) {
    std::vector<std::atomic<int>> calls(count);
    tasks.run(
        count,
        [](void* context, std::size_t i) {
            ++(*static_cast<std::vector<std::atomic<int>>*>(context))[i];
        },
        &calls);
    for (const auto& times : calls) EXPECT_EQ(times, 1);
}

TEST(ThreadPool, CallsEachPieceOnce) {
    for (const std::size_t threads : {1u, 2u, 3u, 32u}) {
        ThreadPool pool(threads);
        EXPECT_EQ(pool.threads(), threads);
        for (const std::size_t count : {0u, 1u, 2u, 3u, 31u, 32u, 100u})
            expectEachOnce(pool, count);
    }
}

TEST(ThreadPool, IsAsLargeAsTheMachine) {
    EXPECT_GE(ThreadPool().threads(), 1u);
    EXPECT_THROW(ThreadPool(33), Error);
}

/// One job follows the other, so that a thread that is late for one finds the next.
TEST(ThreadPool, KeepsJobsApart) {
    ThreadPool pool(3);
    struct Job {
        std::size_t number;
        std::atomic<std::size_t> sum{0};
    };
    for (std::size_t number = 1; number <= 20000; ++number) {
        Job job{.number = number};
        pool.run(
            4,
            [](void* context, std::size_t i) {
                Job& its = *static_cast<Job*>(context);
                its.sum += its.number * (i + 1);
            },
            &job);
        ASSERT_EQ(job.sum, 10 * number);
        if (number % 100 == 0) pool.rest();
    }
}

TEST(ThreadPool, WakesWhoSleeps) {
    ThreadPool pool(2);
    for (int i = 0; i < 5; ++i) {
        expectEachOnce(pool, 2);
        pool.rest();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

/// Who calls it while it works for another does its work alone.
TEST(ThreadPool, ServesOneAtATime) {
    ThreadPool pool(2);
    std::vector<std::thread> callers;
    for (int k = 0; k < 3; ++k)
        callers.emplace_back([&] {
            for (int i = 0; i < 1000; ++i) expectEachOnce(pool, 5);
        });
    for (std::thread& caller : callers) caller.join();
}

}  // namespace
}  // namespace sulfur
