// Crates on each other: what a candidate costs the narrow phase, and a contact the solver.
#include "battery/contacts/stage.hpp"
#include "battery/scenes.hpp"
#include "stepping.hpp"

namespace sulfur::lab {

namespace {

/// A floor with towers of crates apart, at rest, none asleep.
void raiseTowers(World& world, int towers, int height) {
    const double pitch = 2;
    addFloor(world, pitch * towers, {});
    const Blueprint plan = crate();
    for (int i = 0; i < towers; ++i)
        for (int k = 0; k < height; ++k)
            world.add(plan, {.position = Point(pitch * (i - towers / 2), 0.5 + k)});
    for (int i = 0; i < 100; ++i) world.step();
}

/// Arguments: towers; crates in each; whether profiling is on.
void candidates(benchmark::State& state) {
    World world(still({}, standardGravity));
    raiseTowers(world, static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    stepAndCount(state, world, {"candidate", static_cast<double>(world.statistics().candidates)},
                 state.range(2) != 0, {Stage::broadPhase, Stage::narrowPhase});
}
BENCHMARK(candidates)->ArgNames({"towers", "height", "profiling"})->ArgsProduct({{200}, {5}, {1}});

/// The time of a contact in a tick: all its sweeps, and what comes before and after them.
/// Arguments: towers; crates in each; sweeps; whether profiling is on.
void contacts(benchmark::State& state) {
    World world(still({.sweeps = static_cast<int>(state.range(2))}, standardGravity));
    raiseTowers(world, static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    stepAndCount(state, world, {"contact", static_cast<double>(world.statistics().contacts)},
                 state.range(3) != 0, {Stage::constraints});
}
BENCHMARK(contacts)
    ->ArgNames({"towers", "height", "sweeps", "profiling"})
    ->ArgsProduct({{200}, {1, 5}, {1, 4}, {1}});

}  // namespace

}  // namespace sulfur::lab
