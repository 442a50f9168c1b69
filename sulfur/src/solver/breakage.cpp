// Stage: joints break that were loaded beyond their strength.
#include <cmath>

#include "solver/stages.hpp"
#include "world/split.hpp"

namespace sulfur::detail {

namespace {

JointBroken describe(const State& state, std::uint32_t j) {
    const Joints& joints = state.joints;
    JointBroken event;
    event.joint = joints.id[j];
    if (joints.body[j] != none) event.body = state.bodies[joints.body[j]].id;
    event.point =
        (state.particles.position[joints.a[j]] + state.particles.position[joints.b[j]]) / 2;
    event.force = std::abs(joints.force[j]);
    return event;
}

}  // namespace

void breakJoints(State& state) {
    state.events.jointsBroken.clear();
    state.events.bodiesSplit.clear();
    state.events.particlesLost.clear();
    const Joints& joints = state.joints;
    for (const auto j : state.work.breakableJoints)
        if (std::abs(joints.force[j]) > joints.strength[j])
            state.events.jointsBroken.push_back(describe(state, j));
    if (state.events.jointsBroken.empty()) return;
    Removal removal(state);
    std::vector<ParticleId> ends;
    for (const JointBroken& broken : state.events.jointsBroken) {
        const auto j = state.jointSlots.dense(broken.joint);
        removal.joints[j] = true;
        if (joints.body[j] == none) continue;
        ends.push_back(state.particles.id[joints.a[j]]);
        ends.push_back(state.particles.id[joints.b[j]]);
    }
    compact(state, removal);
    splitBodies(state, ends);
}

}  // namespace sulfur::detail
