// Attachments and hinges that no tree has taken: a place of one thing held at a place of another.
#include <array>
#include <cmath>

#include "rigid/grip.hpp"
#include "solver/constraint_kinds.hpp"

namespace sulfur::detail {

namespace {

using Matrix2 = Eigen::Matrix<Real, 2, 2>;

/// The impulse that closes the gap `error`, when the two places answer with `mobility` together.
Vec2 closing(const Matrix2& mobility, const Vec2& error) {
    const Real determinant = mobility(0, 0) * mobility(1, 1) - mobility(0, 1) * mobility(1, 0);
    const Real scale = mobility(0, 0) + mobility(1, 1);
    if (!(determinant > Real(1e-6) * scale * scale))  // one of the directions is blocked
        return scale > 0 ? Vec2(-error / scale) : Vec2(0, 0);
    const Matrix2 adjugate{{mobility(1, 1), -mobility(0, 1)}, {-mobility(1, 0), mobility(0, 0)}};
    return -(adjugate * error) / determinant;
}

/// C = x_p - sum of weight_i x_i = 0 in both axes at once; the gradients are 1 and -weight_i.
/// Supports in one rigid component are one grip.
struct Hold {
    Hold(const State& state, const Attachment& held) {
        add(gripOf(state, held.particle), 1);
        for (std::uint32_t k = 0; k < held.count; ++k)
            add(gripOf(state, held.support[k]), -held.weight[k]);
        for (std::uint32_t k = 0; k < held.count; ++k) {
            const Vec2 apart = (state.particles.position[held.particle] -
                                state.particles.position[held.support[k]])
                                   .cast<Real>();
            error += held.weight[k] * apart;
        }
    }

    void add(Grip grip, Real weight) {
        for (std::size_t k = 1; k < count; ++k) {
            if (grip.cluster == none || grips[k].cluster != grip.cluster) continue;
            if (std::abs(weights[k] + weight) < Real(1e-3)) continue;
            // A grip of weight 1 at the weighted arm; the weights of a component add up.
            grips[k].arm = (weights[k] * grips[k].arm + weight * grip.arm) / (weights[k] + weight);
            weights[k] += weight;
            return;
        }
        grips[count] = grip;
        weights[count++] = weight;
    }

    std::array<Grip, 4> grips;
    std::array<Real, 4> weights{0, 0, 0, 0};
    std::size_t count = 0;
    Vec2 error{0, 0};
};

void solve(State& state, const Attachment& held) {
    Hold hold(state, held);
    Matrix2 mobility = Matrix2::Zero();
    for (std::size_t k = 0; k < hold.count; ++k) {
        hold.error += hold.weights[k] * displacementOf(state, hold.grips[k]);
        mobility += hold.weights[k] * hold.weights[k] * mobilityOf(state, hold.grips[k]);
    }
    const Vec2 impulse = closing(mobility, hold.error);
    for (std::size_t k = 0; k < hold.count; ++k)
        push(state, hold.grips[k], hold.weights[k] * impulse);
}

void solve(State& state, const Hinge& hinge) {
    const Cluster& c = state.clusters.list[hinge.cluster];
    const Point arm = turned(c.heading, hinge.place);
    const Grip here{none, hinge.cluster, arm.cast<Real>()};
    const Grip there = gripOf(state, hinge.particle);
    const Vec2 error = (c.centre + arm - state.particles.position[hinge.particle]).cast<Real>() +
                       displacementOf(state, here) - displacementOf(state, there);
    const Vec2 impulse = closing(mobilityOf(state, here) + mobilityOf(state, there), error);
    push(state, here, impulse);
    push(state, there, -impulse);
}

}  // namespace

void solveAttachments(State& state) {
    for (const auto i : state.work.attachments) solve(state, state.attachments[i]);
    for (const auto i : state.work.hinges) solve(state, state.clusters.hinges[i]);
}

}  // namespace sulfur::detail
