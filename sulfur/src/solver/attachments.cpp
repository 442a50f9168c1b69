// Attachments: a particle held at a weighted mean of others.
#include "solver/constraint_kinds.hpp"

namespace sulfur::detail {

namespace {

/// C = x_p - sum of weight_i x_i = 0 in both axes at once; the gradients are 1 and -weight_i.
void solve(Particles& particles, const Attachment& held) {
    const auto p = held.particle;
    const auto& w = particles.inverseMass;
    Vec2 error = particles.displacement[p];
    Real sum = w[p];
    for (std::uint32_t k = 0; k < held.count; ++k) {
        const auto i = held.support[k];
        const Vec2 apart = (particles.position[p] - particles.position[i]).cast<Real>();
        error += held.weight[k] * (apart - particles.displacement[i]);
        sum += held.weight[k] * held.weight[k] * w[i];
    }
    if (sum == 0) return;
    const Vec2 impulse = -error / sum;
    particles.displacement[p] += w[p] * impulse;
    for (std::uint32_t k = 0; k < held.count; ++k)
        particles.displacement[held.support[k]] -= held.weight[k] * w[held.support[k]] * impulse;
}

}  // namespace

void solveAttachments(State& state) {
    for (const auto i : state.work.attachments) solve(state.particles, state.attachments[i]);
}

}  // namespace sulfur::detail
