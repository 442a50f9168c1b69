// One tick, from top to bottom.
#include <algorithm>
#include <chrono>

#include "bodies/driven.hpp"
#include "contacts/ask.hpp"
#include "contacts/stages.hpp"
#include "core/settings.hpp"
#include "rigid/cluster_motion.hpp"
#include "solver/mechanisms.hpp"
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
    state.statistics.seconds[static_cast<std::size_t>(stage)] +=
        std::chrono::duration<double>(Clock::now() - start).count();
}

/// What a tick adds to begins at zero.
void clearStatistics(Statistics& statistics) {
    statistics.items.fill(0);
    statistics.seconds.fill(0);
    statistics.fastPairs = statistics.heldBack = 0;
    statistics.pressedTriangles = statistics.looks = statistics.boxes = 0;
    statistics.chainSteps = statistics.chainFallbacks = statistics.chainsInLanes = 0;
    statistics.networkFactors = 0;
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
    events.limitsReached.clear();
    events.limitsLeft.clear();
    events.mechanismsBroken.clear();
    events.anglesBroken.clear();
}

/// What the stages of collision and constraints loop over.
void noteItems(State& state) {
    const WorkLists& work = state.work;
    std::uint32_t& pressed = state.statistics.pressedTriangles;  // the most in any step of the tick
    pressed = std::max(pressed, static_cast<std::uint32_t>(state.triangles.pressed.size()));
    state.looked(Stage::broadPhase, work.awakeSurfaces);
    state.looked(Stage::narrowPhase, state.core.watches.size());
    state.looked(Stage::constraints,
                 state.core.rows.size() + work.implicitJoints.size() + work.rigidJoints.size() +
                     work.implicitAngles.size() + work.attachments.size() + work.hinges.size() +
                     work.lines.size() + state.triangles.pressed.size() +
                     state.trees.touchedAlone.size() + state.influences.grabs.size() +
                     state.mechanisms.rows.size());
}

/// Whether something has been changed by hand since the lists were made.
bool isChanged(const State& state) {
    return state.structure.stale || state.work.stale || !state.turned.empty() ||
           !state.fresh.empty() || !state.influences.grabs.empty() ||
           !state.core.staleShapes.empty() || state.core.listsStale || state.anyForced;
}

/// Whether a tick would change nothing but the clock: all that could move sleeps.
bool allRest(const State& state) {
    const auto& movers = state.work.bodies;
    const auto moves = [&](std::uint32_t body) {
        return state.bodies[body].kind == BodyKind::dynamic || isDriven(state, body);
    };
    return !isChanged(state) && std::none_of(movers.begin(), movers.end(), moves);
}

void updateBroadPhase(State& state) {
    updateShapes(state);
    takeMotion(state);
    updateBoxes(state);
    leadApart(state);
}

void updateNarrowPhase(State& state) {
    lookAtPairs(state);
    refreshRows(state);
    if (state.callbacks.preSolve)
        askAboutRows(state);
    else
        state.core.passedBy.clear();
    const ContactCore& core = state.core;
    const bool manyNew = core.newRows > 0 && tuned::newShare * core.newRows >= core.rows.size();
    if (core.loadsAgain != 0 || manyNew) loadStacks(state);
}

void breakage(State& state) {
    // What joints take with them is no longer listed afterwards.
    const std::vector<AngleId> angles = breakingAngles(state);
    breakJoints(state);
    dropAngles(state, angles);
    breakMechanisms(state);
}

void runStages(State& state) {
    state.arena.reset();
    wakeInTheWay(state);
    // Stages that derive anew what has changed ask for all members.
    if (isChanged(state)) bringMembers(state);
    timed(state, Stage::changes, applyChanges);
    timed(state, Stage::forces, gatherForces);
    timed(state, Stage::fields, applyFields);
    timed(state, Stage::predict, predict);
    timed(state, Stage::broadPhase, updateBroadPhase);
    timed(state, Stage::narrowPhase, updateNarrowPhase);
    timed(state, Stage::constraints, solveConstraints);
    timed(state, Stage::velocities, updateVelocities);
    noteItems(state);
    timed(state, Stage::breakage, breakage);
    // Before anybody falls asleep or wakes: who slept through the tick still touches what it did.
    tellContacts(state);
    timed(state, Stage::sleep, updateSleep);
    state.idle = allRest(state);
    state.nearby.valid = false;
    timed(state, Stage::sensors, updateSensors);
    state.lastStep = static_cast<double>(state.h);
}

void noteStart(State& state) {
    bringMembers(state);
    state.starts.clear();
    const Particles& p = state.particles;
    for (std::uint32_t b = 0; b < state.bodies.size(); ++b) {
        if (!state.awake(b)) continue;
        const auto first = state.bodies[b].firstParticle;
        for (auto i = first; i < first + state.bodies[b].particles.size(); ++i)
            state.starts.push_back({p.id[i], p.position[i], p.force[i]});
    }
}

/// Calls f(start, particle) for what was awake when the tick began and is still there.
template <class Function>
void forEachStart(const State& state, Function&& f) {
    for (const ParticleStart& start : state.starts)
        if (state.particleSlots.contains(start.id)) f(start, state.particleSlots.dense(start.id));
}

/// Several steps as one tick: the caller's forces act in all of them, and displacements and events
/// are those of all.
void runSteps(State& state, std::uint32_t count) {
    Particles& p = state.particles;
    noteStart(state);
    const bool forced = state.anyForced;
    for (std::uint32_t i = 0; i < count; ++i) {
        state.stepsLeft = count - i;
        runStages(state);
        if (!forced || i + 1 == count) continue;
        state.anyForced = true;
        forEachStart(
            state, [&](const ParticleStart& start, std::uint32_t k) { p.force[k] += start.force; });
    }
    bringMembers(state);
    forEachStart(state, [&](const ParticleStart& start, std::uint32_t k) {
        if (state.awake(p.body[k]))
            p.displacement[k] = (p.position[k] - start.position).cast<Real>();
    });
}

}  // namespace

void step(State& state) {
    clearStatistics(state.statistics);
    clear(state.events);
    state.idle = state.idle && allRest(state);
    const std::uint32_t count = stepsPerTick(state.settings.tickRate);
    state.statistics.substeps = count;
    if (state.idle) {
        ++state.statistics.idleTicks;
        timed(state, Stage::sensors, updateSensors);
    } else if (count == 1) {
        runStages(state);
    } else {
        runSteps(state, count);
    }
    state.discTurns.clear();
    ++state.tick;
    if (state.tasks) state.tasks->rest();
}

}  // namespace sulfur::detail
