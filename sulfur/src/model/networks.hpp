// Networks: what is tied together in loops, and is solved as a whole.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "core/block_factor.hpp"
#include "core/block_pattern.hpp"
#include "model/tree_links.hpp"

namespace sulfur::detail {

/// A link between two nodes of a network.
struct NetworkLink {
    LinkKind kind = LinkKind::joint;
    std::uint32_t link = none;          // index of the joint, attachment or hinge
    std::uint32_t here = 0, there = 0;  // nodes of its first and second end, from Tree::first
    LinkEnd atHere, atThere;
    std::array<double, 2> pushed{0, 0};  // N, in its last step, without what contacts have added

    template <class Archive>
    void archive(Archive& a) {
        a(kind);
        a(link);
        a(here);
        a(there);
        a(atHere);
        a(atThere);
        a(pushed[0]);
        a(pushed[1]);
    }
};

/// How a link enters the matrix that is factorised at present. Vectors are derivatives by the
/// place (x, y) and the angle of a node.
struct NetworkRow {
    using Vector = Eigen::Vector3d;
    std::array<Vector, 2> here{Vector::Zero(), Vector::Zero()};   // of its one or two constraints
    std::array<Vector, 2> there{Vector::Zero(), Vector::Zero()};  // at the second end
    std::array<double, 2> stiffness{0, 0};  // kg, inverse compliance; 0: no such row
    Vector acrossHere = Vector::Zero(), acrossThere = Vector::Zero();  // across the link
    double tension = 0;                  // kg, by which it resists being turned
    double turnHere = 0, turnThere = 0;  // kg m^2, by which its pull resists turning a node

    template <class Archive>
    void archive(Archive& a) {
        for (auto* ends : {&here, &there})
            for (Vector& v : *ends) a(v);
        a(stiffness[0]);
        a(stiffness[1]);
        a(acrossHere);
        a(acrossThere);
        a(tension);
        a(turnHere);
        a(turnThere);
    }
};

/// A contact that pushes on a point of a network, or on the capsule between two.
struct NetworkTouch {
    std::uint32_t network = none, touch = none;  // Tree::network, number of the touch
    std::uint32_t here = 0, there = none;        // nodes, from Tree::first
};

/// A contact as a row of the matrix: how the gap grows with the motion of one or two nodes.
struct PressedRow {
    std::uint32_t touch = none;
    std::uint32_t here = 0, there = none;
    Eigen::Vector3d alongHere = Eigen::Vector3d::Zero(), alongThere = Eigen::Vector3d::Zero();
    double stiffness = 0;          // kg
    double gap = 0;                // m, to become 0 before anything has moved
    double pressed = 0, best = 0;  // kg m, of this sweep
    double value = 0;              // m, and after a correction the change of what it presses
};

/// Work space of a sweep over a network. Vectors of three are places and angles of nodes.
struct NetworkSweep {
    std::vector<NetworkRow> rows;  // at the present places
    std::vector<PressedRow> contacts;
    std::vector<std::uint32_t> pressing;  // touches of these
    std::vector<Eigen::Vector3d> inverseMass, moved, bestMoved, residual, nodes;
    std::vector<std::array<double, 2>> lambda, bestLambda, wanted, values;  // of links
};

/// A system of equations of a network that is factorised.
struct NetworkSystem {
    BlockFactor<2> points;  // one of the two
    BlockFactor<3> bodies;

    template <int N>
    auto& factor() {
        if constexpr (N == 2)
            return points;
        else
            return bodies;
    }
    bool empty() const { return points.empty() && bodies.empty(); }
    std::size_t bytes() const { return points.bytes() + bodies.bytes(); }
};

/// What solves one network. It follows from the rows, so that no snapshot holds it.
struct NetworkFactor {
    BlockPattern pattern;
    NetworkSystem step;
    /// In the sweeps of a tick: with contacts that press, along the directions of their own time.
    NetworkSystem swept;
    std::vector<NetworkRow> rows;
    std::vector<std::uint32_t> pressing;  // touches that are in it
    std::uint64_t tick = 0;
    std::uint64_t work = 0;  // products of blocks, in the sweeps of this step
    bool waits = false;      // for the last sweep, because there is no work left
    /// Of each node: the sum of what the links have given in the sweeps, kg m and kg m^2.
    std::vector<Eigen::Vector3d> given;
};

}  // namespace sulfur::detail
