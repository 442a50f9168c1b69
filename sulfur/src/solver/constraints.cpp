// Stage: displacements change until contacts, attachments and stiff joints hold.
//
// In each sweep contacts come before joints, so that what a contact disturbs in a body is mended
// in the same sweep; rigid joints come last, and trees, which are solved as a whole, last of all.
#include <algorithm>

#include "rigid/loads.hpp"
#include "solver/constraint_kinds.hpp"
#include "solver/contact_forest.hpp"
#include "solver/grabs.hpp"
#include "solver/hold_back.hpp"
#include "solver/impacts.hpp"
#include "solver/stages.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

/// Sweeps more, of contacts and trees alone, when a loaded rope bends round something: its light
/// links then move by more than they are long, and each sweep is a step of Newton's method.
constexpr int mostForTrees = 24;

namespace {

/// Whether anything but contacts is solved in sweeps. Without, they end as soon as contacts hold.
bool sweepsOthers(const State& state) {
    const WorkLists& work = state.work;
    const auto isTouched = [&](std::uint32_t tree) { return state.trees.touched[tree] != 0; };
    return !work.implicitJoints.empty() || !work.rigidJoints.empty() || !work.attachments.empty() ||
           !work.hinges.empty() || !work.lines.empty() || !state.influences.grabs.empty() ||
           std::any_of(work.lonelyTrees.begin(), work.lonelyTrees.end(), isTouched);
}

}  // namespace

void solveConstraints(State& state) {
    clearMultipliers(state);
    startGrabs(state);
    touchTrees(state);
    warmStartContacts(state);
    recoverDrifts(state);
    thread_local ContactForest forest;
    forest.forget(state);
    const bool contactsAlone = !sweepsOthers(state);
    for (int sweep = 0; sweep < state.settings.sweeps; ++sweep) {
        if (sweep > 0 && contactsAlone && !ContactForest::isNeeded(state)) break;
        solveImplicitJoints(state);
        solveContacts(state, sweep % 2 != 0);
        // In the last sweep and every other one before: what it has mended, sweeps keep.
        if ((state.settings.sweeps - sweep) % 2 != 0) forest.solve(state);
        solveAttachments(state);
        solveGrabs(state);
        solveRigidJoints(state);
        sweepTrees(state);
    }
    for (int i = 0; i < mostForTrees && treesAreStrained(state); ++i) {
        solveContacts(state, i % 2 != 0);
        solveAttachments(state);
        sweepTrees(state);
    }
    guardContacts(state);
    limitImpacts(state);
    holdBack(state);
    finishContacts(state);
    for (int sweep = 0; sweep < state.settings.sweeps; ++sweep) solveRecovery(state);
    applyRecovery(state);
    recordTreeForces(state);
    recordForces(state);
    recoverLoads(state);
}

}  // namespace sulfur::detail
