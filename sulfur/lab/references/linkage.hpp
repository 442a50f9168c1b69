// Links whose vectors add up to the places of nodes, as exactly as one can afford.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "integrators/system.hpp"

namespace sulfur::lab {

/// Node i is at the origin plus the sum over all links k of reach(i, k) times the unit vector at
/// the angle of k. Chains are such linkages, and so are nets of parallelograms: a node's place is
/// that of its column in the first row plus that of its row in the first column.
struct LinkagePlan {
    Eigen::MatrixXd reach;   ///< m, a row for each node, a column for each link
    Eigen::VectorXd masses;  ///< kg, of the nodes
    Eigen::Index held = 0;   ///< a node that stays where it starts, as the origin does
    double gravity = 9.81;   ///< m/s^2, downwards
};

/// How a linkage lies and moves.
struct LinkageState {
    Eigen::VectorXd angles;  ///< rad, of the links
    Eigen::VectorXd rates;   ///< rad/s
};

/// Lagrange's equations for the angles, with the force on the held node as their multiplier, under
/// the classical Runge-Kutta method, in double. Links keep their lengths exactly, whatever the
/// step, and the method knows nothing of the library's.
class LinkageReference {
public:
    explicit LinkageReference(LinkagePlan plan);

    void step(LinkageState& state, double h) const;
    /// Places and velocities of all nodes.
    State nodes(const LinkageState& state) const;
    /// The rates that are nearest to `velocities` (m/s, of the nodes), with masses as weights: how
    /// it moves after that has struck it.
    Eigen::VectorXd struck(const Eigen::VectorXd& angles, const Vecs& velocities) const;

private:
    Eigen::VectorXd accelerations(const LinkageState& state) const;
    /// The change r of rates for which M r answers `push` and the held node changes by `held`.
    Eigen::VectorXd solve(const Eigen::VectorXd& angles, const Eigen::VectorXd& push,
                          const Vec& held) const;

    LinkagePlan plan_;
    Eigen::MatrixXd weights_;  ///< kg m^2, the mass that two links carry both
    Eigen::VectorXd moments_;  ///< kg m, the mass that a link carries
};

/// Where the nodes of a linkage are at interval, 2 interval, ...
struct LinkagePath {
    std::vector<Vecs> places;  ///< m, of all nodes
    double error = 0;          ///< m: largest distance of the watched node from where steps twice
                               ///< as long put it
    double step = 0;           ///< s, of the method
};

/// Halves the steps, from `interval` on, until the path of the node `watched` changes by less than
/// `tolerance` metres, or `most` steps an interval are reached.
LinkagePath convergedPath(const LinkageReference& linkage, const LinkageState& start,
                          double interval, int intervals, std::size_t watched, double tolerance,
                          int most);

}  // namespace sulfur::lab
