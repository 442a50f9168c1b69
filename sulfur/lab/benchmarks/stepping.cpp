#include "stepping.hpp"

namespace sulfur::lab {

void stepAndCount(benchmark::State& state, World& world, const Items& items, bool profiling,
                  std::initializer_list<Stage> stages) {
    using benchmark::Counter;
    world.setProfiling(profiling);
    for (int i = 0; i < 100; ++i) world.step();
    double seconds = 0;
    for (auto _ : state) {
        world.step();
        if (!profiling) continue;
        for (const Stage stage : stages)
            seconds += world.statistics().seconds[static_cast<std::size_t>(stage)];
    }
    // A rate of items, inverted: seconds an item.
    state.counters["per_" + items.name] =
        Counter(items.each, Counter::kIsIterationInvariantRate | Counter::kInvert);
    if (profiling)
        state.counters["stages_per_" + items.name] =
            seconds / items.each / static_cast<double>(state.iterations());
    state.counters["explicit"] = world.statistics().explicitJoints;
    state.counters["implicit"] = world.statistics().implicitJoints;
    state.counters["rigid"] = world.statistics().rigidJoints;
}

}  // namespace sulfur::lab
