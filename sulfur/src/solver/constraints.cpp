// Stage: displacements change until contacts, attachments and stiff joints hold.
//
// In each sweep contacts come before joints, so that what a contact disturbs in a body is mended
// in the same sweep; rigid joints come last, and trees, which are solved as a whole, last of all.
#include <algorithm>

#include "core/pieces.hpp"
#include "rigid/loads.hpp"
#include "solver/areas.hpp"
#include "solver/constraint_kinds.hpp"
#include "solver/contact_forest.hpp"
#include "solver/contact_rows.hpp"
#include "solver/grabs.hpp"
#include "solver/hold_back.hpp"
#include "solver/impacts.hpp"
#include "solver/stages.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

/// Sweeps more, of what is rigid and contacts, when a loaded rope bends round something: its light
/// links then move by more than they are long, and each sweep is a step of Newton's method; or when
/// a heavy thing lies on a frame of rigid joints.
constexpr int mostForStrain = 48;

/// And of contacts and areas, where contacts have pressed soft bodies too flat since the tick
/// began.
constexpr int mostForAreas = 16;

/// And of all, where they leave something pressed into something else; after that, of contacts
/// alone.
constexpr int mostForDepth = 8, mostForDepthAlone = 16;

namespace {

/// Contacts begin with what they carried, while another thread hands out their colours.
void startContacts(State& state, ContactRows& rows) {
    constexpr std::size_t inMicrosecond = 200;
    const bool apart = piecesOf(state.tasks, state.contacts.size(), inMicrosecond) > 1;
    runBoth(
        apart ? state.tasks : nullptr, [&] { rows.colour(state); },
        [&] { warmStartContacts(state); });
}

/// Whether anything but contacts is solved in sweeps. Without, they end as soon as contacts hold.
bool sweepsOthers(const State& state) {
    const WorkLists& work = state.work;
    const auto isTouched = [&](std::uint32_t tree) { return state.trees.touched[tree] != 0; };
    return !work.implicitJoints.empty() || !work.rigidJoints.empty() || !work.attachments.empty() ||
           !work.hinges.empty() || !state.triangles.pressed.empty() || !work.lines.empty() ||
           !state.influences.grabs.empty() ||
           std::any_of(work.lonelyTrees.begin(), work.lonelyTrees.end(), isTouched);
}

/// All contacts at once along the paths of load, where they are left with an error. Motions are
/// with the rows before and after.
void solveForest(State& state, ContactRows& rows, ContactForest& forest) {
    if (!forest.mayHelp()) return;
    rows.giveMotions(state);
    rows.giveMultipliers(state);
    forest.solve(state);
    rows.takeMotions(state);
    rows.takeMultipliers(state);
}

/// What contacts have pressed too flat since the tick began, on the motions in the state. Returns
/// whether there was any.
bool sweepAreas(State& state, ContactRows& rows) {
    if (!morePressed(state)) return false;
    for (int i = 0; i < mostForAreas; ++i) {
        solveAreas(state);
        rows.sweep(state, i % 2 != 0);
    }
    return true;
}

/// Where all contacts are in blocks and nothing else is swept, their motions stay there. The forest
/// comes before the first sweep, so that sweeps begin near the solution, or before the second where
/// one might have been enough; and last, for what they have left, with a sweep for what the bounds
/// of its rows have left. One sweep there is always: errors that are not worth more must not add up
/// from tick to tick.
void sweepContactsAlone(State& state, ContactRows& rows, ContactForest& forest) {
    bool anyError = rows.anyError(state), solved = false;
    for (int sweep = 0; sweep == 0 || (anyError && sweep < state.settings.sweeps); ++sweep) {
        if (anyError && !solved && (sweep > 0 || rows.anyLargeError(state))) {
            solveForest(state, rows, forest);
            solved = true;
        }
        rows.sweep(sweep % 2 != 0);
        anyError = rows.anyError(state);
    }
    if (anyError) {
        solveForest(state, rows, forest);
        rows.sweep(false);
    }
    rows.giveMotions(state);
    if (sweepAreas(state, rows)) rows.takeMotions(state);
}

/// Whether contacts leave ropes or rigid joints wrong.
bool isStrained(State& state) {
    return treesAreStrained(state) || touchedRigidJointsAreStrained(state);
}

bool isPressedIn(State& state, ContactRows& rows) {
    if (state.contacts.empty()) return false;
    rows.takeMotions(state);
    return rows.anyDeepError(state) || rows.anyDeepErrorSingly(state);
}

void sweepSoft(State& state, ContactRows& rows, bool backwards) {
    solveImplicitJoints(state);
    solveAreas(state);
    rows.sweep(state, backwards);
}

void sweepRigid(State& state) {
    solveAttachments(state);
    solveGrabs(state);
    solveRigidJoints(state);
    sweepTrees(state);
}

/// Between what else is swept, the forest takes part in the last sweep and every other one before.
void sweepAll(State& state, ContactRows& rows, ContactForest& forest) {
    const int last = state.settings.sweeps - 1;
    for (int sweep = 0; sweep <= last; ++sweep) {
        sweepSoft(state, rows, sweep % 2 != 0);
        rows.takeMotions(state);
        if ((last - sweep) % 2 == 0 && rows.anyError(state)) solveForest(state, rows, forest);
        sweepRigid(state);
    }
    for (int i = 0; i < mostForDepth && isPressedIn(state, rows); ++i) {
        sweepSoft(state, rows, i % 2 != 0);
        sweepRigid(state);
    }
    for (int i = 0; i < mostForStrain && isStrained(state); ++i) {
        rows.sweep(state, i % 2 != 0);
        sweepRigid(state);
    }
    sweepAreas(state, rows);
    rows.takeMotions(state);
    for (int i = 0; i < mostForDepthAlone && rows.anyDeepError(state); ++i) rows.sweep(i % 2 != 0);
    rows.giveMotions(state);
}

}  // namespace

void solveConstraints(State& state) {
    thread_local ContactForest forest;
    thread_local ContactRows rows;
    clearMultipliers(state);
    startGrabs(state);
    touchTrees(state);
    startAreas(state);
    startContacts(state, rows);
    forest.forget(state);
    rows.collect(state);
    rows.warmStart(state);
    const bool contactsAlone = rows.takesAll() && !sweepsOthers(state);
    (contactsAlone ? sweepContactsAlone : sweepAll)(state, rows, forest);
    rows.giveMultipliers(state);
    if (rows.anyTooDeep(state)) guardContacts(state);
    limitImpacts(state);
    holdBack(state);
    finishContacts(state);
    rows.recover(state);
    recoverAreas(state);
    recordTreeForces(state);
    recordForces(state);
    recoverLoads(state);
}

}  // namespace sulfur::detail
