// Networks: what is tied together in loops, and is solved as a whole.
#pragma once

#include <Eigen/Core>
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
    std::array<double, 2> swept{0, 0};   // N, what these have, in the last sweeps

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
        a(swept[0]);
        a(swept[1]);
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

/// A contact that pushes on points of a network.
struct NetworkTouch {
    std::uint32_t group = none, touch = none;  // Trees::networkGroups, number of the touch
    /// Of its corner and of the ends of its side: the network, or none, and the node from its
    /// Tree::first.
    std::array<std::uint32_t, 3> trees{none, none, none}, nodes{none, none, none};
    Real pressing = 0;  // kg m, when the step begins
};

/// Effective masses of the row of a touch, kg.
struct TouchMasses {
    Real normal = 0, tangent = 0;
};

/// A contact of a network, or its friction: how its gap or slide grows with the motion of up to
/// three nodes and other movers, those of its corner and of the ends of its side.
struct PressedRow {
    using Vector = Eigen::Vector3d;
    std::uint32_t touch = none;
    std::array<std::uint32_t, 3> members{none, none, none};  // NetworkSweep::members
    std::array<std::uint32_t, 3> nodes{none, none, none};    // of these
    std::array<std::uint32_t, 3> bodies{none, none, none};   // NetworkSweep::bodies
    std::array<Vector, 3> along{Vector::Zero(), Vector::Zero(), Vector::Zero()};  // of either
    double value = 0;                          // m, gap or slide before anything has moved
    double overlap = 0;                        // m, when the step began, beyond what stays
    double before = 0;                         // kg m, that it pressed before this sweep
    double pressed = 0, best = 0, change = 0;  // kg m, of this sweep, and of a pass
    std::uint32_t normal = none;               // of friction: the row that presses
    double hold = 0, brake = 0;                // of friction: its coefficients
};

/// A mover that presses on a network and is no node of it.
struct PressingBody {
    using Vector = Eigen::Vector3d;
    std::uint32_t mover = none;
    Vector inverseMass = Vector::Zero();
    Vector moved = Vector::Zero();  // in these passes
};

/// Work space of a sweep over a network. Vectors of three are places and angles of nodes.
struct NetworkMember {
    std::vector<NetworkRow> rows;  // at the present places
    std::vector<Eigen::Vector3d> inverseMass, moved, bestMoved, residual, nodes;
    std::vector<std::array<double, 2>> lambda, bestLambda, wanted, values;  // of links
};
/// Of networks that touch each other, which are swept together.
struct NetworkSweep {
    std::vector<NetworkMember> members;
    std::vector<PressedRow> contacts;
    std::vector<PressingBody> bodies;
};

/// Networks that touch each other, in this step.
struct NetworkGroup {
    std::vector<std::uint32_t> trees;  // in order
    /// How rows of contacts answer to a push at each of them, 1/kg (the Delassus operator), push by
    /// push; empty where that is not known.
    std::vector<double> answers;
    std::uint64_t work = 0;   // products of blocks, in the sweeps of this step
    bool waits = false;       // for the last sweep, because there is no work left
    double error = 0;         // that the last sweep has left
    double mostPressing = 0;  // kg m, of a contact in this step
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
    std::uint64_t tick = 0;
    /// Of each node: the sum of what the links have given in the sweeps, kg m and kg m^2.
    std::vector<Eigen::Vector3d> given;
    /// Of each node: its motion in this step as the passes have left it, m and rad, with which its
    /// links keep their lengths.
    std::vector<Eigen::Vector3d> settled;
};

}  // namespace sulfur::detail
