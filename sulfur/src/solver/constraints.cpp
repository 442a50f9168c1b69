// Stage: displacements change until contacts, attachments and stiff joints hold.
//
// Rows of contacts are swept between what else is swept: joints come after contacts, so that what a
// contact disturbs in a body is mended in the same sweep; trees, which are solved as a whole, last.
#include <algorithm>

#include "contacts/ask.hpp"
#include "contacts/stages.hpp"
#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "rigid/loads.hpp"
#include "solver/areas.hpp"
#include "solver/constraint_kinds.hpp"
#include "solver/grabs.hpp"
#include "solver/mechanisms.hpp"
#include "solver/momenta.hpp"
#include "solver/stages.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

using tuned::mended;
using tuned::mostForStrain;
using tuned::mostTimes;
using tuned::trial;
constexpr double mostStrain = tuned::strainLimit;

/// Joints, points or trees are swept beside contacts and triangles.
bool sweepsJoints(const State& state) {
    const WorkLists& work = state.work;
    const auto isTouched = [&](std::uint32_t tree) { return state.trees.touched[tree] != 0; };
    return !work.implicitJoints.empty() || !work.implicitAngles.empty() ||
           !work.rigidJoints.empty() || !work.attachments.empty() || !work.hinges.empty() ||
           !work.lines.empty() || !state.influences.grabs.empty() ||
           !state.mechanisms.rows.empty() ||
           std::any_of(work.lonelyTrees.begin(), work.lonelyTrees.end(), isTouched);
}

/// How many sweeps over rows a step has work for, when they may take so many rows for each mover.
int sweepsFor(const State& state, std::uint32_t rowsOfMover, std::size_t rows, int most) {
    const ContactCore& core = state.core;
    const std::size_t all = rowsOfMover * (core.awakeMovers.size() + tuned::fewMovers);
    return static_cast<int>(std::min(all / std::max<std::size_t>(rows, 1), std::size_t(most)));
}
int sweepsFor(const State& state, int most) {
    const std::uint32_t rows =
        std::max(tuned::sweptRows / stepsPerTick(state.settings.tickRate), tuned::sweptRowsOfStep);
    return std::max(sweepsFor(state, rows, state.core.rows.size(), most), std::min(2, most));
}
/// The same of sweeps for strain, which solve trees too.
int sweepsForStrain(const State& state) {
    const auto nodesOf = [&](const std::vector<std::uint32_t>& trees) {
        std::size_t sum = 0;
        for (const auto i : trees) sum += state.trees.list[i].last - state.trees.list[i].first;
        return sum;
    };
    const std::size_t nodes = nodesOf(state.trees.touchedAlone) + nodesOf(state.work.lines);
    const std::uint32_t steps = stepsPerTick(state.settings.tickRate);
    return sweepsFor(state, tuned::strainedRows / steps,
                     state.core.rows.size() + tuned::rowsOfLink * nodes, mostForStrain);
}

/// Of the last step of a tick.
void countRows(State& state) {
    Statistics& statistics = state.statistics;
    statistics.candidates = static_cast<std::uint32_t>(state.core.watches.size());
    statistics.contacts = static_cast<std::uint32_t>(state.core.rows.size());
}

void sweepRigid(State& state, int number) {
    solveAttachments(state);
    solveGrabs(state);
    solveMechanisms(state);
    solveRigidJoints(state);
    sweepTrees(state, number);
}

bool sweepContacts(State& state, int number) {
    takeMotionOfTied(state, number);
    const bool first = number == 1, anew = first || !state.core.tied.empty();
    const bool stirred =
        sweepRows(state, number, {.begins = first, .anew = anew, .onlyStirred = !first});
    giveMotion(state);
    return stirred;
}

/// Trees, then networks, answer what rows begin with: before impacts, which would find nodes thrown
/// by that.
void beginTrees(State& state) {
    if (state.trees.touchedAlone.empty()) return;
    listTiedToTrees(state);
    answerLoadsOfTrees(state);
    giveMotion(state);
    answerLoadsOfNetworks(state);
    takeMotionOfTied(state, 1);
}

/// Rows of contacts alone are done when none stirs. Joints, whose errors add up along a body, get
/// more sweeps than triangles, which only have to keep their side.
void sweepAll(State& state) {
    const bool withJoints = sweepsJoints(state);
    const bool alone = !withJoints && state.triangles.pressed.empty();
    const int sweeps = state.settings.sweeps;
    const int wanted = withJoints ? mostTimes * sweeps : sweeps;
    const int most = sweepsFor(state, wanted), least = alone ? 1 : std::min(sweeps, most);
    listTied(state);
    giveMotion(state);
    holdNetworkRows(state);
    bool stirred = true;
    for (int number = 1; number <= most && (stirred || number <= least); ++number) {
        solveImplicitJoints(state);
        solveAngles(state);
        solveAreas(state);
        stirred = sweepContacts(state, number);
        sweepRigid(state, number);
    }
    double strain = strainOfTrees(state), before = 0;
    const int mostOfStrain = sweepsForStrain(state);
    for (int i = 0; i < mostOfStrain && strain > mostStrain; ++i) {
        if (i % trial == 0) {
            if (i > 0 && strain > (1 - mended) * before) break;
            before = strain;
        }
        sweepContacts(state, most);
        sweepRigid(state, 1);
        strain = strainOfTrees(state);
    }
    finishTrees(state, strain);
    releaseNetworkRows(state);
}

}  // namespace

void solveConstraints(State& state) {
    notePlaces(state);
    state.contacts.clear();
    countRows(state);
    clearMultipliers(state);
    startAngles(state);
    startGrabs(state);
    settleMechanisms(state);
    touchTrees(state);
    answerMechanisms(state);
    beginTrees(state);
    forgetWild(state, beginTrees);
    startAreas(state);
    strikeRows(state);
    shareBlows(state);
    sweepAll(state);
    if (state.settings.friction == Friction::sliding) dragRows(state);
    dampSticking(state);
    endMotion(state);
    forgetVain(state);
    endBlows(state);
    holdBackFast(state);
    endLeads(state);
    leadMechanisms(state);
    forgetAnswers(state);
    if (!state.work.watchedClusters.empty()) exportContacts(state, state.contacts, false);
    recoverAreas(state);
    recordTreeForces(state);
    recordForces(state);
    recordAngles(state);
    recordMechanisms(state);
    recoverLoads(state);
}

}  // namespace sulfur::detail
