// Stage: displacements change until contacts, attachments and stiff joints hold.
//
// In each sweep contacts come before joints, so that what a contact disturbs in a body is mended
// in the same sweep; rigid joints come last, and trees, which are solved as a whole, last of all.
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

void solveConstraints(State& state) {
    clearMultipliers(state);
    startGrabs(state);
    touchTrees(state);
    warmStartContacts(state);
    recoverDrifts(state);
    thread_local ContactForest forest;
    forest.forget(state);
    for (int sweep = 0; sweep < state.settings.sweeps; ++sweep) {
        solveImplicitJoints(state);
        solveContacts(state, sweep % 2 != 0);
        forest.solve(state);
        solveRecovery(state);
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
    applyRecovery(state);
    recordTreeForces(state);
    recordForces(state);
    recoverLoads(state);
}

}  // namespace sulfur::detail
