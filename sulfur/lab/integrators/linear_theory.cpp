#include "integrators/linear_theory.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sulfur::lab {

namespace {

/// One mode of a chain, seen from one of its particles: its own two springs pull it back with 2 k,
/// its neighbours, which are (1 - mu / 2) times where it is, pull it along.
class Mode final : public System {
public:
    Mode(const ChainConstants& chain, double stiffness, double mu)
        : k_(stiffness / chain.mass), b_(chain.damping / chain.mass), mu_(mu) {}

    std::size_t size() const override { return 1; }
    Vec acceleration(std::size_t, const Vec& x, const Vec& v, const State& others) const override {
        return -2 * (k_ * x + b_ * v) + (2 - mu_) * (k_ * others.x[0] + b_ * others.v[0]);
    }
    void accelerations(const State& state, Vecs& out) const override {
        out.assign(1, -mu_ * (k_ * state.x[0] + b_ * state.v[0]));
    }
    void jacobian(const State&, Jacobian& out) const override {
        out.blocks = {{0, 0, -mu_ * k_ * Mat::Identity(), -mu_ * b_ * Mat::Identity()}};
    }

private:
    double k_, b_, mu_;
};

/// Spectral radius of the step, which is a linear map of (x, v).
double growth(const IntegratorEntry& entry, const Mode& mode, double h) {
    const auto column = [&](double x, double v) {
        auto integrator = entry.make();
        State state{{Vec(x, 0)}, {Vec(v, 0)}};
        // Without forces, Verlet takes x(t) - h v for the place of the tick before: its state is
        // then (x, v) too, with the mean velocity of the last tick.
        integrator->begin(Mode({.damping = 0}, 0, 0), state, h);
        integrator->step(mode, state, h);
        return Vec(state.x[0].x(), state.v[0].x());
    };
    Mat map;
    map.col(0) = column(1, 0);
    map.col(1) = column(0, 1);
    const double half = map.trace() / 2, det = map.determinant();
    const double root = half * half - det;
    return root < 0 ? std::sqrt(det) : std::abs(half) + std::sqrt(root);
}

bool isStable(const IntegratorEntry& entry, const ChainConstants& chain, double stiffness) {
    constexpr int modes = 64;
    for (int j = 1; j <= modes; ++j) {
        const double sine = std::sin(std::numbers::pi / 2 * j / modes);
        const Mode mode(chain, stiffness, 4 * sine * sine);
        if (!(growth(entry, mode, chain.duration) <= 1 + 1e-9)) return false;
    }
    return true;
}

}  // namespace

std::optional<double> linearLimit(const IntegratorEntry& entry, const ChainConstants& chain,
                                  double highest) {
    double stable = 0, unstable = 0.1;
    while (isStable(entry, chain, unstable)) {
        stable = unstable;
        unstable *= 1.25;
        if (stable >= highest) return std::nullopt;
    }
    for (int i = 0; i < 40; ++i) {
        const double middle = (stable + unstable) / 2;
        (isStable(entry, chain, middle) ? stable : unstable) = middle;
    }
    return stable;
}

}  // namespace sulfur::lab
