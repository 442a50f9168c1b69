// The direct solver for a tree of constraints.
//
// Unknown are the multipliers lambda of the links and the changes delta of the nodes:
//     delta_i = W_i sum of (columns of its links) lambda,   C + rows . delta + alpha lambda = 0.
// Going from the leaves to the root, each node carries its articulated inverse mass W and its
// offset q: how it answers a push when everything that hangs on it follows. A link updates them at
// its parent by the Sherman-Morrison formula, so nothing fills in and no mass is inverted; what
// cannot move has W = 0 and needs no case of its own. For a chain this is the Thomas algorithm.
// (Articulated bodies: Featherstone 1983; trees without fill: Baraff 1996.)
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/settings.hpp"

namespace sulfur::detail {

/// `N`: freedoms of a node, 2 (points) or 3 (points and rigid components).
template <int N>
class Elimination {
public:
    using Vector = Eigen::Matrix<double, N, 1>;
    using Matrix = Eigen::Matrix<double, N, N>;
    /// As many right sides as are answered side by side.
    static constexpr int lanes = 4;
    using Lanes = Eigen::Array<double, N, lanes, Eigen::RowMajor>;

    /// A link of a node to its parent. Up to two rows; row r of the constraint changes by
    /// row[r] . delta, and a unit of lambda[r] pushes along column[r].
    struct Link {
        std::uint32_t parent = 0;
        int rows = 0;  // 0: the link is inert
        std::array<Vector, 2> rowHere, rowThere, columnHere, columnThere;
        std::array<double, 2> value{0, 0};       // C, to become 0
        std::array<double, 2> compliance{0, 0};  // alpha

        // What the way down leaves for the way up.
        std::array<double, 2> offset{0, 0};
        std::array<Vector, 2> answer;  // rows of the parent times its W
        std::array<double, 4> inverse{0, 0, 0, 0};
        std::array<double, 2> lambda{0, 0};  // the result
    };

    struct Node {
        Vector inverseMass;  // diagonal of W without children
        Matrix mobility;     // W
        Vector offset;       // q
        Vector impulse;      // sum of columns times lambda
    };

    void resize(std::size_t count) {
        nodes.resize(count);
        links.resize(count);
    }

    /// Solves for all lambda and leaves in Node::impulse what they push.
    void solve() {
        for (Node& node : nodes) {
            node.mobility = node.inverseMass.asDiagonal();
            node.offset.setZero();
            node.impulse.setZero();
        }
        for (std::size_t i = nodes.size() - 1; i > 0; --i) {
            Link& link = links[i];
            if (link.rows == 1)
                eliminateOne(nodes[i], nodes[link.parent], link);
            else if (link.rows == 2)
                eliminateTwo(nodes[i], nodes[link.parent], link);
        }
        for (std::size_t i = 1; i < nodes.size(); ++i) substitute(nodes[i], links[i]);
    }

    /// `given`: changes of the nodes, in each lane others. Of these becomes what the links leave
    /// that solve() has eliminated, which push along their rows.
    void answer(std::span<Lanes> given) {
        offsets_.assign(given.begin(), given.end());
        impulses_.assign(nodes.size(), Lanes::Zero());
        linkOffsets_.resize(nodes.size());
        for (std::size_t i = nodes.size() - 1; i > 0; --i) passOn(i);
        for (std::size_t i = 1; i < nodes.size(); ++i) substitute(i);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            given[i] += impulses_[i].colwise() * nodes[i].inverseMass.array();
    }

    std::size_t bytes() const {
        return nodes.size() * sizeof(Node) + links.size() * sizeof(Link) +
               (offsets_.size() + impulses_.size()) * sizeof(Lanes) +
               linkOffsets_.size() * sizeof(linkOffsets_[0]);
    }

    std::vector<Node> nodes;
    std::vector<Link> links;  // links[i] leads from node i to its parent; links[0] is unused

private:
    static constexpr double redundant = tuned::redundantPivot;

    static void eliminateOne(const Node& child, Node& parent, Link& link) {
        const double here = link.rowHere[0].dot(child.mobility * link.columnHere[0]);
        const Vector a = parent.mobility * link.columnThere[0];
        const double whole = here + link.compliance[0] + link.rowThere[0].dot(a);
        const double scale = child.inverseMass[0] + parent.inverseMass[0];
        const double inverse = std::abs(whole) > redundant * scale ? 1 / whole : 0;
        link.offset[0] =
            link.value[0] + link.rowHere[0].dot(child.offset) + link.rowThere[0].dot(parent.offset);
        link.answer[0] = parent.mobility.transpose() * link.rowThere[0];
        link.inverse[0] = inverse;
        parent.offset -= a * (inverse * link.offset[0]);
        parent.mobility -= (inverse * a) * link.answer[0].transpose();
    }

    static void eliminateTwo(const Node& child, Node& parent, Link& link) {
        double whole[2][2];
        std::array<Vector, 2> a;
        for (std::size_t c = 0; c < 2; ++c) {
            const Vector here = child.mobility * link.columnHere[c];
            a[c] = parent.mobility * link.columnThere[c];
            for (std::size_t r = 0; r < 2; ++r)
                whole[r][c] = link.rowHere[r].dot(here) + link.rowThere[r].dot(a[c]) +
                              (r == c ? link.compliance[r] : 0);
        }
        invert(whole, child.inverseMass[0] + parent.inverseMass[0], link.inverse);
        for (std::size_t r = 0; r < 2; ++r) {
            link.offset[r] = link.value[r] + link.rowHere[r].dot(child.offset) +
                             link.rowThere[r].dot(parent.offset);
            link.answer[r] = parent.mobility.transpose() * link.rowThere[r];
        }
        const auto& m = link.inverse;
        const Vector first = m[0] * a[0] + m[2] * a[1], second = m[1] * a[0] + m[3] * a[1];
        parent.offset -= first * link.offset[0] + second * link.offset[1];
        parent.mobility -= first * link.answer[0].transpose() + second * link.answer[1].transpose();
    }

    /// Row by row; zero where nothing can move.
    static void invert(const double (&m)[2][2], double scale, std::array<double, 4>& inverse) {
        const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        const double least = redundant * scale * scale;
        if (!(std::abs(determinant) > least)) {
            inverse = {0, 0, 0, 0};
            return;
        }
        inverse = {m[1][1] / determinant, -m[0][1] / determinant, -m[1][0] / determinant,
                   m[0][0] / determinant};
    }

    using Row = Eigen::Array<double, 1, lanes>;

    static Row along(const Vector& row, const Lanes& x) {
        if constexpr (N == 2)
            return row[0] * x.row(0) + row[1] * x.row(1);
        else
            return row[0] * x.row(0) + row[1] * x.row(1) + row[2] * x.row(2);
    }

    /// What of the offsets goes through an eliminated link to the parent.
    void passOn(std::size_t i) {
        const Link& link = links[i];
        Lanes& parent = offsets_[link.parent];
        std::array<Row, 2>& offset = linkOffsets_[i];
        const auto rows = static_cast<std::size_t>(link.rows);
        for (std::size_t r = 0; r < rows; ++r)
            offset[r] = along(link.rowHere[r], offsets_[i]) + along(link.rowThere[r], parent);
        const auto& m = link.inverse;
        if (rows == 1) {
            const Row through = m[0] * offset[0];
            for (int k = 0; k < N; ++k) parent.row(k) -= link.answer[0][k] * through;
        } else if (rows == 2) {
            const Row first = m[0] * offset[0] + m[1] * offset[1];
            const Row second = m[2] * offset[0] + m[3] * offset[1];
            for (int k = 0; k < N; ++k)
                parent.row(k) -= link.answer[0][k] * first + link.answer[1][k] * second;
        }
    }

    void substitute(std::size_t i) {
        const Link& link = links[i];
        Lanes& parent = impulses_[link.parent];
        const auto rows = static_cast<std::size_t>(link.rows);
        std::array<Row, 2> want, lambda;
        for (std::size_t r = 0; r < rows; ++r)
            want[r] = -(linkOffsets_[i][r] + along(link.answer[r], parent));
        const auto& m = link.inverse;
        if (rows == 1) {
            lambda[0] = m[0] * want[0];
        } else if (rows == 2) {
            lambda[0] = m[0] * want[0] + m[1] * want[1];
            lambda[1] = m[2] * want[0] + m[3] * want[1];
        }
        for (std::size_t r = 0; r < rows; ++r)
            for (int k = 0; k < N; ++k) {
                parent.row(k) += link.columnThere[r][k] * lambda[r];
                impulses_[i].row(k) += link.columnHere[r][k] * lambda[r];
            }
    }

    void substitute(Node& child, Link& link) {
        Node& parent = nodes[link.parent];
        const auto rows = static_cast<std::size_t>(link.rows);
        std::array<double, 2> want{0, 0};
        for (std::size_t r = 0; r < rows; ++r)
            want[r] = -(link.offset[r] + link.answer[r].dot(parent.impulse));
        if (rows == 1) {
            link.lambda[0] = link.inverse[0] * want[0];
        } else if (rows == 2) {
            link.lambda[0] = link.inverse[0] * want[0] + link.inverse[1] * want[1];
            link.lambda[1] = link.inverse[2] * want[0] + link.inverse[3] * want[1];
        }
        for (std::size_t r = 0; r < rows; ++r) {
            parent.impulse += link.columnThere[r] * link.lambda[r];
            child.impulse += link.columnHere[r] * link.lambda[r];
        }
    }

    // Of right sides that are answered.
    std::vector<Lanes> offsets_, impulses_;  // of nodes
    std::vector<std::array<Row, 2>> linkOffsets_;
};

}  // namespace sulfur::detail
