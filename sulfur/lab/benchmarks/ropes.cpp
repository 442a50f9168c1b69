// Many ropes of 40 rigid links with a load: what one link costs in a tick.
#include <cmath>

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

/// Chains of equal length go side by side in SIMD lanes, one alone does not. Arguments: chains;
/// links in each (one: a pendulum).
void chains(benchmark::State& state) {
    World world(still({}, standardGravity));
    const auto links = static_cast<int>(state.range(1));
    ChainOptions options{.places = {Vec(0, 0)}, .masses = {1}, .lengths = {}};
    for (int i = 1; i <= links; ++i) {
        options.places.emplace_back(static_cast<double>(i), 0);
        options.masses.push_back(1);
        options.lengths.push_back(1);
    }
    const Blueprint plan = chain(options);
    for (int i = 0; i < state.range(0); ++i)
        world.add(plan, {.position = Point(0, 2.0 * i * links)});
    stepAndCount(state, world,
                 {"link", static_cast<double>(links) * static_cast<double>(state.range(0))}, false,
                 {});
    state.counters["in_lanes"] = world.statistics().chainsInLanes;
}
BENCHMARK(chains)->ArgNames({"n", "links"})->ArgsProduct({{1, 8, 1000}, {1, 10, 40}});

/// Nets of rigid joints that hang by two corners, solved as a whole. Arguments: nodes a side; mass
/// of the one in the middle, in that of the others.
void nets(benchmark::State& state) {
    const NetOptions options{.side = static_cast<std::uint32_t>(state.range(0)),
                             .load = static_cast<double>(state.range(1))};
    World world(still({}, standardGravity));
    world.add(net(options));
    stepAndCount(state, world, {"node", static_cast<double>(options.side) * options.side}, false,
                 {});
    state.counters["factors"] = world.statistics().networkFactors;
}
BENCHMARK(nets)->ArgNames({"side", "load"})->ArgsProduct({{10, 40}, {1, 10000}});

/// A rope of 6 m that is straight between two pins. Argument: crates on it.
void tautRopes(benchmark::State& state) {
    World world(still({}, standardGravity));
    world.add(shapes::rope(
        {.from = {-3, 2}, .to = {3, 2}, .slack = Real(0), .pinFirst = true, .pinLast = true}));
    for (int i = 0; i < state.range(0); ++i)
        world.add(shapes::box({.size = {Real(0.5), Real(0.5)}}), {.position = {i - 1.0, 2.4}});
    for (int i = 0; i < 1000; ++i) world.step();
    stepAndCount(state, world, {"tick", 1}, false, {});
}
BENCHMARK(tautRopes)->ArgName("crates")->Arg(0)->Arg(1)->Arg(3);

/// Ropes of 8 m that hang over each other, held at both ends, and six crates that have come to lie
/// on them. Argument: ropes.
void ropesOverEachOther(benchmark::State& state) {
    World world(still({}, standardGravity));
    const auto ropes = static_cast<double>(state.range(0));
    for (int i = 0; i < state.range(0); ++i) {
        const Real y = Real(3 + 0.12 * i);
        world.add(shapes::rope({.from = {-4, y},
                                .to = {4, y},
                                .slack = Real(0.1),
                                .mass = 1,
                                .pinFirst = true,
                                .pinLast = true}));
    }
    for (int i = 0; i < 6; ++i)
        world.add(shapes::box({.size = {Real(0.5), Real(0.5)}, .mass = 5}),
                  {.position = {i - 2.5, 4 + 0.12 * ropes}});
    for (int i = 0; i < 1000; ++i) world.step();
    stepAndCount(state, world, {"rope", ropes}, false, {});
}
BENCHMARK(ropesOverEachOther)->ArgName("ropes")->Arg(4)->Arg(12);

/// A weight on a rope of springs that is reeled in and out by its last one, as a winch or a player
/// does, beside so many jellies that sleep. Timed are the calls and the tick. Argument: jellies.
void reeling(benchmark::State& state) {
    World world;
    const Body rope = world.add(shapes::rope(
        {.to = {0, -2}, .stiffness = 1e4, .damping = 10, .bending = 0, .pinFirst = true}));
    const Body load = world.add(shapes::ball({.radius = Real(0.2)}), {.position = {0, -3}});
    const JointId last = world.connect(rope.back(), load.front(), {.stiffness = 1e4});
    for (int i = 0; i < state.range(0); ++i) {
        const Body jelly = world.add(shapes::jelly(), {.position = {4 + 3.0 * i, 0}});
        world.putToSleep(jelly);
    }
    int tick = 0;
    for (auto _ : state) {
        const Real length = Real(0.75 + 0.25 * std::cos(0.01 * ++tick));
        world.setRestLength(last, length);
        world.setStiffness(last, Real(1e4) / length);
        world.step();
    }
}
BENCHMARK(reeling)->ArgName("jellies")->Arg(0)->Arg(10)->Arg(100);

}  // namespace

}  // namespace sulfur::lab
