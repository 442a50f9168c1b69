// Everything that a world is.
#pragma once

#include <cstdint>
#include <sulfur/events.hpp>
#include <sulfur/statistics.hpp>
#include <sulfur/world.hpp>
#include <utility>
#include <vector>

#include "collision/broad_phase.hpp"
#include "collision/contact.hpp"
#include "core/slots.hpp"
#include "joints/joints.hpp"
#include "particles/particles.hpp"
#include "world/bodies.hpp"
#include "world/influences.hpp"

namespace sulfur::detail {

/// Neighbouring particles [first, last).
struct Range {
    std::uint32_t first = 0, last = 0;
};

/// What the stages loop over, so that they never ask each particle whether it takes part.
/// Derived from the rest of the state whenever `stale`.
struct WorkLists {
    std::vector<Range> awake;  // particles of bodies that move
    std::vector<std::uint32_t> explicitJoints, implicitJoints, rigidJoints, breakableJoints;
    std::vector<std::uint32_t> attachments;
    std::uint32_t awakeParticles = 0;
    bool stale = true;
};

struct State {
    WorldSettings settings;
    Real h = 0;  // s, the tick
    std::uint64_t tick = 0;

    Particles particles;
    Joints joints;
    std::vector<Attachment> attachments;
    std::vector<BodyRecord> bodies;
    std::vector<BodyId> bodyIds;
    Influences influences;

    Slots<ParticleId> particleSlots;
    Slots<JointId> jointSlots;
    Slots<BodyId> bodySlots;
    Slots<AttachmentId> attachmentSlots;

    /// Particles whose velocity was set since the last tick: their first kick is half a tick's,
    /// which is where a scheme that keeps velocities at half ticks must start.
    std::vector<std::uint32_t> fresh;

    WorkLists work;
    BroadPhase broad;
    std::vector<Contact> contacts;
    std::vector<std::uint64_t> touching;                       // pairs of bodies in contact, sorted
    std::vector<std::uint64_t> touchingNow, touchingReported;  // scratch
    Events events;
    Statistics statistics;
    bool profiling = false;

    bool movable(std::uint32_t body) const {
        return bodies[body].kind != BodyKind::fixed && !bodies[body].asleep;
    }
};

/// Drops what is marked (true) and closes the gaps, keeping the order. Joints and attachments
/// that lose a particle go too.
struct Removal {
    std::vector<bool> particles, joints, attachments, bodies;

    explicit Removal(const State& state)
        : particles(state.particles.size()),
          joints(state.joints.size()),
          attachments(state.attachments.size()),
          bodies(state.bodies.size()) {}
};
void compact(State& state, Removal& removal);

/// Gives the particles of a body the inverse masses that its kind, their masses and pins demand.
void restoreInverseMass(State& state, std::uint32_t body);

/// Derives which joints are explicit, implicit and rigid; the collision radius of particles.
void classifyJoints(State& state);
void updateReach(State& state);

}  // namespace sulfur::detail
