// Stage: displacements change until contacts, attachments and stiff joints hold.
//
// In each sweep contacts come before joints, so that what a contact disturbs in a body is mended
// in the same sweep, and rigid joints come last, so that they are the most exact of all.
#include "solver/constraint_kinds.hpp"
#include "solver/grabs.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

void solveConstraints(State& state) {
    clearMultipliers(state);
    startGrabs(state);
    for (int sweep = 0; sweep < state.settings.sweeps; ++sweep) {
        solveImplicitJoints(state);
        solveContacts(state);
        solveAttachments(state);
        solveGrabs(state);
        solveRigidJoints(state);
    }
    guardContacts(state);
    recordForces(state);
}

}  // namespace sulfur::detail
