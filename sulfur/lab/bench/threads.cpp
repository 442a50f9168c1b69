#include "bench/threads.hpp"

#include <map>
#include <sulfur/thread_pool.hpp>

namespace sulfur::lab::bench {

Tasks* tasksFor(std::size_t threads) {
    static std::map<std::size_t, ThreadPool> all;
    return threads < 2 ? nullptr : &all.try_emplace(threads, threads).first->second;
}

}  // namespace sulfur::lab::bench
