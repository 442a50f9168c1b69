#include "bench/threads.hpp"

#ifdef SULFUR_LAB_TBB
#include <map>
#include <sulfur/tbb_tasks.hpp>
#endif

namespace sulfur::lab::bench {

#ifdef SULFUR_LAB_TBB

bool hasThreads() {
    return true;
}

Tasks* tasksFor(std::size_t threads) {
    static std::map<std::size_t, TbbTasks> all;
    return threads < 2 ? nullptr : &all.try_emplace(threads, threads).first->second;
}

#else

bool hasThreads() {
    return false;
}

Tasks* tasksFor(std::size_t) {
    return nullptr;
}

#endif

}  // namespace sulfur::lab::bench
