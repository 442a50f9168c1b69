// How rigid components move in a tick: in closed form, with their spin kept.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// How gravity and the forces on its members accelerate a cluster. Trees use it for their own,
/// shorter steps.
struct ClusterLoad {
    Point acceleration{0, 0};  // m/s^2 of the centre
    double turning = 0;        // rad/s^2
};
/// A pure function of the state; nothing for a cluster that sleeps or is held.
ClusterLoad loadOf(const State& state, const Cluster& cluster);

/// Velocity and spin from the particles' velocities, for clusters whose particles somebody changed.
void adoptStirredClusters(State& state);
/// Velocity, spin and displacement of this tick, for the clusters of the work list.
void predictClusters(State& state);
/// Whether nobody but contacts asks where clusters go in this step: then their members need no
/// displacements, and the angles no sines.
bool onlyContactsAsk(const State& state);
/// Displacements of the members from those of their clusters, for the stages that look at
/// particles; forgets the forces on them.
void spreadDisplacements(State& state);
/// Velocities and spins take up what the constraints have changed.
void updateClusterVelocities(State& state);
/// Moves the clusters. Their members follow at once where a stage of the next step asks for them,
/// else when somebody asks.
void moveClusters(State& state);
/// Members that have not followed their clusters get position, displacement, velocity.
void bringMembers(State& state);
/// The same of one cluster.
void bringMembersOf(State& state, std::uint32_t cluster);
/// m, where a particle is now, also one that has not followed its cluster yet.
Point placeNow(const State& state, std::uint32_t particle);
/// Members of one cluster to their places, from centre and heading.
void placeMembers(State& state, std::uint32_t cluster);

}  // namespace sulfur::detail
