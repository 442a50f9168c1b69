// Stage: displacements change until contacts, attachments and stiff joints hold.
//
// Rows of contacts are swept between what else is swept: joints come after contacts, so that what a
// contact disturbs in a body is mended in the same sweep; trees, which are solved as a whole, last.
#include <algorithm>

#include "contacts/contact_core.hpp"
#include "contacts/stages.hpp"
#include "rigid/loads.hpp"
#include "solver/areas.hpp"
#include "solver/constraint_kinds.hpp"
#include "solver/grabs.hpp"
#include "solver/stages.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// Sweeps over contacts alone: as few, and more, up to so many times those of the settings, while
/// one of them still changes how fast anything parts.
constexpr int leastAlone = 2, mostAlone = 2;
constexpr Real settledChange = Real(0.005);  // m/s
/// Sweeps over trees that a contact pulls on: while a link is wrong by more than this share of its
/// length, and so many sweeps mend at least a quarter of that. What is squeezed may have no
/// solution.
constexpr int mostForStrain = 48, trial = 8;
constexpr double mostStrain = 1e-4, mended = 1.0 / 4;

bool sweepsOthers(const State& state) {
    const WorkLists& work = state.work;
    const auto isTouched = [&](std::uint32_t tree) { return state.trees.touched[tree] != 0; };
    return !work.implicitJoints.empty() || !work.rigidJoints.empty() || !work.attachments.empty() ||
           !work.hinges.empty() || state.triangles.awake.count > 0 || !work.lines.empty() ||
           !state.influences.grabs.empty() ||
           std::any_of(work.lonelyTrees.begin(), work.lonelyTrees.end(), isTouched);
}

/// Of the last step of a tick.
void countRows(State& state) {
    Statistics& statistics = state.statistics;
    statistics.candidates = static_cast<std::uint32_t>(state.core.watches.size());
    statistics.contacts = 0;
    for (const ManifoldList& list : state.core.rows.manifolds) statistics.contacts += list.rows;
    for (const TouchList& list : state.core.rows.touches) statistics.contacts += list.rows;
}

void sweepRigid(State& state) {
    solveAttachments(state);
    solveGrabs(state);
    solveRigidJoints(state);
    sweepTrees(state);
}

void sweepContacts(State& state, bool last) {
    takeMotionAgain(state);
    sweepRows(state, true, last);
    giveMotion(state);
}

/// Rows of contacts and nothing else.
void sweepAlone(State& state) {
    const int most = std::max(leastAlone, mostAlone * state.settings.sweeps);
    for (int sweep = 1; sweep < most; ++sweep) {
        const Real change = sweepRows(state, sweep == 1, false);
        if (sweep + 1 >= leastAlone && change <= settledChange * state.h) break;
    }
    sweepRows(state, false, true);
}

void sweepAll(State& state) {
    giveMotion(state);
    for (int sweep = 0; sweep < state.settings.sweeps; ++sweep) {
        solveImplicitJoints(state);
        solveAreas(state);
        sweepContacts(state, sweep + 1 == state.settings.sweeps);
        sweepRigid(state);
    }
    double before = 0;
    for (int i = 0; i < mostForStrain; ++i) {
        const double strain = strainOfTrees(state);
        if (strain <= mostStrain) break;
        if (i % trial == 0) {
            if (i > 0 && strain > (1 - mended) * before) break;
            before = strain;
        }
        sweepContacts(state, false);
        sweepRigid(state);
    }
}

}  // namespace

void solveConstraints(State& state) {
    state.contacts.clear();
    countRows(state);
    clearMultipliers(state);
    startGrabs(state);
    touchTrees(state);
    startAreas(state);
    strikeRows(state);
    shareBlows(state);
    if (sweepsOthers(state)) {
        sweepAll(state);
    } else {
        sweepAlone(state);
    }
    if (state.settings.friction == Friction::sliding) dragRows(state);
    dampSticking(state);
    endMotion(state);
    endBlows(state);
    holdBackFast(state);
    endLeads(state);
    if (!state.work.watchedClusters.empty()) exportContacts(state, state.contacts, false);
    recoverAreas(state);
    recordTreeForces(state);
    recordForces(state);
    recoverLoads(state);
}

}  // namespace sulfur::detail
