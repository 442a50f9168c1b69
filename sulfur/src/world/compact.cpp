// Removing things and closing the gaps that they leave.
#include <algorithm>

#include "trees/tree_solver.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

namespace {

/// New index of each old one, or none.
std::vector<std::uint32_t> renumber(const std::vector<bool>& removed) {
    std::vector<std::uint32_t> to(removed.size(), none);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < removed.size(); ++i)
        if (!removed[i]) to[i] = next++;
    return to;
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
}

void squeezeBodies(State& state, const Removal& removal) {
    squeeze(state.bodies, removal.bodies);
    std::uint32_t first = 0;
    state.bodyIds.clear();
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) {
        BodyRecord& body = state.bodies[i];
        std::erase_if(body.particles,
                      [&](ParticleId id) { return !state.particleSlots.contains(id); });
        std::erase_if(body.joints, [&](JointId id) { return !state.jointSlots.contains(id); });
        body.firstParticle = first;
        first += static_cast<std::uint32_t>(body.particles.size());
        state.bodySlots.move(body.id, i);
        state.bodyIds.push_back(body.id);
    }
}

void squeezeParticles(State& state, const Removal& removal,
                      const std::vector<std::uint32_t>& newBody) {
    state.particles.forEachArray([&](auto& list) { squeeze(list, removal.particles); });
    for (std::uint32_t i = 0; i < state.particles.size(); ++i) {
        state.particles.body[i] = newBody[state.particles.body[i]];
        state.particleSlots.move(state.particles.id[i], i);
    }
}

void squeezeJoints(State& state, const Removal& removal, const std::vector<std::uint32_t>& newBody,
                   const std::vector<std::uint32_t>& newParticle) {
    Joints& joints = state.joints;
    joints.forEachArray([&](auto& list) { squeeze(list, removal.joints); });
    for (std::uint32_t j = 0; j < joints.size(); ++j) {
        joints.a[j] = newParticle[joints.a[j]];
        joints.b[j] = newParticle[joints.b[j]];
        if (joints.body[j] != none) joints.body[j] = newBody[joints.body[j]];
        state.jointSlots.move(joints.id[j], j);
    }
}

/// Clusters of bodies that changed are dropped; they are found again with the structure.
void squeezeClusters(State& state, const Removal& removal,
                     const std::vector<std::uint32_t>& newBody,
                     const std::vector<std::uint32_t>& newParticle) {
    const Clusters before = std::move(state.clusters);
    state.clusters = {};
    Clusters& after = state.clusters;
    std::vector<std::uint32_t> newCluster(before.list.size(), none);
    for (std::uint32_t c = 0; c < before.list.size(); ++c) {
        Cluster cluster = before.list[c];
        if (removal.bodies[cluster.body]) continue;
        cluster.body = newBody[cluster.body];
        if (state.bodies[cluster.body].clustersStale) continue;
        const auto first = static_cast<std::uint32_t>(after.members.size());
        for (auto k = cluster.first; k < cluster.last; ++k) {
            after.members.push_back(newParticle[before.members[k]]);
            after.places.push_back(before.places[k]);
        }
        cluster.first = first;
        cluster.last = static_cast<std::uint32_t>(after.members.size());
        newCluster[c] = static_cast<std::uint32_t>(after.list.size());
        after.list.push_back(cluster);
    }
    for (const Hinge& hinge : before.hinges)
        if (newCluster[hinge.cluster] != none)
            after.hinges.push_back(
                {newCluster[hinge.cluster], newParticle[hinge.particle], hinge.place});
    for (auto& cluster : state.particles.cluster)
        if (cluster != none) cluster = newCluster[cluster];
}

void squeezeContactMemory(State& state, const std::vector<std::uint32_t>& newParticle) {
    for (ContactMemory& m : state.contactMemory)
        for (auto* p : {&m.particle, &m.a, &m.b}) *p = newParticle[*p];
    std::erase_if(state.contactMemory, [](const ContactMemory& m) {
        return m.particle == none || m.a == none || m.b == none;
    });
}

void squeezeAttachments(State& state, const Removal& removal,
                        const std::vector<std::uint32_t>& newParticle) {
    squeeze(state.attachments, removal.attachments);
    for (std::uint32_t i = 0; i < state.attachments.size(); ++i) {
        Attachment& held = state.attachments[i];
        held.particle = newParticle[held.particle];
        for (std::uint32_t k = 0; k < held.count; ++k)
            held.support[k] = newParticle[held.support[k]];
        state.attachmentSlots.move(held.id, i);
    }
}

}  // namespace

void compact(State& state, Removal& removal) {
    dissolveTrees(state);
    spreadRemoval(state, removal);
    markChangedBodies(state, removal);
    forgetHandles(state, removal);
    const auto newBody = renumber(removal.bodies);
    const auto newParticle = renumber(removal.particles);
    const bool particlesGo = std::find(removal.particles.begin(), removal.particles.end(), true) !=
                             removal.particles.end();
    if (particlesGo) {
        squeezeParticles(state, removal, newBody);
        for (auto& i : state.fresh) i = newParticle[i];
        std::erase(state.fresh, none);
        state.contacts.clear();
        squeezeContactMemory(state, newParticle);
    }
    squeezeJoints(state, removal, newBody, newParticle);
    squeezeAttachments(state, removal, newParticle);
    squeezeBodies(state, removal);
    squeezeClusters(state, removal, newBody, newParticle);
    state.structure.stale = true;
    state.broad.collidersStale = true;
}

}  // namespace sulfur::detail
