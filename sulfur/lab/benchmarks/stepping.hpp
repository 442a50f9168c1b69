// What all benchmarks do: step a world, and say what an item costs.
#pragma once

#include <benchmark/benchmark.h>

#include <initializer_list>
#include <string>
#include <sulfur/sulfur.hpp>

namespace sulfur::lab {

/// What a benchmark counts as one item.
struct Items {
    std::string name;  ///< "particle", "joint"
    double each = 0;   ///< items that a tick works on
};

/// Times World::step after a warm-up of 100 ticks, and reports the time of an item as "per_NAME"
/// (Google Benchmark writes 3.1e-9 as 3.1n). With `profiling`, which costs a little itself, it
/// reports that of the named stages alone as "stages_per_NAME" too. What the statistics call this
/// world's joints goes into the counters, so that a change of the rule shows.
void stepAndCount(benchmark::State& state, World& world, const Items& items, bool profiling,
                  std::initializer_list<Stage> stages);

}  // namespace sulfur::lab
