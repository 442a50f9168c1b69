// Free particles: what predicting and moving them costs.
#include "battery/scenes.hpp"
#include "stepping.hpp"

namespace sulfur::lab {

namespace {

/// Arguments: particles; whether profiling is on.
void freeParticles(benchmark::State& state) {
    World world(still({}, 0));
    Blueprint dust = ghost("dust");
    for (int i = 0; i < state.range(0); ++i)
        dust.particles.push_back({.position = vec2(i % 100, i / 100)});
    const Body body = world.add(dust);
    world.setVelocity(body, vec2(0.1, 0.2));
    stepAndCount(state, world, {"particle", static_cast<double>(state.range(0))},
                 state.range(1) != 0, {Stage::predict, Stage::velocities});
}
BENCHMARK(freeParticles)
    ->ArgNames({"n", "profiling"})
    ->ArgsProduct({{1000, 10000, 100000}, {0, 1}});

/// Rigid crates in free flight: a closed form where the library has one, sweeps otherwise.
/// Arguments: crates; whether profiling is on.
void freeCrates(benchmark::State& state) {
    World world(still({}, 0));
    Blueprint crate = shapes::box();
    crate.filter.mask = 0;
    double particles = 0;
    for (int i = 0; i < state.range(0); ++i) {
        const Body body = world.add(crate, {.position = Point(2 * (i % 30), 2 * (i / 30))});
        for (const ParticleId id : body.particles()) {
            const Vec r = world.position(id) - world.centreOfMass(body);
            world.setVelocity(id, vec2(-r.y(), r.x()));
        }
        particles += static_cast<double>(body.size());
    }
    stepAndCount(state, world, {"particle", particles}, state.range(1) != 0,
                 {Stage::predict, Stage::constraints, Stage::velocities});
}
BENCHMARK(freeCrates)->ArgNames({"n", "profiling"})->ArgsProduct({{1000}, {0, 1}});

}  // namespace

}  // namespace sulfur::lab
