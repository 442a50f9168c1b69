// The worst tick of scenes that are legal and meant to be expensive: a tick has a bounded price.
#include <algorithm>
#include <array>
#include <ctime>
#include <functional>
#include <vector>

#include "stepping.hpp"

namespace sulfur::lab {

namespace {

/// What the caller does before each tick.
using Caller = std::function<void(World&, int)>;
struct HardScene {
    const char* name;
    double gravity;  // m/s^2, downwards
    std::function<Caller(World&)> make;
};

void addPit(World& world) {
    world.add(shapes::ground({.points = {{-9, 40}, {-9, 0}, {9, 0}, {9, 40}}}));
}
void addAtOnePoint(World& world, const Blueprint& plan, int count) {
    addPit(world);
    for (int i = 0; i < count; ++i) world.add(plan, {.position = {0, 2}});
}
void addInRows(World& world, const Blueprint& plan, int count) {
    addPit(world);
    for (int i = 0; i < count; ++i)
        world.add(plan, {.position = {i % 12 * 1.2 - 7, 1 + 1.2 * (i / 12)}});
}

/// A rod of 20 m that is elsewhere in every tick.
Caller addTeleportingRod(World& world) {
    Blueprint rod = shapes::box({.size = {20, Real(0.4)}});
    rod.kind = BodyKind::kinematic;
    const BodyId id = world.add(rod, {.position = {0, 50}});
    return [id](World& w, int tick) {
        w.moveTo(id,
                 {.position = {tick % 3 - 1.0, tick % 2 != 0 ? 1.0 : 8.0}, .angle = 0.7 * tick});
    };
}
Caller among(World& world, const Blueprint& plan, int count) {
    addInRows(world, plan, count);
    return addTeleportingRod(world);
}

Caller addLoadedRope(World& world) {
    const Body rope =
        world.add(shapes::rope({.from = {0, 0}, .to = {40, 0}, .links = 400, .pinFirst = true}));
    const Body crate = world.add(shapes::box({.mass = 10000}), {.position = {40.5, 0}});
    world.attach(rope.back(), crate, {Real(-0.5), 0});
    return {};
}
Caller addLoadedBridge(World& world) {
    world.add(shapes::bridge({.from = {-40, 0}, .to = {40, 0}, .planks = 400}));
    for (int i = 0; i < 20; ++i)
        world.add(shapes::box({.mass = 10000}), {.position = {2.0 * i - 20, 1.5}});
    return {};
}
Caller addTornRope(World& world) {
    const Body rope = world.add(shapes::rope(
        {.from = {0, 0}, .to = {4, 0}, .links = 100, .pinFirst = true, .pinLast = true}));
    world.setPosition(rope.back(), {12, 0});
    return {};
}
Caller addTangle(World& world) {
    world.add(shapes::floor({-3, 0}, {3, 0}));
    for (int i = 0; i < 10; ++i)
        world.add(shapes::rope({.from = {-1.5, 0}, .to = {1.5, 0}, .links = 40}),
                  {.position = {0, 0.3 + 0.2 * i}});
    return {};
}

const std::array<HardScene, 11> scenes{{
    {"balls at one point", 9.81,
     [](World& w) { return addAtOnePoint(w, shapes::ball(), 480), Caller{}; }},
    {"balls and a teleporting rod", 9.81, [](World& w) { return among(w, shapes::ball(), 480); }},
    {"cloths and a teleporting rod", 9.81, [](World& w) { return among(w, shapes::cloth(), 4); }},
    {"soft wheels and a teleporting rod", 9.81,
     [](World& w) { return among(w, shapes::wheel({.spokeStiffness = 30000}), 28); }},
    {"boxes under 1e6 m/s^2", 1e6,
     [](World& w) { return addInRows(w, shapes::box(), 120), Caller{}; }},
    {"balls under 1e6 m/s^2", 1e6,
     [](World& w) { return addInRows(w, shapes::ball(), 480), Caller{}; }},
    {"cloths under 1e6 m/s^2", 1e6,
     [](World& w) { return addInRows(w, shapes::cloth(), 4), Caller{}; }},
    {"ropes under 1e6 m/s^2", 1e6, addTangle},
    {"bridge of 400 planks under 20 boxes of 10 t", 9.81, addLoadedBridge},
    {"10 t on a rope of 400 links", 9.81, addLoadedRope},
    {"rope between pins at three times its length", 9.81, addTornRope},
}};

double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Arguments: the scene, Hz. Of a sixth of a second the worst tick, as the least of three runs.
void hardScenes(benchmark::State& state) {
    const HardScene& scene = scenes.at(static_cast<std::size_t>(state.range(0)));
    const int rate = static_cast<int>(state.range(1)), ticks = std::max(20, rate / 6);
    std::vector<double> least(static_cast<std::size_t>(ticks), 1e9);
    double particles = 0;
    for (auto _ : state) {
        World world({.gravity = {0, static_cast<Real>(-scene.gravity)}, .tickRate = rate});
        const Caller call = scene.make(world);
        for (int tick = 0; tick < ticks; ++tick) {
            if (call) call(world, tick);
            const double start = processorTime();
            world.step();
            double& best = least[static_cast<std::size_t>(tick)];
            best = std::min(best, processorTime() - start);
            particles = std::max<double>(particles, world.statistics().particles);
        }
        state.SetIterationTime(*std::max_element(least.begin(), least.end()));
    }
    state.SetLabel(scene.name);
    state.counters["per_particle"] = *std::max_element(least.begin(), least.end()) / particles;
}
BENCHMARK(hardScenes)
    ->ArgNames({"scene", "hz"})
    ->ArgsProduct({benchmark::CreateDenseRange(0, scenes.size() - 1, 1), {500, 60}})
    ->Iterations(3)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace sulfur::lab
