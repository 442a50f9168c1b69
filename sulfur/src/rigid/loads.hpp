// What the joints inside of rigid components carry.
#pragma once

#include <memory>
#include <sulfur/ids.hpp>

#include "model/state.hpp"

namespace sulfur::detail {

/// Before the forces on particles are forgotten: notes those on the members of watched clusters.
void noteLoads(State& state);
/// After the sweeps: the tensions of the joints inside of watched clusters, into Joints::force.
///
/// A cluster moves as if its joints did not exist; what they carry is recovered from what acts on
/// its members. The applied forces less masses times accelerations are in balance, and of all
/// tensions that balance them those are taken that a truss of bars of equal stiffness per length
/// would have (the least squares over the component's graph), factored once in its own frame.
void recoverLoads(State& state);

}  // namespace sulfur::detail
