#include "bench/clock.hpp"

#include <sched.h>

#include <algorithm>
#include <ctime>

namespace sulfur::lab::bench {

namespace {

double read(clockid_t clock) {
    std::timespec now{};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool allow(const std::vector<int>& cores) {
    cpu_set_t set;
    CPU_ZERO(&set);
    for (const int core : cores) CPU_SET(static_cast<unsigned>(core), &set);
    return ::sched_setaffinity(0, sizeof set, &set) == 0;
}

}  // namespace

double threadTime() {
    return read(CLOCK_THREAD_CPUTIME_ID);
}

double wallTime() {
    return read(CLOCK_MONOTONIC);
}

std::vector<int> allowedCores() {
    cpu_set_t set;
    CPU_ZERO(&set);
    std::vector<int> cores;
    if (::sched_getaffinity(0, sizeof set, &set) != 0) return cores;
    for (int core = 0; core < CPU_SETSIZE; ++core)
        if (CPU_ISSET(static_cast<unsigned>(core), &set)) cores.push_back(core);
    return cores;
}

Pinned::Pinned(int core) : before_(allowedCores()) {
    if (before_.empty()) return;
    const int wanted = core < 0 ? before_.back() : core;
    if (std::find(before_.begin(), before_.end(), wanted) == before_.end()) return;
    if (allow({wanted})) core_ = wanted;
}

Pinned::~Pinned() {
    if (core_ >= 0) allow(before_);
}

}  // namespace sulfur::lab::bench
