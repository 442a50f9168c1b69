// How each joint is solved, derived from stiffness, masses and the tick.
#include <algorithm>

#include "world/state.hpp"

namespace sulfur::detail {

namespace {

/// An explicit spring network is stable with NSV while h^2 w_max + 2 h b_max < 4, where the
/// highest eigenvalue is bounded by Gershgorin's circles: for each particle, the sum over its
/// joints of k (w_i + w_j) and b (w_i + w_j). 3.2 leaves room for geometric stiffness.
constexpr Real explicitLimit = Real(3.2);

/// Beyond, rounding is larger than the stretch under any force: as good as rigid.
constexpr Real maxStiffness = Real(1e15);

}  // namespace

void classifyJoints(State& state) {
    Joints& joints = state.joints;
    const auto& w = state.particles.inverseMass;
    const Real h = state.h;
    std::vector<Real> load(state.particles.size(), 0);
    for (std::size_t j = 0; j < joints.size(); ++j) {
        if (joints.stiffness[j] > maxStiffness) continue;
        const Real sum = w[joints.a[j]] + w[joints.b[j]];
        const Real one = (h * h * joints.stiffness[j] + 2 * h * joints.damping[j]) * sum;
        load[joints.a[j]] += one;
        load[joints.b[j]] += one;
    }
    for (std::size_t j = 0; j < joints.size(); ++j) {
        if (joints.stiffness[j] > maxStiffness)
            joints.kind[j] = JointKind::rigid;
        else if (load[joints.a[j]] <= explicitLimit && load[joints.b[j]] <= explicitLimit)
            joints.kind[j] = JointKind::explicitElastic;
        else
            joints.kind[j] = JointKind::implicitElastic;
    }
}

void updateReach(State& state) {
    Particles& particles = state.particles;
    particles.reach = particles.radius;
    const Joints& joints = state.joints;
    for (std::size_t j = 0; j < joints.size(); ++j)
        for (const auto p : {joints.a[j], joints.b[j]})
            particles.reach[p] = std::max(particles.reach[p], joints.radius[j]);
}

}  // namespace sulfur::detail
