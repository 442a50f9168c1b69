// Removing things and closing the gaps that they leave.
#pragma once

#include <vector>

#include "model/state.hpp"

namespace sulfur::detail {

/// Drops what is marked (true) and closes the gaps, keeping the order. Joints and attachments
/// that lose a particle go too, angular joints also that lose a joint along one of their arms.
/// Mechanisms that hold what has gone stay until forgetMechanisms().
struct Removal {
    std::vector<bool> particles, joints, attachments, bodies, angles;

    explicit Removal(const State& state)
        : particles(state.particles.size()),
          joints(state.joints.size()),
          attachments(state.attachments.size()),
          bodies(state.bodies.size()),
          angles(state.angles.size()),
          newParticle(state.particles.size()),
          newBody(state.bodies.size()),
          newCluster(state.clusters.list.size()) {}

    /// New index of each old one, or none; compact() fills them.
    std::vector<std::uint32_t> newParticle, newBody, newCluster;
};
void compact(State& state, Removal& removal);
/// It can then be done without taking memory, unless a body with a skin loses some of its
/// particles, or bodies go for which makeRoomToForget() was not called.
void makeRoomToCompact(State& state);
/// Takes a body away, with what is tied to it. What touched it wakes. If there is no memory,
/// nothing has changed. Members of rigid components need not have followed these.
void removeBody(State& state, std::uint32_t body);

/// BodyRecord::ties of all bodies.
void countTies(State& state);

/// All that names particles by their index follows them to new ones, except the arrays themselves.
/// Trees must have been dissolved. `none`: the particle is gone.
void renumberParticles(State& state, const std::vector<std::uint32_t>& newIndex);

}  // namespace sulfur::detail
