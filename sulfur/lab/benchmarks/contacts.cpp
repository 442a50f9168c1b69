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

/// What one body costs a world of crates whose constraints are others. Argument: 0: nothing beside
/// the crates, 1: a jelly, 2: one that is pressed flat, 3: a rope, on the floor.
void beside(benchmark::State& state) {
    World world(still({}, standardGravity));
    raiseTowers(world, 200, 5);
    const Point place(-210, 0.5);
    if (state.range(0) == 1 || state.range(0) == 2) world.add(shapes::jelly(), {place});
    if (state.range(0) == 2)
        world.add(shapes::box({.size = {2, 1}, .mass = 50}), {place + Point(0, 1.1)});
    if (state.range(0) == 3)
        world.add(shapes::rope({.from = {-1, 0}, .to = {1, 0}}), {place - Point(0, 0.4)});
    for (int i = 0; i < 1000; ++i) world.step();
    stepAndCount(state, world, {"crate", 1000}, false, {});
}
BENCHMARK(beside)->ArgName("what")->DenseRange(0, 3);

}  // namespace

}  // namespace sulfur::lab
