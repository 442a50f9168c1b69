// Stage: forces of explicit elastic joints.
#include <cmath>

#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

/// Hooke's law with a damper along the joint, the paper's equation (1) with the damper projected
/// on the joint, so that it brakes stretching but not rotation.
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
    const Real lengthening =
        direction.dot((particles.velocity[b] - particles.velocity[a]).cast<Real>());
    const Real pull = joints.explicitStiffness[j] * (length - joints.restLength[j]) +
                      joints.explicitDamping[j] * lengthening;
    joints.force[j] = pull;
    const Point force = (pull * direction).cast<double>();
    particles.force[a] += force;
    particles.force[b] -= force;
}

}  // namespace

void gatherForces(State& state) {
    for (const auto j : state.work.explicitJoints) addElasticForce(state, j);
}

}  // namespace sulfur::detail
