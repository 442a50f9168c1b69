#include "references/chain.hpp"

#include <algorithm>

namespace sulfur::lab {

// With r_i from particle i - 1 to i, tension_i the rod's force divided by its length and w = 1 / m,
// a_i = g + w_i (tension_{i+1} r_{i+1} - tension_i r_i), and a rod keeps its length when
// r_i . (a_i - a_{i-1}) = -|v_i - v_{i-1}|^2. That is tridiagonal in the tensions.
void ChainReference::accelerations(const State& state, Vecs& out) {
    const std::size_t n = plan_.lengths.size();
    const Vec gravity(0, -plan_.gravity);
    rods_.resize(n);
    for (auto* v : {&diagonal_, &upper_, &tension_}) v->resize(n);
    for (std::size_t i = 0; i < n; ++i)
        rods_[i] = i == 0 ? state.x[0] : Vec(state.x[i] - state.x[i - 1]);
    for (std::size_t i = 0; i < n; ++i) {
        const double w = 1 / plan_.masses[i], before = i == 0 ? 0 : 1 / plan_.masses[i - 1];
        const Vec speed = i == 0 ? state.v[0] : Vec(state.v[i] - state.v[i - 1]);
        diagonal_[i] = rods_[i].squaredNorm() * (w + before);
        upper_[i] = i + 1 < n ? -w * rods_[i].dot(rods_[i + 1]) : 0;
        tension_[i] = speed.squaredNorm() + (i == 0 ? rods_[0].dot(gravity) : 0);
        if (i == 0) continue;
        const double factor = upper_[i - 1] / diagonal_[i - 1];  // The matrix is symmetric.
        diagonal_[i] -= factor * upper_[i - 1];
        tension_[i] -= factor * tension_[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        if (i + 1 < n) tension_[i] -= upper_[i] * tension_[i + 1];
        tension_[i] /= diagonal_[i];
    }
    out.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        Vec force = -tension_[i] * rods_[i];
        if (i + 1 < n) force += tension_[i + 1] * rods_[i + 1];
        out[i] = gravity + force / plan_.masses[i];
    }
}

void ChainReference::step(double h) {
    constexpr double reach[] = {0.5, 0.5, 1}, weight[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    const std::size_t n = state_.x.size();
    stage_ = state_;
    sumX_.assign(n, Vec::Zero());
    sumV_.assign(n, Vec::Zero());
    for (int s = 0; s < 4; ++s) {
        accelerations(stage_, a_);
        for (std::size_t i = 0; i < n; ++i) {
            sumX_[i] += weight[s] * stage_.v[i];
            sumV_[i] += weight[s] * a_[i];
            if (s == 3) continue;
            stage_.x[i] = state_.x[i] + h * reach[s] * stage_.v[i];
            stage_.v[i] = state_.v[i] + h * reach[s] * a_[i];
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        state_.x[i] += h * sumX_[i];
        state_.v[i] += h * sumV_[i];
    }
}

namespace {

std::vector<State> path(const ChainPlan& plan, const State& start, double interval,
                        std::size_t intervals, int steps) {
    ChainReference chain(plan, start);
    std::vector<State> states{start};
    for (std::size_t i = 0; i < intervals; ++i) {
        for (int s = 0; s < steps; ++s) chain.step(interval / steps);
        states.push_back(chain.state());
    }
    return states;
}

double difference(const std::vector<State>& a, const std::vector<State>& b) {
    double largest = 0;
    for (std::size_t n = 0; n < a.size(); ++n) {
        const double distance = (a[n].x.back() - b[n].x.back()).norm();
        largest = distance <= largest ? largest : distance;  // keeps NaN
    }
    return largest;
}

}  // namespace

ChainPath convergedPath(const ChainPlan& plan, const State& start, double interval,
                        std::size_t intervals, double tolerance, int most) {
    int steps = 4;
    ChainPath found{path(plan, start, interval, intervals, steps), 0, 0};
    while (true) {
        steps *= 2;
        auto finer = path(plan, start, interval, intervals, steps);
        found.error = difference(found.states, finer);
        found.states = std::move(finer);
        found.step = interval / steps;
        if (found.error < tolerance || 2 * steps > most) return found;
    }
}

}  // namespace sulfur::lab
