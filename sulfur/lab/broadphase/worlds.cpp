#include "broadphase/worlds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sulfur/shapes.hpp>
#include <sulfur/world.hpp>

namespace sulfur::lab {

namespace {

/// A block of balls, rows of 50, a little apart.
void addGrains(World& world, int count, double size, const Point& corner) {
    for (int i = 0; i < count; ++i) {
        const Point place(i % 50 + 0.1 * (i / 50 % 2), i / 50);
        world.add(shapes::ball({.radius = static_cast<Real>(size / 2), .mass = Real(0.01)}),
                  {.position = corner + 1.05 * size * place});
    }
}

void addCrates(World& world, int count, double size, const Point& first) {
    const auto side = static_cast<Real>(size);
    for (int i = 0; i < count; ++i)
        world.add(shapes::box({.size = {side, side}, .mass = 100}),
                  {.position = first + 1.05 * size * Point(i % 50, i / 50)});
}

/// Half of all grains and 20 crates, on a floor of their own.
void addHeap(World& world, int grains, const Point& at) {
    const auto x = at[0], y = at[1];
    world.add(shapes::floor({-50, 0}, {50, 0}), {.position = at});
    addGrains(world, grains / 2, 0.25, {x - 6, y + 0.2});
    addCrates(world, 20, 1, {x + 10, y + 0.6});
}

double median(std::vector<double>& times) {
    if (times.empty()) return 0;
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

}  // namespace

std::vector<WorldCase> broadPhaseWorlds(int grains) {
    std::vector<WorldCase> worlds;
    for (const double apart : {1e2, 1e4, 1e6, 8e8})
        worlds.push_back({fmt::format("apart-{:g}", apart),
                          fmt::format("heaps {:g} m apart", apart), [=](World& world) {
                              addHeap(world, grains, {-apart / 2, -apart / 2});
                              addHeap(world, grains, {apart / 2, apart / 2});
                          }});
    const auto mixed = [&](const char* key, const char* title, int crates, double size) {
        worlds.push_back({key, title, [=](World& world) {
                              world.add(shapes::floor({-500, 0}, {500, 0}));
                              addGrains(world, grains, 0.02, {-0.5, 0.06});
                              addCrates(world, crates, size, {-450, size / 2 + 3});
                          }});
    };
    mixed("grains", "grains of 2 cm, ground of 1 km", 0, 1);
    mixed("grains-crates", "  and 100 crates of 1 m", 100, 1);
    mixed("grains-halls", "  and 100 crates of 10 m", 100, 10);
    mixed("grains-huge", "  and a crate of 1 km", 1, 1000);
    return worlds;
}

WorldResult measureWorld(const WorldCase& kind, int ticks) {
    World world({.sleeping = false});
    kind.build(world);
    world.setProfiling(true);
    WorldResult result{.key = kind.key, .title = kind.title, .ticks = ticks};
    world.step();  // takes memory
    std::vector<double> rebuilds, others;
    double boxes = 0;
    for (int i = 0; i < ticks; ++i) {
        world.step();
        const Statistics& now = world.statistics();
        boxes += now.boxes;
        (now.boxes > 0 ? rebuilds : others)
            .push_back(now.seconds[static_cast<std::size_t>(Stage::broadPhase)]);
    }
    result.bodies = world.statistics().bodies;
    result.boxes = boxes / ticks;
    result.candidates = world.statistics().candidates;
    result.rebuilds = static_cast<int>(rebuilds.size());
    result.rebuild = median(rebuilds);
    result.kept = median(others);
    return result;
}

}  // namespace sulfur::lab
