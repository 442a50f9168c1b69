// Everything that a world is.
#pragma once

#include <algorithm>
#include <cstdint>
#include <sulfur/events.hpp>
#include <sulfur/statistics.hpp>
#include <sulfur/tasks.hpp>
#include <sulfur/world.hpp>
#include <utility>
#include <vector>

#include "core/frame_arena.hpp"
#include "core/settings.hpp"
#include "core/slots.hpp"
#include "model/angles.hpp"
#include "model/bodies.hpp"
#include "model/callbacks.hpp"
#include "model/chain_batches.hpp"
#include "model/clusters.hpp"
#include "model/contact_core.hpp"
#include "model/contact_load.hpp"
#include "model/disc_turns.hpp"
#include "model/explicit_joints.hpp"
#include "model/influences.hpp"
#include "model/joints.hpp"
#include "model/mechanisms.hpp"
#include "model/particles.hpp"
#include "model/sensing.hpp"
#include "model/swept_joints.hpp"
#include "model/trees.hpp"
#include "model/triangles.hpp"

namespace sulfur::detail {

/// Neighbouring particles [first, last).
struct Range {
    std::uint32_t first = 0, last = 0;
};

/// Two bodies, the one with the smaller handle first.
struct BodyPair {
    BodyId a, b;

    static BodyPair of(BodyId p, BodyId q) { return q < p ? BodyPair{q, p} : BodyPair{p, q}; }
    friend auto operator<=>(const BodyPair&, const BodyPair&) = default;
};

/// Neighbouring joints that have multipliers.
struct StiffRun {
    std::uint32_t first = 0, last = 0;
    bool forces = false;  // they are partly forces too
};

/// The colour of what the others left none for.
inline constexpr std::uint8_t noColour = 63;

/// How what is stiff is solved: derived from joints, attachments, masses and pins whenever `stale`,
/// whether it is awake or not.
struct Structure {
    // What no tree has taken, in the order of the sweeps: joints of one colour share no particle.
    std::vector<std::uint32_t> sweptJoints, sweptAttachments, sweptHinges;
    std::vector<std::uint8_t> colours;  // of all joints; those of `noColour` share particles
    bool stale = true;
    // Bodies were added since it was derived of `before`, and nothing else changed. What was
    // derived then may differ by roundings from what would be now, so that it decides.
    bool onlyAdded = false;
    Counts before;

    /// To what there was so far.
    void bodyAdded(const Counts& soFar) {
        if (!stale) {
            onlyAdded = true;
            before = soFar;
        }
        stale = true;
    }
    void changed() {
        stale = true;
        onlyAdded = false;
    }

    template <class Archive>
    void archive(Archive& a) {
        a(sweptJoints);
        a(sweptAttachments);
        a(sweptHinges);
        a(colours);
        a(stale);
    }
    template <class Archive>
    void archiveAdded(Archive& a) {
        a(onlyAdded);
        a(before);
    }
};

/// What the stages loop over, so that they never ask each particle whether it takes part.
/// Derived from the structure and from who is awake whenever `stale`.
struct WorkLists {
    std::vector<Range> awake;   // all particles of bodies that move and have a surface
    std::vector<Range> points;  // all particles of bodies that move but those in clusters
    std::vector<Range> free;    // of these, the ones in no tree that moves alone
    std::vector<std::uint32_t> awakeClusters;
    std::vector<std::uint32_t> clusters;         // of these, the ones in no tree that moves alone
    std::vector<std::uint32_t> watchedClusters;  // of these, the ones with joints that may break
    std::vector<std::uint32_t> lonelyTrees;      // that move alone
    std::vector<std::uint32_t> tiedTrees;  // of these, the ones that swept constraints pull on
    ChainBatches chains;                   // of these, the ones that go in lanes
    std::vector<std::uint32_t> heldNodes;  // particles in such trees that nothing moves
    std::vector<std::uint32_t> lines;      // trees that are solved in the sweeps
    std::vector<std::uint32_t> explicitJoints, implicitJoints, rigidJoints;  // the latter two swept
    SweptJoints implicitSweep, rigidSweep;                                   // their batches
    ExplicitJoints explicitBatches;
    std::vector<std::uint32_t> explicitAngles, implicitAngles;  // which are partly both
    SweptAngles sweptAngles;                                    // the latter
    std::vector<std::uint32_t> stiffJoints;                     // all that have a multiplier
    std::vector<StiffRun> stiffRuns;                            // the same
    std::vector<std::uint32_t> breakableJoints;
    std::vector<std::uint32_t> breakableAngles;  // that are not driven
    // All joints that are not rigid, body by body, asleep or not; where those of each body begin.
    std::vector<std::uint32_t> springs, springStart;
    std::vector<std::uint32_t> attachments, hinges;  // swept
    std::vector<std::uint32_t> sweptParticles;       // with a surface, that swept joints hold
    bool holdsClusters = false;            // a joint or tree of these lists holds a rigid component
    std::vector<std::uint32_t> bodies;     // that move: awake dynamic ones and kinematic ones
    std::vector<std::uint32_t> kinematic;  // of these
    std::vector<std::uint32_t> strained;   // bodies that were bent out of shape
    std::vector<std::uint32_t> tiedJoints;  // between bodies, awake or not
    std::vector<std::uint32_t> turned;      // bodies by slot that this step begins to follow
    std::uint32_t awakeParticles = 0, awakeSurfaces = 0;  // particles of bodies that move
    std::uint32_t sleepers = 0;                           // bodies
    bool hasGaps = false;  // what is gone may still be in lists of bodies, clusters and joints
    bool stale = true;
    bool onlyAdded = false;  // by bodies that were added to those `listed`, and in no other way
    bool retuned = false;    // joints have other numbers than their batches
    Counts listed;

    void bodyAdded() {
        onlyAdded = onlyAdded || !stale;
        stale = true;
    }
    void changed() {
        stale = true;
        onlyAdded = false;
    }
};

/// A body whose outline no box of the broad phase covers, and the box round that.
struct Hollow {
    std::uint32_t body = 0;  // slot
    Point low{0, 0}, high{0, 0};
};

/// What queries need besides the boxes of the broad phase; see queries/nearby.hpp.
struct Nearby {
    std::vector<std::uint32_t> apart;   // bodies (dense, ascending) that are not as boxes hold them
    std::vector<std::uint8_t> isApart;  // the same by body slot
    std::vector<std::uint32_t> tied;    // capsules between bodies of which one is apart
    std::vector<Hollow> hollows;
    bool valid = false;  // until the next step, or until something is changed by hand
    bool hollowsListed = false;
    std::vector<std::uint32_t> around;  // of the last bodiesAround(), dense indices
};

/// A particle when the present tick began.
struct ParticleStart {
    ParticleId id;
    Point position{0, 0};  // m
    Point force{0, 0};     // N, of the caller
};

using tuned::leastStepRate;

/// A world with slower ticks divides each of them into so many equal steps, for all that is awake.
inline std::uint32_t stepsPerTick(int tickRate) {
    return static_cast<std::uint32_t>((leastStepRate + tickRate - 1) / tickRate);
}

/// s
inline Real stepDuration(int tickRate) {
    return 1 / static_cast<Real>(tickRate) / static_cast<Real>(stepsPerTick(tickRate));
}

struct State {
    WorldSettings settings;
    Real h = 0;            // s, the step
    double lastStep = 0;   // s, the step before: velocities stand in its middle
    double stepsLeft = 1;  // of the present tick, with the present one
    std::uint64_t tick = 0;
    // When the rate was set last: the clock counts from there.
    std::uint64_t rateTick = 0;
    double rateTime = 0;  // s

    Particles particles;
    Joints joints;
    Angles angles;
    std::vector<Attachment> attachments;
    Clusters clusters;
    Trees trees;
    std::vector<BodyRecord> bodies;  // also those that are gone, until their gaps are closed
    std::vector<BodyId> bodyIds;     // of the others, once listedIds() was asked
    bool idsHaveGaps = false;        // some of these are gone
    Counts gone;                     // what is no longer there and still takes place
    Influences influences;
    Mechanisms mechanisms;

    Slots<ParticleId> particleSlots;
    Slots<JointId> jointSlots;
    Slots<BodyId> bodySlots;
    Slots<AttachmentId> attachmentSlots;
    Slots<AngleId> angleSlots;

    /// Particles whose velocity was set since the last tick: their first kick is half a tick's,
    /// which is where a scheme that keeps velocities at half ticks must start.
    std::vector<std::uint32_t> fresh;
    std::vector<std::uint32_t> young;  // of this step: what was fresh when it began
    std::vector<DiscTurn> discTurns;   // of the caller, by handle, until the next tick has ended

    Structure structure;
    WorkLists work;
    /// Bodies by slot that woke or fell asleep since the lists were made, and those that were made
    /// or moved by hand since the last tick.
    std::vector<std::uint32_t> turned, placed;
    Triangles triangles;
    std::vector<std::uint32_t> surface;  // by particle, the joint whose surface it shows, or none
    std::vector<ContactLoad> contacts;   // of this step, where rigid components may break
    std::vector<ContactLoad> asked;      // of one body, for a caller
    std::vector<Vec2> loads;             // N on members of watched clusters in this tick
    std::vector<BodyPair> vetoes;        // that never collide, sorted
    Nearby nearby;
    Sensing sensing;
    ContactCore core;
    bool structureChanged = true;  // since links between bodies were listed
    FrameArena arena;              // of a step
    Events events;
    std::vector<ParticleStart> starts;  // of a tick of several steps: what was awake
    Statistics statistics;
    Callbacks callbacks;
    bool profiling = false;
    Tasks* tasks = nullptr;      // threads that the host lends; null: the caller's alone
    bool anyStirred = true;      // some cluster is stirred
    bool anyForced = true;       // members of awake clusters may have forces that are still to act
    bool gravityScaled = false;  // a body has, or had, another BodyRecord::gravityScale than 1
    bool damped = false;         // a body is, or was, damped
    bool membersBehind = false;  // those of awake clusters have not followed them yet
    /// What follows from who is awake, found at the end of a tick and void after any change: no
    /// tick would change anything.
    bool idle = false;

    void looked(Stage stage, std::size_t items) {
        statistics.items[static_cast<std::size_t>(stage)] += static_cast<std::uint32_t>(items);
    }

    bool awake(std::uint32_t body) const {
        return bodies[body].kind != BodyKind::fixed && !bodies[body].asleep &&
               !bodies[body].disabled;
    }
};

/// The bodies, oldest first. Who goes leaves a gap, which is closed when somebody asks.
inline std::vector<BodyId>& listedIds(State& state) {
    if (std::exchange(state.idsHaveGaps, false)) {
        state.statistics.upkeep += state.bodyIds.size();
        std::erase_if(state.bodyIds, [&](BodyId id) { return !state.bodySlots.contains(id); });
    }
    return state.bodyIds;
}

/// Which step this is of all that a world of this rate takes, also of those that it skips because
/// all sleeps.
inline std::uint64_t stepNumber(const State& state) {
    const std::uint64_t count = stepsPerTick(state.settings.tickRate);
    return count * state.tick + count - static_cast<std::uint64_t>(state.stepsLeft);
}

/// What of the world's gravity acts on a body besides itself, m/s^2.
inline Point moreGravity(const State& state, std::uint32_t body) {
    const double more = static_cast<double>(state.bodies[body].gravityScale) - 1;
    return more * state.settings.gravity.cast<double>();
}

/// By what share of the world's gravity a mover that is awake falls.
/// m/s^2, that acts on a body.
inline Point gravityOf(const State& state, std::uint32_t body) {
    Point gravity = state.settings.gravity.cast<double>();
    if (state.gravityScaled) gravity += moreGravity(state, body);
    return gravity;
}
inline Real gravityScaleOf(const State& state, std::uint32_t mover) {
    if (!state.gravityScaled) return 1;
    return state.bodies[state.bodySlots.denseOf(state.core.movers.body[mover])].gravityScale;
}

/// The angular joints of a body.
inline Range anglesOf(const State& state, std::uint32_t body) {
    const auto& list = state.angles.body;
    const auto [from, to] = std::equal_range(list.begin(), list.end(), body);
    return {static_cast<std::uint32_t>(from - list.begin()),
            static_cast<std::uint32_t>(to - list.begin())};
}

/// Whether the body of a particle takes part.
inline bool isEnabled(const State& state, std::uint32_t particle) {
    return !state.bodies[state.particles.body[particle]].disabled;
}
/// Whether what is tied does nothing, because one of its ends is of a body that takes no part.
inline bool isCut(const State& state, const Attachment& held) {
    bool cut = !isEnabled(state, held.particle);
    for (std::uint32_t k = 0; k < held.count; ++k) cut |= !isEnabled(state, held.support[k]);
    return cut;
}
inline bool isCut(const State& state, std::uint32_t joint) {
    return !isEnabled(state, state.joints.a[joint]) || !isEnabled(state, state.joints.b[joint]);
}

/// Whether the present step is the first of its tick.
inline bool isFirstStep(const State& state) {
    return static_cast<std::uint32_t>(state.stepsLeft) == stepsPerTick(state.settings.tickRate);
}

inline Counts countsOf(const State& state) {
    return {static_cast<std::uint32_t>(state.particles.size()),
            static_cast<std::uint32_t>(state.joints.size()),
            static_cast<std::uint32_t>(state.bodies.size())};
}

}  // namespace sulfur::detail
