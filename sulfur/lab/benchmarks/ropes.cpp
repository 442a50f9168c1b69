// Many ropes of 40 rigid links with a load: what one link costs in a tick.
#include "battery/scenes.hpp"
#include "stepping.hpp"

namespace sulfur::lab {

namespace {

/// They hang a little aside and swing. Arguments: ropes; load in masses of a link; sweeps (which a
/// chain that is solved directly does not need); whether profiling is on.
void ropes(benchmark::State& state) {
    constexpr int links = 40;
    constexpr double length = 0.05, mass = 0.05;
    World world(still({.sweeps = static_cast<int>(state.range(2))}, standardGravity));
    ChainOptions options{.places = {Vec(0, 0)}, .masses = {mass}, .lengths = {}};
    for (int i = 1; i <= links; ++i) {
        // 30 degrees aside.
        options.places.emplace_back(options.places.back() + length * Vec(0.5, -0.8660254037844386));
        options.masses.push_back(i == links ? mass * static_cast<double>(state.range(1)) : mass);
        options.lengths.push_back(length);
    }
    const Blueprint plan = chain(options);
    for (int i = 0; i < state.range(0); ++i) world.add(plan, {.position = Point(3.0 * i, 0)});
    stepAndCount(state, world, {"link", links * static_cast<double>(state.range(0))},
                 state.range(3) != 0, {Stage::constraints});
}
BENCHMARK(ropes)
    ->ArgNames({"n", "load", "sweeps", "profiling"})
    ->ArgsProduct({{200}, {1, 100, 10000}, {1, 4}, {0, 1}});

}  // namespace

}  // namespace sulfur::lab
