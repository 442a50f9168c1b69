#include "stability/stability_map.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "integrators/linear_theory.hpp"
#include "spring_system.hpp"

namespace sulfur::lab {

namespace {

/// The rope hanging straight down, each spring longer by the weight below it over k.
State hanging(const Rope& rope) {
    const RopeConstants& c = rope.constants();
    State state;
    double y = 0;
    for (std::size_t i = 0; i < rope.size(); ++i) {
        const double below = c.mass * c.gravity * static_cast<double>(rope.size() - i);
        y -= c.length + below / c.stiffness;
        state.x.emplace_back(0, y);
        state.v.emplace_back(0, 0);
    }
    return state;
}

/// One tick as a function of (x, h v), which are of one size.
class Tick {
public:
    Tick(const Rope& rope, const IntegratorEntry& entry, double h)
        : rope_(rope),
          integrator_(entry.make()),
          loose_({.inverseMass = std::vector<double>(rope.size(), 1.0), .springs = {}}),
          h_(h),
          rest_(hanging(rope)),
          d_(1e-5 * -rest_.x.back().y() / static_cast<double>(rope.size())) {}

    Eigen::Index size() const { return static_cast<Eigen::Index>(4 * rope_.size()); }

    /// The derivative of the tick by its variable `column`, by a central difference.
    Eigen::VectorXd derivative(Eigen::Index column) {
        return (after(column, d_) - after(column, -d_)) / (2 * d_);
    }

private:
    Eigen::VectorXd after(Eigen::Index column, double d) {
        State state = rest_;
        const auto particles = static_cast<Eigen::Index>(2 * rope_.size());
        const auto i = static_cast<std::size_t>(column % particles / 2);
        if (column < particles)
            state.x[i][column % 2] += d;
        else
            state.v[i][column % 2] += d / h_;
        // Without forces, Verlet takes x - h v for the place of the tick before.
        integrator_->begin(loose_, state, h_);
        integrator_->step(rope_, state, h_);
        Eigen::VectorXd result(size());
        for (std::size_t k = 0; k < rope_.size(); ++k) {
            const auto at = static_cast<Eigen::Index>(2 * k);
            result.segment<2>(at) = state.x[k] - rest_.x[k];
            result.segment<2>(particles + at) = h_ * state.v[k];
        }
        return result;
    }

    const Rope& rope_;
    std::unique_ptr<Integrator> integrator_;
    SpringSystem loose_;
    double h_;
    State rest_;
    double d_;  ///< m, small beside a spring
};

bool isStable(const RopeConstants& constants, const IntegratorEntry& entry, double rate) {
    const Rope rope(constants);
    Tick tick(rope, entry, 1 / rate);
    Eigen::MatrixXd map(tick.size(), tick.size());
    for (Eigen::Index column = 0; column < tick.size(); ++column)
        map.col(column) = tick.derivative(column);
    if (!map.allFinite()) return false;
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(map, false);
    // Differences are good to some 1e-10, eigenvalues next to 1 to a little less.
    constexpr double rounding = 3e-8;
    return solver.info() == Eigen::Success &&
           solver.eigenvalues().cwiseAbs().maxCoeff() <= 1 + rounding;
}

std::vector<double> equalRatios(double low, double high, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
    return values;
}

}  // namespace

HangingLimit hangingLimit(RopeConstants rope, const IntegratorEntry& entry, double rate,
                          double highest) {
    const auto stableAt = [&](double k) {
        rope.stiffness = k;
        return isStable(rope, entry, rate);
    };
    // Some methods have islands of stability far above their first limit; the first one counts.
    double low = 1, high = 2;
    if (!stableAt(low)) return {};
    while (stableAt(high)) {
        if (high >= highest) return {true, std::nullopt};
        low = high;
        high = std::min(2 * high, highest);
    }
    while (high / low > 1.02) {
        const double middle = std::sqrt(low * high);
        (stableAt(middle) ? low : high) = middle;
    }
    return {true, low};
}

StabilityMap measureStabilityMap(const IntegratorEntry& entry, const StabilityMapOptions& options) {
    StabilityMap map{entry.key, entry.title, entry.law, {}, {}, {}};
    map.rates = equalRatios(60, 10000, options.rates);
    map.dampings = {0};
    for (const double damping : equalRatios(0.01, 10, options.dampings - 1))
        map.dampings.push_back(damping);
    for (const double damping : map.dampings) {
        for (const double rate : map.rates) {
            RopeConstants rope = options.rope;
            rope.damping = damping;
            map.cells.push_back(
                {rate, damping, hangingLimit(rope, entry, rate, options.highest),
                 linearLimit(entry, {rope.mass, damping, 1 / rate}, options.highest)});
        }
    }
    return map;
}

}  // namespace sulfur::lab
