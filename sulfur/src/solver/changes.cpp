// Stage 1: what is derived from bodies and joints follows their changes.
#include <algorithm>

#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

bool anyAwake(const State& state, std::uint32_t a, std::uint32_t b) {
    const auto& body = state.particles.body;
    return state.movable(body[a]) || state.movable(body[b]);
}

void listAwakeParticles(State& state) {
    WorkLists& work = state.work;
    work.awake.clear();
    work.awakeParticles = 0;
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) {
        if (!state.movable(i)) continue;
        const BodyRecord& body = state.bodies[i];
        const auto size = static_cast<std::uint32_t>(body.particles.size());
        work.awakeParticles += size;
        if (!work.awake.empty() && work.awake.back().last == body.firstParticle)
            work.awake.back().last += size;
        else
            work.awake.push_back({body.firstParticle, body.firstParticle + size});
    }
}

void listJoints(State& state) {
    WorkLists& work = state.work;
    const Joints& joints = state.joints;
    const auto& w = state.particles.inverseMass;
    for (auto* list :
         {&work.explicitJoints, &work.implicitJoints, &work.rigidJoints, &work.breakableJoints})
        list->clear();
    for (std::uint32_t j = 0; j < joints.size(); ++j) {
        if (!anyAwake(state, joints.a[j], joints.b[j])) continue;
        if (w[joints.a[j]] == 0 && w[joints.b[j]] == 0) continue;
        switch (joints.kind[j]) {
            case JointKind::explicitElastic:
                work.explicitJoints.push_back(j);
                break;
            case JointKind::implicitElastic:
                work.implicitJoints.push_back(j);
                break;
            case JointKind::rigid:
                work.rigidJoints.push_back(j);
                break;
        }
        if (joints.strength[j] != infinite) work.breakableJoints.push_back(j);
    }
}

void listAttachments(State& state) {
    state.work.attachments.clear();
    for (std::uint32_t i = 0; i < state.attachments.size(); ++i) {
        const Attachment& held = state.attachments[i];
        if (anyAwake(state, held.particle, held.support[0])) state.work.attachments.push_back(i);
    }
}

}  // namespace

void applyChanges(State& state) {
    if (!state.work.stale) return;
    classifyJoints(state);
    listAwakeParticles(state);
    listJoints(state);
    listAttachments(state);
    state.work.stale = false;

    Statistics& statistics = state.statistics;
    statistics.particles = static_cast<std::uint32_t>(state.particles.size());
    statistics.joints = static_cast<std::uint32_t>(state.joints.size());
    statistics.bodies = static_cast<std::uint32_t>(state.bodies.size());
    statistics.awakeParticles = state.work.awakeParticles;
    statistics.explicitJoints = static_cast<std::uint32_t>(state.work.explicitJoints.size());
    statistics.implicitJoints = static_cast<std::uint32_t>(state.work.implicitJoints.size());
    statistics.rigidJoints = static_cast<std::uint32_t>(state.work.rigidJoints.size());
}

}  // namespace sulfur::detail
