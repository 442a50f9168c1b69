// One tick, from top to bottom.
#include <chrono>

#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

/// Runs a stage and, when asked to, measures it. The clock never influences the simulation.
template <class Function>
void timed(State& state, Stage stage, Function&& run) {
    if (!state.profiling) return run(state);
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    run(state);
    state.statistics.seconds[static_cast<std::size_t>(stage)] =
        std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

void step(State& state) {
    timed(state, Stage::changes, applyChanges);
    timed(state, Stage::forces, gatherForces);
    timed(state, Stage::fields, applyFields);
    timed(state, Stage::predict, predict);
    timed(state, Stage::broadPhase, updateBroadPhase);
    timed(state, Stage::narrowPhase, findContacts);
    timed(state, Stage::constraints, solveConstraints);
    timed(state, Stage::velocities, updateVelocities);
    timed(state, Stage::breakage, breakJoints);
    // Before anybody falls asleep or wakes: who slept through the tick still touches what it did.
    collectEvents(state);
    timed(state, Stage::sleep, updateSleep);
    timed(state, Stage::sensors, updateSensors);
    state.lastTick = static_cast<double>(state.h);
    ++state.tick;
}

}  // namespace sulfur::detail
