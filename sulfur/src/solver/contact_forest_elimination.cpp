// The linear system of a tree of contacts, and its solution by elimination along the tree.
#include "solver/contact_forest.hpp"

namespace sulfur::detail {

namespace {

using Vector3 = Cholesky3::Vector;

/// What is not moved along an axis has as good as infinite mass there.
double massOf(Real inverse) {
    return inverse > 0 ? 1 / static_cast<double>(inverse) : 1e30;
}

Vector3 masses(const State& state, std::uint32_t cluster, std::uint32_t particle) {
    if (cluster == none) {
        const double m = massOf(state.particles.inverseMass[particle]);
        return {m, m, 1};
    }
    const Cluster& c = state.clusters.list[cluster];
    const double m = massOf(c.inverseMass);
    return {m, m, massOf(c.inverseInertia)};
}

/// Adds weight * v v^T to the lower half.
void addSquare(Cholesky3::Matrix& lower, const Vector3& v, const Vector3& weighted) {
    for (int column = 0; column < 3; ++column)
        for (int row = column; row < 3; ++row) lower(row, column) += weighted[row] * v[column];
}

}  // namespace

void ContactForest::addToFirst(const ActiveRow& active) {
    const Row& row = rows_[active.row];
    const Edge& e = edges_[row.edge];
    Node& a = nodes_[e.a];
    const Vector3 weighted = row.weight * row.a;
    addSquare(a.system, row.a, weighted);
    a.motion -= active.error * weighted;
    if (e.b != none && a.parent == e.b) a.towardsParent.noalias() += weighted * row.b.transpose();
}

void ContactForest::addToSecond(const ActiveRow& active) {
    const Row& row = rows_[active.row];
    const Edge& e = edges_[row.edge];
    if (e.b == none) return;
    Node& b = nodes_[e.b];
    const Vector3 weighted = row.weight * row.b;
    addSquare(b.system, row.b, weighted);
    b.motion -= active.error * weighted;
    if (b.parent == e.a) b.towardsParent.noalias() += weighted * row.a.transpose();
}

/// (M + sum of weight J^T J) u = - sum of weight J^T error. Each piece adds to its own nodes, in
/// the order of all rows: first what leads there from the pieces before.
void ContactForest::assemble(const State& state) {
    forEachPiece([&](Piece& piece) {
        for (auto i = piece.firstNode; i < piece.lastNode; ++i) {
            Node& node = nodes_[i];
            node.motion.setZero();
            if (!nodes_[node.root].unfinished) continue;
            node.system = masses(state, node.cluster, node.particle).asDiagonal();
            node.towardsParent.setZero();
        }
        const auto otherOf = [&](const ActiveRow& active) {
            return edges_[rows_[active.row].edge].b;
        };
        for (const Piece* before = pieces_.data(); before != &piece; ++before)
            for (const auto k : before->leadingOn) {
                const auto node = otherOf(active_[k]);
                if (node >= piece.firstNode && node < piece.lastNode) addToSecond(active_[k]);
            }
        for (const ActiveRow& active : activeOf(piece)) {
            addToFirst(active);
            const auto node = otherOf(active);
            if (node < piece.lastNode) addToSecond(active);
        }
    });
}

/// From the leaves to the roots.
void ContactForest::eliminate() {
    for (auto i = order_.rbegin(); i != order_.rend(); ++i) {
        Node& node = nodes_[*i];
        if (!nodes_[node.root].unfinished) continue;
        const Cholesky3 system(node.system);
        node.motion = system.solve(node.motion);
        if (node.parent == none) continue;
        Node& parent = nodes_[node.parent];
        const Matrix3 through = system.solve(node.towardsParent);
        for (int column = 0; column < 3; ++column)
            for (int row = column; row < 3; ++row)
                parent.system(row, column) -= node.towardsParent.col(row).dot(through.col(column));
        parent.motion.noalias() -= node.towardsParent.transpose().lazyProduct(node.motion);
        node.towardsParent = through;
    }
}

/// And back.
void ContactForest::substitute() {
    for (const auto i : order_)
        if (nodes_[i].parent != none && nodes_[nodes_[i].root].unfinished)
            nodes_[i].motion -= nodes_[i].towardsParent * nodes_[nodes_[i].parent].motion;
}

}  // namespace sulfur::detail
