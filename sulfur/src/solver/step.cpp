// One tick, from top to bottom.
#include <algorithm>
#include <chrono>
#include <utility>

#include "solver/driven.hpp"
#include "solver/paces.hpp"
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

/// What a tick adds to begins at zero.
void clearStatistics(Statistics& statistics) {
    statistics.items.fill(0);
    statistics.seconds.fill(0);
    statistics.rubbingContacts = statistics.fastBodies = statistics.heldBack = 0;
    statistics.pressedTriangles = statistics.plannedContacts = 0;
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

void clear(Events& events) {
    events.contactsBegun.clear();
    events.contactsPersisted.clear();
    events.contactsEnded.clear();
    events.jointsBroken.clear();
    events.bodiesSplit.clear();
    events.particlesLost.clear();
    events.sensorsEntered.clear();
    events.sensorsLeft.clear();
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
    timed(state, Stage::broadPhase, updateBroadPhase);
    timed(state, Stage::narrowPhase, findContacts);
    timed(state, Stage::constraints, solveConstraints);
    timed(state, Stage::velocities, updateVelocities);
    noteItems(state);
    timed(state, Stage::breakage, breakJoints);
    // Before anybody falls asleep or wakes: who slept through the tick still touches what it did.
    collectEvents(state);
    timed(state, Stage::sleep, updateSleep);
    state.idle = state.contacts.empty() && state.entwined.empty() && allRest(state);
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
    std::swap(events.contactsPersisted, more.contactsPersisted);
}

/// Who began to touch in an earlier step of the tick may be gone since.
void dropGone(const State& state, std::vector<ContactBegun>& begun) {
    const auto exists = [&](BodyId id) { return state.bodySlots.contains(id); };
    std::erase_if(begun, [&](const ContactBegun& e) { return !exists(e.a) || !exists(e.b); });
}

/// Each pair once, the first time that it was told, in the order of pairs. (A stable sort would
/// take memory.)
template <class Event>
void orderPairs(std::vector<Event>& events) {
    thread_local std::vector<std::pair<BodyPair, std::uint32_t>> order;
    thread_local std::vector<Event> ordered;
    order.clear();
    ordered.clear();
    for (const Event& e : events)
        order.emplace_back(BodyPair::of(e.a, e.b), static_cast<std::uint32_t>(order.size()));
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i)
        if (i == 0 || order[i].first != order[i - 1].first)
            ordered.push_back(events[order[i].second]);
    std::swap(events, ordered);
}

/// The whole tick of bodies whose ticks are not divided, while the others stand by.
void runWhole(State& state) {
    enterPace(state, Pace::whole);
    runStep(state);
    append(state.told, state.events);
}

/// The steps of bodies whose ticks are divided.
void runDivided(State& state) {
    enterPace(state, Pace::divided);
    while (state.steps.done < state.steps.count) {
        if (state.steps.done > 0) applyForcesAgain(state);
        runStep(state);
        append(state.told, state.events);
    }
}

/// What was told in several steps, as that of one tick.
void tellOnce(State& state) {
    std::swap(state.events, state.told);
    dropGone(state, state.events.contactsBegun);
    orderPairs(state.events.contactsBegun);
    orderPairs(state.events.contactsEnded);
}

/// A tick in which the ticks of some bodies, or of all, are divided.
void runPaces(State& state) {
    thread_local std::vector<ContactPersisted> persisted;
    clear(state.told);
    keepAppliedForces(state);
    std::uint32_t contacts = 0;
    persisted.clear();
    const bool mixed = state.steps.mixed;
    if (mixed) {
        runWhole(state);
        contacts = state.statistics.contacts;
        std::swap(persisted, state.told.contactsPersisted);
    }
    runDivided(state);
    state.statistics.contacts += contacts;
    leavePaces(state);
    tellOnce(state);
    if (!mixed) return;
    append(state.events.contactsPersisted, persisted);
    orderPairs(state.events.contactsPersisted);
}

/// Lists that name all that moves, of both paces, and the structure that they follow.
void updateLists(State& state) {
    const bool parkedBehind =
        state.work.movers != Movers::all && state.steps.parkedWork.madeAfter != state.listChanges;
    state.work.stale = state.work.stale || parkedBehind;
    if (state.structure.stale || state.work.stale) timed(state, Stage::changes, applyChanges);
}

}  // namespace

void step(State& state) {
    clearStatistics(state.statistics);
    if (mayDivideTicks(state) || state.anyDivided) {
        const bool changed = state.structure.stale;
        updateLists(state);
        timed(state, Stage::changes, [&](State& s) { choosePaces(s, changed); });
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
