// What the calls of World have in common.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "bodies/impl.hpp"
#include "joints/classify.hpp"

namespace sulfur::detail {

/// Dense indices of handles; they throw Error{staleHandle} when the thing is gone.
std::uint32_t indexOf(const State& state, ParticleId id);
std::uint32_t indexOf(const State& state, JointId id);
std::uint32_t indexOf(const State& state, BodyId id);
std::uint32_t indexOf(const State& state, AttachmentId id);
std::uint32_t indexOf(const State& state, AngleId id);

/// Throws unless a pose is in its range.
void validatePose(const Pose& pose);
/// Throws Error{degenerate} where nobody may give a body a velocity.
void refuseFixed(const State& state, std::uint32_t body);
/// Gives a particle a velocity (m/s) unless it is pinned; State::fresh has room for it.
void setParticleVelocity(State& state, std::uint32_t particle, const Point& velocity);

/// The particles of a body that hold a point of its blueprint's frame best, with their weights; the
/// attachment's own particle and id are left open.
Attachment supportsFor(const State& state, std::uint32_t body, Vec2 point);

/// What physics moves of a body, kg.
Real movableMass(const State& state, std::uint32_t body);

/// Throws unless the numbers of a drive are in their ranges.
void validate(const Drive& drive);
/// Throws unless it is above 0, or `infinite`.
void requireStrength(Real strength, const char* what);
/// The joints of a plan by both of their particles, the lower one first.
using JointsByEnds = std::vector<std::pair<std::array<std::uint32_t, 2>, std::size_t>>;
/// Takes the memory that the angular joints of a plan need, and returns what adds them.
JointsByEnds makeRoomForAngles(State& state, const Blueprint& plan);
/// Adds them to a body, whose particles and joints are there, and which is about to be the last.
void addAngles(State& state, const Blueprint& plan, const BodyRecord& body,
               const JointsByEnds& joints);
/// Throws Error{staleHandle} when it is gone.
const Mechanism& knownMechanism(const State& state, MechanismId id);
/// What a drive no longer has, gives nothing any more: the next step begins with the forces of the
/// last one, and nobody would take these back.
void forgetTaken(const Drive& drive, RowForces& forces);
/// Wakes both bodies, as far as they are there.
void wakeBoth(State& state, const Mechanism& mechanism);

/// Wakes the bodies of both ends of a joint and what lies on them.
void wakeEnds(State& state, std::uint32_t joint);
/// Wakes the bodies of both ends, and makes the next tick notice changed joints.
void jointChanged(State& state, std::uint32_t joint);
/// The same, but for what is as good as before: a joint gets this stiffness and damping (which may
/// be what it has), or this length at rest. Where it may, only what is around it follows.
void retune(State& state, std::uint32_t joint, const Spring& spring);
void changeRestLength(State& state, std::uint32_t joint, Real restLength);
void bodyChanged(State& state);
/// Makes the next tick measure the rigid components of a body again.
void shapeChanged(State& state, std::uint32_t body);

}  // namespace sulfur::detail
