// One tick, from top to bottom.
#include <chrono>

#include "solver/stages.hpp"
#include "solver/substeps.hpp"

namespace sulfur::detail {

namespace {

/// Runs a stage and, when asked to, measures it. The clock never influences the simulation.
template <class Function>
void timed(State& state, Stage stage, Function&& run) {
    if (!state.profiling) return run(state);
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    run(state);
    state.statistics.seconds[static_cast<std::size_t>(stage)] +=
        std::chrono::duration<double>(Clock::now() - start).count();
}

void runStages(State& state) {
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
}

template <class Event>
void append(std::vector<Event>& events, const std::vector<Event>& more) {
    events.insert(events.end(), more.begin(), more.end());
}

/// What was told in earlier steps of the tick comes first; who goes on touching is told once.
void append(Events& events, Events& more) {
    append(events.contactsBegun, more.contactsBegun);
    append(events.contactsEnded, more.contactsEnded);
    append(events.jointsBroken, more.jointsBroken);
    append(events.bodiesSplit, more.bodiesSplit);
    append(events.particlesLost, more.particlesLost);
    append(events.sensorsEntered, more.sensorsEntered);
    append(events.sensorsLeft, more.sensorsLeft);
    events.contactsPersisted = std::move(more.contactsPersisted);
}

}  // namespace

void step(State& state) {
    chooseSubsteps(state);
    state.statistics.seconds = {};
    state.statistics.substeps = state.substeps.count;
    Events told;
    state.substeps.done = 0;
    for (; state.substeps.done < state.substeps.count; ++state.substeps.done) {
        runStages(state);
        if (state.substeps.count > 1) append(told, state.events);
    }
    if (state.substeps.count > 1) state.events = std::move(told);
    ++state.tick;
}

}  // namespace sulfur::detail
