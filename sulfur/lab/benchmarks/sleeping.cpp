// Worlds that sleep: what a tick costs in all, and with one body awake; what coming and going
// costs.
#include <chrono>
#include <vector>

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

enum class Part { remove, tickAfter, add };

/// Of removing one of so many crates that sleep, or else lie awake, and putting it back: the call,
/// or the next tick. Arguments: crates; whether they sleep.
void coming(benchmark::State& state, Part part) {
    WorldSettings settings = still({}, standardGravity);
    settings.sleeping = state.range(1) != 0;
    World world(settings);
    const auto count = static_cast<std::size_t>(state.range(0));
    addFloor(world, 1.5 * static_cast<double>(count), {});
    const Blueprint plan = crate();
    const auto place = [&](std::size_t i) {
        return Point(1.5 * (static_cast<double>(i) - static_cast<double>(count) / 2), 0.5);
    };
    std::vector<Body> crates;
    for (std::size_t i = 0; i < count; ++i) crates.push_back(world.add(plan, {place(i)}));
    run(world, 1.2);
    const auto timed = [&](Part which, auto&& act) {
        const auto start = std::chrono::steady_clock::now();
        act();
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        if (which == part) state.SetIterationTime(took.count());
    };
    std::size_t k = 0;
    for (auto _ : state) {
        k = (k + 37) % count;
        timed(Part::remove, [&] { world.remove(crates[k]); });
        timed(Part::tickAfter, [&] { world.step(); });
        timed(Part::add, [&] { crates[k] = world.add(plan, {place(k)}); });
        run(world, settings.sleeping ? 0.7 : 0.01);
    }
}
BENCHMARK_CAPTURE(coming, remove, Part::remove)
    ->ArgNames({"n", "asleep"})
    ->ArgsProduct({{1000, 10000}, {0, 1}})
    ->Iterations(40)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(coming, tickAfter, Part::tickAfter)
    ->ArgNames({"n", "asleep"})
    ->ArgsProduct({{1000, 10000}, {0, 1}})
    ->Iterations(40)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(coming, add, Part::add)
    ->ArgNames({"n", "asleep"})
    ->ArgsProduct({{1000, 10000}, {0, 1}})
    ->Iterations(40)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

/// Of removing every tenth of so many crates in one tick, one by one; each of them.
void leaving(benchmark::State& state) {
    WorldSettings settings = still({}, standardGravity);
    settings.sleeping = state.range(1) != 0;
    const auto count = static_cast<std::size_t>(state.range(0));
    for (auto _ : state) {
        World world(settings);
        addFloor(world, 1.5 * static_cast<double>(count), {});
        std::vector<Body> crates;
        for (std::size_t i = 0; i < count; ++i)
            crates.push_back(world.add(
                crate(),
                {Point(1.5 * (static_cast<double>(i) - static_cast<double>(count) / 2), 0.5)}));
        run(world, 1.2);
        const auto start = std::chrono::steady_clock::now();
        for (std::size_t i = 0; i < count; i += 10) world.remove(crates[i]);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        state.SetIterationTime(took.count() * 10 / static_cast<double>(count));
    }
}
BENCHMARK(leaving)
    ->ArgNames({"n", "asleep"})
    ->ArgsProduct({{1000, 10000}, {0, 1}})
    ->Iterations(3)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

/// What comes and goes in a world where so many ropes and jellies sleep: a ball, and the tick after
/// it; or a spring between two crates that fly, and that tick. Arguments: ropes, and as many
/// jellies; whether it is the spring.
void among(benchmark::State& state) {
    World world({.gravity = {0, 0}});
    for (int i = 0; i < state.range(0); ++i) {
        const Real x = static_cast<Real>(3 * i);
        world.add(shapes::rope({.from = {x, 10}, .to = {x, 8}, .pinFirst = true}));
        world.add(shapes::jelly(), {.position = {static_cast<double>(x), 5}});
    }
    for (const BodyId body : world.bodies()) world.putToSleep(body);
    const Body one = world.add(crate(), {.position = {0, 0}});
    const Body other = world.add(crate(), {.position = {3, 0}});
    world.setSleepingAllowed(one, false);
    run(world, 0.1);
    for (auto _ : state) {
        if (state.range(1) != 0) {
            const JointId spring = world.connect(one.front(), other.front(), {.stiffness = 100});
            world.step();
            world.remove(spring);
        } else {
            const Body ball = world.add(shapes::ball(), {.position = {-3, 0}});
            world.step();
            world.remove(ball);
        }
        world.step();
    }
    state.counters["asleep"] = world.statistics().particles - world.statistics().awakeParticles;
}
BENCHMARK(among)
    ->ArgNames({"n", "spring"})
    ->ArgsProduct({{0, 10, 100}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace sulfur::lab
