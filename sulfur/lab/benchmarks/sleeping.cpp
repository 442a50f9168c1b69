// Worlds that sleep: what a tick costs in all, and with one body awake.
#include "battery/contacts/stage.hpp"
#include "battery/scenes.hpp"
#include "stepping.hpp"

namespace sulfur::lab {

namespace {

/// Crates that lie on a floor and sleep. Arguments: crates of four particles; whether a
/// pendulum swings above them.
void sleepers(benchmark::State& state) {
    WorldSettings settings = still({}, standardGravity);
    settings.sleeping = true;
    World world(settings);
    const auto count = static_cast<int>(state.range(0));
    addFloor(world, 1.5 * count, {});
    const Blueprint plan = crate();
    for (int i = 0; i < count; ++i)
        world.add(plan, {.position = Point(1.5 * (i - count / 2), 0.5)});
    run(world, 0.7);
    const Blueprint pendulum =
        shapes::rope({.from = {0, 10}, .to = {1, 10}, .links = 1, .pinFirst = true});
    if (state.range(1) != 0) world.add(pendulum);
    run(world, 1.2);
    stepAndCount(state, world, {"sleeper", static_cast<double>(count)}, false, {});
    state.counters["awake"] = world.statistics().awakeParticles;
}
BENCHMARK(sleepers)
    ->ArgNames({"n", "awake"})
    ->ArgsProduct({{1000, 25000}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace sulfur::lab
