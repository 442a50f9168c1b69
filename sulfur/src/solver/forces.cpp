// Stage: forces of explicit elastic joints.
#include <cmath>

#include "kernels/joint_force.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

/// Hooke's law with a damper: the paper's equation (1), as a rule with the damper projected on the
/// joint, so that it brakes stretching but not rotation.
void addElasticForce(State& state, std::uint32_t j) {
    Joints& joints = state.joints;
    Particles& particles = state.particles;
    const auto a = joints.a[j], b = joints.b[j];
    const Vec2 apart = (particles.position[b] - particles.position[a]).cast<Real>();
    const Real length = apart.norm();
    if (length == 0) {
        joints.force[j] = 0;
        return;
    }
    const Vec2 direction = apart / length;
    Real pull = joints.explicitStiffness[j] * (length - joints.restLength[j]);
    Vec2 sideways(0, 0);
    if (joints.explicitDamping[j] > 0) {
        const Vec2 relative = (particles.velocity[b] - particles.velocity[a]).cast<Real>();
        const Real lengthening = direction.dot(relative);
        pull += joints.explicitDamping[j] * lengthening;
        if (state.settings.damper == Damper::full)
            sideways = joints.explicitDamping[j] * (relative - lengthening * direction);
    }
    joints.force[j] = pull;
    const Vec2 total = pull * direction + sideways;
    const Point force = total.cast<double>();
    particles.force[a] += force;
    particles.force[b] -= force;
}

ForceView viewOf(State& state) {
    Particles& p = state.particles;
    const ExplicitJoints& j = state.work.explicitBatches;
    return {p.position.data()->data(),
            p.velocity.data()->data(),
            p.force.data()->data(),
            state.joints.force.data(),
            j.joint.data(),
            j.a.data(),
            j.b.data(),
            j.rest.data(),
            j.stiffness.data(),
            j.damping.data()};
}

}  // namespace

void gatherForces(State& state) {
    const auto& list = state.work.explicitJoints;
    state.looked(Stage::forces, list.size());
    if (list.empty()) return;
    const ForceView view = viewOf(state);
    const bool full = state.settings.damper == Damper::full;
    for (const ForceBatch& batch : state.work.explicitBatches.batches) {
        if (!batch.wide || (full && batch.damped)) {
            for (auto k = batch.first; k < batch.last; ++k) addElasticForce(state, list[k]);
            continue;
        }
        const auto add = batch.damped ? forceKernels().damped : forceKernels().elastic;
        add(view, batch.place, batch.last - batch.first);
    }
}

}  // namespace sulfur::detail
