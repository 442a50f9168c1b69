// Removing things and closing the gaps that they leave.
//
// A body that nothing is tied to goes at once, but its particles and joints keep their places in
// the arrays until half of these are gaps: removing costs what is removed, whatever else there is.
#include <algorithm>
#include <optional>
#include <utility>

#include "bodies/skins.hpp"
#include "bodies/sleep.hpp"
#include "contacts/stages.hpp"
#include "core/room.hpp"
#include "joints/classify.hpp"
#include "model/state.hpp"
#include "rigid/cluster_motion.hpp"
#include "rigid/find_clusters.hpp"
#include "solver/compact.hpp"
#include "solver/work_lists.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

void renumber(const std::vector<bool>& removed, std::vector<std::uint32_t>& to) {
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < removed.size(); ++i) to[i] = removed[i] ? none : next++;
}

template <class T>
void squeeze(std::vector<T>& list, const std::vector<bool>& removed) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (removed[i]) continue;
        if (kept != i) list[kept] = std::move(list[i]);
        ++kept;
    }
    list.resize(kept);
}

void spreadRemoval(const State& state, Removal& removal) {
    for (std::size_t i = 0; i < state.particles.size(); ++i)
        if (removal.bodies[state.particles.body[i]]) removal.particles[i] = true;
    for (std::size_t j = 0; j < state.joints.size(); ++j)
        if (removal.particles[state.joints.a[j]] || removal.particles[state.joints.b[j]])
            removal.joints[j] = true;
    for (std::size_t i = 0; i < state.attachments.size(); ++i) {
        const Attachment& held = state.attachments[i];
        bool gone = removal.particles[held.particle];
        for (std::uint32_t k = 0; k < held.count; ++k) gone |= removal.particles[held.support[k]];
        if (gone) removal.attachments[i] = true;
    }
}

/// After the handles of joints that go are forgotten.
void markAngles(const State& state, Removal& removal) {
    const Angles& angles = state.angles;
    const auto isGone = [&](JointId id) {
        return id != JointId{} && !state.jointSlots.contains(id);
    };
    for (std::size_t i = 0; i < angles.size(); ++i)
        if (removal.particles[angles.a[i]] || removal.particles[angles.b[i]] ||
            removal.particles[angles.c[i]] || isGone(angles.before[i]) || isGone(angles.after[i]))
            removal.angles[i] = true;
}

/// Bodies that lose particles or joints of their own have other rigid components now.
void markChangedBodies(State& state, const Removal& removal) {
    for (std::size_t i = 0; i < state.particles.size(); ++i)
        if (removal.particles[i]) state.bodies[state.particles.body[i]].clustersStale = true;
    for (std::size_t j = 0; j < state.joints.size(); ++j)
        if (removal.joints[j] && state.joints.body[j] != none)
            state.bodies[state.joints.body[j]].clustersStale = true;
}

void forgetHandles(State& state, const Removal& removal) {
    for (std::size_t i = 0; i < removal.particles.size(); ++i)
        if (removal.particles[i]) state.particleSlots.erase(state.particles.id[i]);
    for (std::size_t j = 0; j < removal.joints.size(); ++j)
        if (removal.joints[j]) state.jointSlots.erase(state.joints.id[j]);
    for (std::size_t i = 0; i < removal.attachments.size(); ++i)
        if (removal.attachments[i]) state.attachmentSlots.erase(state.attachments[i].id);
    for (std::size_t i = 0; i < removal.bodies.size(); ++i)
        if (removal.bodies[i]) state.bodySlots.erase(state.bodies[i].id);
    std::erase_if(state.vetoes, [&](const BodyPair& pair) {
        return !state.bodySlots.contains(pair.a) || !state.bodySlots.contains(pair.b);
    });
}

/// Whether a body that is tied to nothing is in no tree and leaves the lists by itself.
bool goesAlone(const State& state, std::uint32_t index) {
    const bool derived = !state.structure.stale ||
                         (state.structure.onlyAdded && index < state.structure.before.bodies);
    return !derived || isPlain(state, index);
}

/// Takes a body that is tied to nothing away and leaves a gap.
void retire(State& state, std::uint32_t index) {
    BodyRecord& body = state.bodies[index];
    if (goesAlone(state, index)) {
        const Range clusters = clustersOf(state, index);
        for (auto c = clusters.first; c < clusters.last; ++c) bringMembersOf(state, c);
        retireFromLists(state, index);
    } else if (isInTree(state, index)) {
        state.structure.changed();
    } else {
        state.work.changed();
    }
    forgetBody(state, index);
    state.idle = state.nearby.valid = false;
    for (const ParticleId id : body.particles) state.particleSlots.retire(id);
    for (const JointId id : body.joints) {
        const auto j = state.jointSlots.dense(id);
        state.joints.inCluster[j] = 1;  // nobody solves it
        state.joints.braced[j] = 0;
        state.jointSlots.retire(id);
    }
    const Range angles = anglesOf(state, index);
    for (auto i = angles.first; i < angles.last; ++i) state.angleSlots.retire(state.angles.id[i]);
    std::erase_if(state.vetoes,
                  [&](const BodyPair& pair) { return pair.a == body.id || pair.b == body.id; });
    state.idsHaveGaps = true;
    state.bodySlots.retire(body.id);
    BodyRecord gap;
    gap.id = body.id;
    gap.kind = BodyKind::fixed;
    gap.clustersStale = false;
    gap.firstParticle = body.firstParticle;
    gap.gone = static_cast<std::uint32_t>(body.particles.size());
    state.gone.bodies += 1;
    state.gone.particles += gap.gone;
    state.gone.joints += static_cast<std::uint32_t>(body.joints.size());
    body = std::move(gap);
    restoreInverseMass(state, index);
}

void squeezeBodies(State& state, const Removal& removal) {
    squeeze(state.bodies, removal.bodies);
    std::uint32_t first = 0;
    state.bodyIds.clear();
    state.idsHaveGaps = false;
    state.sensing.bodies.clear();
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) {
        BodyRecord& body = state.bodies[i];
        cutSkin(body,
                [&](std::size_t k) { return state.particleSlots.contains(body.particles[k]); });
        std::erase_if(body.particles,
                      [&](ParticleId id) { return !state.particleSlots.contains(id); });
        std::erase_if(body.joints, [&](JointId id) { return !state.jointSlots.contains(id); });
        body.firstParticle = first;
        first += static_cast<std::uint32_t>(body.particles.size());
        state.bodySlots.move(body.id, i);
        state.bodyIds.push_back(body.id);
        if (body.sensor && !body.disabled) state.sensing.bodies.push_back(i);
    }
}

void squeezeParticles(State& state, const Removal& removal) {
    state.particles.forEachArray([&](auto& list) { squeeze(list, removal.particles); });
    for (std::uint32_t i = 0; i < state.particles.size(); ++i) {
        state.particles.body[i] = removal.newBody[state.particles.body[i]];
        state.particleSlots.move(state.particles.id[i], i);
    }
}

void squeezeJoints(State& state, const Removal& removal) {
    Joints& joints = state.joints;
    joints.forEachArray([&](auto& list) { squeeze(list, removal.joints); });
    for (std::uint32_t j = 0; j < joints.size(); ++j) {
        if (joints.body[j] != none) joints.body[j] = removal.newBody[joints.body[j]];
        state.jointSlots.move(joints.id[j], j);
    }
}

void squeezeAngles(State& state, const Removal& removal) {
    Angles& angles = state.angles;
    for (std::size_t i = 0; i < angles.size(); ++i)
        if (removal.angles[i]) state.angleSlots.erase(angles.id[i]);
    angles.forEachArray([&](auto& list) { squeeze(list, removal.angles); });
    for (std::uint32_t i = 0; i < angles.size(); ++i) {
        angles.body[i] = removal.newBody[angles.body[i]];
        state.angleSlots.move(angles.id[i], i);
    }
}

void squeezeAttachments(State& state, const Removal& removal) {
    squeeze(state.attachments, removal.attachments);
    for (std::uint32_t i = 0; i < state.attachments.size(); ++i)
        state.attachmentSlots.move(state.attachments[i].id, i);
}

/// Clusters of bodies that changed are dropped; they are found again with the structure. The others
/// move towards the front.
void squeezeClusters(State& state, Removal& removal) {
    Clusters& clusters = state.clusters;
    std::uint32_t kept = 0, members = 0;
    for (std::uint32_t c = 0; c < clusters.list.size(); ++c) {
        Cluster cluster = clusters.list[c];
        removal.newCluster[c] = none;
        if (removal.bodies[cluster.body]) continue;
        cluster.body = removal.newBody[cluster.body];
        if (state.bodies[cluster.body].clustersStale) {
            const auto owner =
                removal.newBody[state.particles.body[clusters.members[cluster.first]]];
            if (owner != none) keepTurn(state.bodies[owner], cluster);
            continue;
        }
        const auto from = std::exchange(cluster.first, members);
        for (auto k = from; k < cluster.last; ++k, ++members) {
            clusters.members[members] = clusters.members[k];
            clusters.places[members] = clusters.places[k];
        }
        cluster.last = members;
        clusters.list[kept] = cluster;
        removal.newCluster[c] = kept++;
    }
    clusters.list.resize(kept);
    clusters.members.resize(members);
    clusters.places.resize(members);
    std::erase_if(clusters.hinges, [&](Hinge& hinge) {
        hinge.cluster = removal.newCluster[hinge.cluster];
        return hinge.cluster == none;
    });
    for (auto& cluster : state.particles.cluster)
        if (cluster != none) cluster = removal.newCluster[cluster];
}

}  // namespace

void renumberParticles(State& state, const std::vector<std::uint32_t>& newIndex) {
    const auto renumber = [&](std::uint32_t& i) {
        if (i != none) i = newIndex[i];
    };
    for (auto* ends :
         {&state.joints.a, &state.joints.b, &state.angles.a, &state.angles.b, &state.angles.c})
        std::for_each(ends->begin(), ends->end(), renumber);
    for (Attachment& held : state.attachments) {
        renumber(held.particle);
        std::for_each(held.support.begin(), held.support.end(), renumber);
    }
    std::for_each(state.clusters.members.begin(), state.clusters.members.end(), renumber);
    for (Hinge& hinge : state.clusters.hinges) renumber(hinge.particle);
    std::for_each(state.fresh.begin(), state.fresh.end(), renumber);
    std::erase(state.fresh, none);
}

void countTies(State& state) {
    for (BodyRecord& body : state.bodies) body.ties = 0;
    const auto tie = [&](std::uint32_t particle) {
        ++state.bodies[state.particles.body[particle]].ties;
    };
    const Joints& joints = state.joints;
    for (std::uint32_t j = 0; j < joints.size(); ++j)
        if (joints.body[j] == none)
            for (const auto end : {joints.a[j], joints.b[j]}) tie(end);
    for (const Attachment& held : state.attachments) {
        tie(held.particle);
        for (std::uint32_t k = 0; k < held.count; ++k) tie(held.support[k]);
    }
}

void compact(State& state, Removal& removal) {
    state.statistics.upkeep += state.particles.size() + state.joints.size() + state.bodies.size();
    for (std::size_t i = 0; i < removal.bodies.size(); ++i)
        if (state.bodies[i].gone > 0) removal.bodies[i] = true;
    state.gone = {};
    dissolveTrees(state);
    spreadRemoval(state, removal);
    state.core.listsStale = true;
    for (std::size_t i = 0; i < removal.bodies.size(); ++i)
        if (removal.bodies[i]) removeShape(state, state.bodies[i].id.index - 1);
    markChangedBodies(state, removal);
    forgetHandles(state, removal);
    markAngles(state, removal);
    renumber(removal.bodies, removal.newBody);
    renumber(removal.particles, removal.newParticle);
    const bool particlesGo = std::find(removal.particles.begin(), removal.particles.end(), true) !=
                             removal.particles.end();
    squeezeJoints(state, removal);
    squeezeAngles(state, removal);
    squeezeAttachments(state, removal);
    squeezeBodies(state, removal);
    squeezeClusters(state, removal);
    if (particlesGo) {
        state.triangles.bodies = 0;
        squeezeParticles(state, removal);
        renumberParticles(state, removal.newParticle);
    }
    countTies(state);
    updateReach(state);
    state.structure.changed();
    state.work.changed();  // its lists name what has moved
}

void makeRoomToCompact(State& state) {
    state.particleSlots.makeRoom(0);
    state.jointSlots.makeRoom(0);
    state.bodySlots.makeRoom(0);
    state.attachmentSlots.makeRoom(0);
    state.angleSlots.makeRoom(0);
    makeRoomFor(state.sensing.bodies, state.bodies.size());
    makeRoomFor(state.surface, state.particles.size());
}

void removeBody(State& state, std::uint32_t body) {
    const bool tied = state.bodies[body].ties > 0;
    const std::size_t gone = state.gone.particles + state.bodies[body].particles.size();
    const bool compacts = tied || 2 * gone >= state.particles.size();
    makeRoomToForget(state, state.bodies[body].id.index - 1);
    for (auto* ranges : {&state.work.awake, &state.work.points, &state.work.free})
        makeRoom(*ranges, 1);
    std::optional<Removal> removal;
    if (compacts) {
        makeRoomToCompact(state);
        removal.emplace(state);
    }
    // From here on nothing fails.
    if (compacts || !goesAlone(state, body)) bringMembers(state);
    wakeTouching(state, body);
    if (!tied) retire(state, body);
    if (!compacts) return;
    if (tied) removal->bodies[body] = true;
    compact(state, *removal);
}

}  // namespace sulfur::detail
