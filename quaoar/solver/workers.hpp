// The same work on several cores, with results that do not depend on how many.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <quaoar/session.hpp>
#include <thread>
#include <vector>

namespace quaoar {

/// Starts `jobs` threads, at most `count`, each of which calls `prepare()` once, and what that
/// returned with 0 to count - 1, in no order. Throws what a call throws.
template <class Prepare>
void share(int jobs, int count, const Prepare& prepare) {
    std::atomic<int> next{0};
    std::exception_ptr problem;
    std::mutex guard;
    const auto worker = [&] {
        try {
            const auto work = prepare();
            for (int i = next++; i < count; i = next++) work(i);
        } catch (...) {
            const std::lock_guard<std::mutex> lock(guard);
            problem = std::current_exception();
            next = count;
        }
    };
    {
        // Joins those that run, also where the system gives no more threads.
        std::vector<std::jthread> threads;
        for (int n = 1; n < std::min(jobs, count); ++n) threads.emplace_back(worker);
        worker();
    }
    if (problem) std::rethrow_exception(problem);
}

/// Calls `work(index, session)`, each thread with a session of its own. What an index does must
/// depend on nothing but the index.
template <class Work>
void forAll(const std::shared_ptr<const Level>& level, int jobs, int count, const Work& work) {
    share(jobs, count, [&] {
        return [&work, session = std::make_shared<Session>(level)](int i) { work(i, *session); };
    });
}

}  // namespace quaoar
