// One tick, from top to bottom.
#include <algorithm>
#include <chrono>
#include <utility>

#include "contacts/stages.hpp"
#include "solver/driven.hpp"
#include "solver/paces.hpp"
#include "solver/stages.hpp"
#include "solver/substeps.hpp"
#include "solver/tell.hpp"

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

/// What a tick adds to begins at zero.
void clearStatistics(Statistics& statistics) {
    statistics.items.fill(0);
    statistics.seconds.fill(0);
    statistics.rubbingContacts = statistics.fastBodies = statistics.heldBack = 0;
    statistics.pressedTriangles = statistics.plannedContacts = 0;
    statistics.chainSteps = statistics.chainFallbacks = statistics.chainsInLanes = 0;
    statistics.substeps = 1;
    statistics.dividedBodies = 0;
}

/// What the stages of collision and constraints loop over.
void noteItems(State& state) {
    const WorkLists& work = state.work;
    std::uint32_t& pressed = state.statistics.pressedTriangles;  // the most in any step of the tick
    pressed = std::max(pressed, static_cast<std::uint32_t>(state.triangles.pressed.size()));
    state.looked(Stage::broadPhase, work.awakeSurfaces);
    state.looked(Stage::narrowPhase, state.broad.watches.size());
    state.looked(Stage::constraints,
                 state.contacts.size() + work.implicitJoints.size() + work.rigidJoints.size() +
                     work.attachments.size() + work.hinges.size() + work.lines.size() +
                     state.triangles.pressed.size() + state.trees.touchedAlone.size() +
                     state.influences.grabs.size());
}

/// Whether something has been changed by hand since the lists were made.
bool isChanged(const State& state) {
    const BroadPhase& broad = state.broad;
    return state.structure.stale || state.work.stale || broad.collidersStale ||
           broad.cellSizeStale || broad.fixedStale || broad.pairsStale || state.anyPlaced ||
           !state.fresh.empty() || !state.influences.grabs.empty();
}

/// Whether a tick would change nothing but the clock: all that could move sleeps.
bool allRest(const State& state) {
    const auto& movers = state.work.bodies;
    const auto moves = [&](std::uint32_t body) {
        return state.bodies[body].kind == BodyKind::dynamic || isDriven(state, body);
    };
    return !isChanged(state) && std::none_of(movers.begin(), movers.end(), moves);
}

/// A tick of a world at rest.
void idle(State& state) {
    clear(state.events);
    ++state.statistics.idleTicks;
}

void runStages(State& state) {
    timed(state, Stage::changes, applyChanges);
    timed(state, Stage::forces, gatherForces);
    timed(state, Stage::fields, applyFields);
    timed(state, Stage::predict, predict);
    if (state.core.on) {
        timed(state, Stage::broadPhase, [](State& s) {
            s.contacts.clear();
            updateShapes(s);
            takeMotion(s);
            updateBoxes(s);
        });
        timed(state, Stage::narrowPhase, [](State& s) {
            lookAtPairs(s);
            refreshRows(s);
        });
        timed(state, Stage::constraints, solveWithRows);
    } else {
    timed(state, Stage::broadPhase, updateBroadPhase);
    timed(state, Stage::narrowPhase, findContacts);
    timed(state, Stage::constraints, solveConstraints);
    }
    timed(state, Stage::velocities, updateVelocities);
    noteItems(state);
    timed(state, Stage::breakage, breakJoints);
    // Before anybody falls asleep or wakes: who slept through the tick still touches what it did.
    collectEvents(state);
    timed(state, Stage::sleep, state.core.on ? updateSleepByRows : updateSleep);
    state.idle = (state.core.on || (state.contacts.empty() && state.entwined.empty())) &&
                 state.core.staleShapes.empty() && !state.core.listsStale && allRest(state);
}

void runStep(State& state) {
    state.idle = state.idle && allRest(state);
    if (state.idle)
        idle(state);
    else
        runStages(state);
    timed(state, Stage::sensors, updateSensors);
    state.lastSteps[static_cast<std::size_t>(state.steps.pace)] = static_cast<double>(state.h);
    ++state.steps.done;
}

/// The whole tick of bodies whose ticks are not divided, while the others stand by.
void runWhole(State& state) {
    enterPace(state, Pace::whole);
    runStep(state);
    tellStep(state);
}

/// The steps of bodies whose ticks are divided.
void runDivided(State& state) {
    enterPace(state, Pace::divided);
    while (state.steps.done < state.steps.count) {
        if (state.steps.done > 0) applyForcesAgain(state);
        runStep(state);
        tellStep(state);
    }
}

/// A tick in which the ticks of some bodies, or of all, are divided.
void runPaces(State& state) {
    startTelling(state);
    keepAppliedForces(state);
    std::uint32_t contactsOfWhole = 0;
    if (state.steps.mixed) {
        runWhole(state);
        contactsOfWhole = state.statistics.contacts;
    }
    runDivided(state);
    state.statistics.contacts += contactsOfWhole;
    leavePaces(state);
    tellTick(state);
}

/// Lists that name all that moves, of both paces, and the structure that they follow.
void updateLists(State& state) {
    const bool parkedBehind =
        state.work.movers != ListedMovers::all && state.steps.parkedWork.madeAfter != state.listChanges;
    state.work.stale = state.work.stale || parkedBehind;
    if (state.work.stale) timed(state, Stage::changes, applyChanges);
}

}  // namespace

void step(State& state) {
    clearStatistics(state.statistics);
    if (mayDivideTicks(state) || state.anyDivided) {
        const bool changed = state.structure.stale;
        timed(state, Stage::changes, updateStructure);
        updateLists(state);
        timed(state, Stage::changes, [&](State& s) { choosePaces(s, changed); });
        // While nobody stands by: what does has no velocity that could follow.
        timed(state, Stage::changes, updateStructure);
    }
    state.steps.done = 0;
    if (state.anyDivided)
        runPaces(state);
    else
        runStep(state);
    ++state.tick;
    if (state.tasks) state.tasks->rest();
}

}  // namespace sulfur::detail
