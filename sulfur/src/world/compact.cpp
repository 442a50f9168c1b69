// Removing things and closing the gaps that they leave.
#include <algorithm>

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
    spreadRemoval(state, removal);
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
    }
    squeezeJoints(state, removal, newBody, newParticle);
    squeezeAttachments(state, removal, newParticle);
    squeezeBodies(state, removal);
    state.work.stale = true;
    state.broad.collidersStale = true;
}

}  // namespace sulfur::detail
