#include "references/linkage.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

namespace sulfur::lab {

namespace {

/// Columns of unit vectors at these angles.
Eigen::Matrix2Xd directions(const Eigen::VectorXd& angles) {
    Eigen::Matrix2Xd along(2, angles.size());
    along.row(0) = angles.array().cos().transpose();
    along.row(1) = angles.array().sin().transpose();
    return along;
}

/// The same, turned to the left by a right angle.
Eigen::Matrix2Xd turned(const Eigen::Matrix2Xd& along) {
    Eigen::Matrix2Xd across(2, along.cols());
    across.row(0) = -along.row(1);
    across.row(1) = along.row(0);
    return across;
}

}  // namespace

LinkageReference::LinkageReference(LinkagePlan plan)
    : plan_(std::move(plan)),
      weights_(plan_.reach.transpose() * plan_.masses.asDiagonal() * plan_.reach),
      moments_(plan_.reach.transpose() * plan_.masses) {}

Eigen::VectorXd LinkageReference::solve(const Eigen::VectorXd& angles, const Eigen::VectorXd& push,
                                        const Vec& held) const {
    const Eigen::Matrix2Xd along = directions(angles);
    const Eigen::MatrixXd mass = weights_.cwiseProduct(along.transpose() * along);
    const Eigen::MatrixX2d hold =
        (turned(along) * plan_.reach.row(plan_.held).asDiagonal()).transpose();
    const Eigen::LLT<Eigen::MatrixXd> factor(mass);
    const Eigen::VectorXd free = factor.solve(push);
    const Eigen::MatrixX2d answer = factor.solve(hold);
    const Mat response = hold.transpose() * answer;
    const Vec force = response.inverse() * (held - hold.transpose() * free);
    return free + answer * force;
}

// With the unit vectors u_k, which turn towards t_k, the nodes accelerate by the sum of
// reach_ik (r'_k t_k - r_k^2 u_k). Projected on t_k, with t_k . u_l = sin(angle_l - angle_k).
Eigen::VectorXd LinkageReference::accelerations(const LinkageState& state) const {
    const Eigen::Matrix2Xd along = directions(state.angles), across = turned(along);
    const Eigen::VectorXd squares = state.rates.array().square();
    const Eigen::VectorXd push = weights_.cwiseProduct(across.transpose() * along) * squares -
                                 plan_.gravity * moments_.cwiseProduct(across.row(1).transpose());
    const Eigen::VectorXd pulls = plan_.reach.row(plan_.held).transpose().cwiseProduct(squares);
    return solve(state.angles, push, along * pulls);
}

void LinkageReference::step(LinkageState& state, double h) const {
    const auto at = [&](const LinkageState& slope, double reach) {
        return LinkageState{state.angles + reach * slope.angles, state.rates + reach * slope.rates};
    };
    const auto slopeAt = [&](const LinkageState& s) {
        return LinkageState{s.rates, accelerations(s)};
    };
    const LinkageState a = slopeAt(state), b = slopeAt(at(a, h / 2)), c = slopeAt(at(b, h / 2)),
                       d = slopeAt(at(c, h));
    state.angles += h / 6 * (a.angles + 2 * b.angles + 2 * c.angles + d.angles);
    state.rates += h / 6 * (a.rates + 2 * b.rates + 2 * c.rates + d.rates);
}

State LinkageReference::nodes(const LinkageState& state) const {
    const Eigen::Matrix2Xd along = directions(state.angles);
    const Eigen::Matrix2Xd x = along * plan_.reach.transpose();
    const Eigen::Matrix2Xd v = turned(along) * state.rates.asDiagonal() * plan_.reach.transpose();
    State nodes;
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
        nodes.x.emplace_back(x.col(i));
        nodes.v.emplace_back(v.col(i));
    }
    return nodes;
}

Eigen::VectorXd LinkageReference::struck(const Eigen::VectorXd& angles,
                                         const Vecs& velocities) const {
    Eigen::Matrix2Xd momenta(2, plan_.masses.size());
    for (Eigen::Index i = 0; i < momenta.cols(); ++i)
        momenta.col(i) = plan_.masses[i] * velocities[static_cast<std::size_t>(i)];
    const Eigen::Matrix2Xd across = turned(directions(angles)), carried = momenta * plan_.reach;
    return solve(angles, across.cwiseProduct(carried).colwise().sum().transpose(), Vec::Zero());
}

LinkagePath convergedPath(const LinkageReference& linkage, const LinkageState& start,
                          double interval, int intervals, std::size_t watched, double tolerance,
                          int most) {
    const auto follow = [&](int steps) {
        std::vector<Vecs> places;
        LinkageState state = start;
        for (int n = 0; n < intervals; ++n) {
            for (int s = 0; s < steps; ++s) linkage.step(state, interval / steps);
            places.push_back(linkage.nodes(state).x);
        }
        return places;
    };
    int steps = 16;
    LinkagePath found{follow(steps), 0, 0};
    while (true) {
        steps *= 2;
        auto finer = follow(steps);
        found.error = 0;
        for (std::size_t n = 0; n < finer.size(); ++n) {
            const double distance = (finer[n][watched] - found.places[n][watched]).norm();
            found.error = distance <= found.error ? found.error : distance;  // keeps NaN
        }
        found.places = std::move(finer);
        found.step = interval / steps;
        if (found.error < tolerance || 2 * steps > most) return found;
    }
}

}  // namespace sulfur::lab
