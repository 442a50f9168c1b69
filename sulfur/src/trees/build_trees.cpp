// Finding chains, trees and networks: the caller declares nothing.
//
// A part of the graph of what is stiff without a cycle is a tree that moves alone. A part with
// cycles and something rigid is a network, which moves alone as well. In a lattice of springs,
// every long path through vertices of two edges is a line that is solved as a whole in each sweep;
// the rest is swept joint by joint.
#include <algorithm>
#include <array>
#include <bit>

#include "rigid/cluster_motion.hpp"
#include "trees/networks.hpp"
#include "trees/stiff_graph.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// Shorter paths through a mesh are swept.
constexpr std::size_t shortestLine = 4;

using Edge = StiffGraph::Edge;
using EdgeEnd = StiffGraph::EdgeEnd;

class TreeBuilder {
public:
    explicit TreeBuilder(State& state) : state_(state), graph_(state), trees_(state.trees) {
        trees_.clear();
        trees_.ofParticle.assign(state.particles.size(), none);
        trees_.ofCluster.assign(state.clusters.list.size(), none);
        used_.assign(graph_.edges.size(), false);
        seen_.assign(graph_.edges.size(), 0);
    }

    void run() {
        // Trees with something that cannot move are rooted there, so that a rope's nodes stand in
        // its own order.
        for (std::uint32_t i = 0; i < graph_.edges.size(); ++i) {
            const Edge& e = graph_.edges[i];
            if (e.a.vertex == none || e.b.vertex == none) startTree(i);
        }
        for (std::uint32_t i = 0; i < graph_.edges.size(); ++i)
            if (isEndOfTree(graph_.edges[i])) startTree(i);
        for (std::uint32_t i = 0; i < graph_.edges.size(); ++i) startTree(i);
        for (std::uint32_t i = 0; i < graph_.edges.size(); ++i) startNetwork(i);
        for (std::uint32_t i = 0; i < graph_.edges.size(); ++i)
            if (!used_[i]) startLine(i);
        listWhatRemains();
    }

private:
    bool isEndOfTree(const Edge& e) const {
        return graph_.degree(e.a.vertex == none ? e.b.vertex : e.a.vertex) == 1 ||
               (e.b.vertex != none && graph_.degree(e.b.vertex) == 1);
    }

    std::uint32_t sizeOf(const Tree& tree) const {
        return static_cast<std::uint32_t>(trees_.nodes.size()) - tree.first;
    }

    /// Adds the far end of an edge as a child of node `parent`, which holds the other one.
    void addChild(std::uint32_t i, bool fromB, std::uint32_t parent) {
        const Edge& edge = graph_.edges[i];
        const EdgeEnd &from = fromB ? edge.b : edge.a, &to = fromB ? edge.a : edge.b;
        TreeNode n = graph_.nodeFor(to);
        n.turned = fromB ? 0 : 1;
        n.parent = parent;
        n.kind = edge.kind;
        n.link = edge.link;
        n.here = to.end;
        n.there = from.end;
        trees_.nodes.push_back(n);
        used_[i] = true;
    }

    Tree begin() const {
        Tree tree;
        tree.first = static_cast<std::uint32_t>(trees_.nodes.size());
        return tree;
    }

    bool continuesChain(const Tree& tree, std::uint32_t k) const {
        const TreeNode& n = trees_.nodes[k];
        if (!tree.alone || n.particle == none) return false;
        return k == tree.first || (n.kind == LinkKind::joint && n.parent + 1 == k - tree.first);
    }

    void finish(Tree tree) {
        tree.last = static_cast<std::uint32_t>(trees_.nodes.size());
        const auto index = static_cast<std::uint32_t>(trees_.list.size());
        tree.lastStep = state_.lastStep;
        for (auto k = tree.first; k < tree.last; ++k) {
            const TreeNode& n = trees_.nodes[k];
            if (n.cluster != none) tree.points = 0;
            if (tree.network != none || !continuesChain(tree, k)) tree.chain = 0;
            if (!tree.alone || !canMove(state_, n)) continue;
            if (n.cluster != none)
                trees_.ofCluster[n.cluster] = index;
            else
                trees_.ofParticle[n.particle] = index;
        }
        trees_.list.push_back(tree);
    }

    /// Breadth first from an edge of a part without cycles.
    void startTree(std::uint32_t first) {
        const Edge& edge = graph_.edges[first];
        if (used_[first] || graph_.inCycle(edge)) return;
        const bool fromB =
            edge.b.vertex == none || (edge.a.vertex != none && graph_.degree(edge.b.vertex) == 1 &&
                                      graph_.degree(edge.a.vertex) != 1);
        const EdgeEnd& root = fromB ? edge.b : edge.a;
        Tree tree = begin();
        std::vector<std::uint32_t> vertex{root.vertex};  // of each node
        trees_.nodes.push_back(graph_.nodeFor(root));
        trees_.nodes.back().link = edge.link;  // tells where an attachment's supports are
        const auto grow = [&](std::uint32_t i, bool rootIsB, std::uint32_t parent) {
            if (used_[i]) return;
            const Edge& e = graph_.edges[i];
            addChild(i, rootIsB, parent);
            vertex.push_back(rootIsB ? e.a.vertex : e.b.vertex);
        };
        if (root.vertex == none) grow(first, fromB, 0);
        for (std::uint32_t k = 0; k < vertex.size(); ++k) {
            const auto v = vertex[k];
            if (v == none) continue;
            graph_.forEachEdgeAt(
                v, [&](std::uint32_t i) { grow(i, graph_.edges[i].b.vertex == v, k); });
        }
        finish(tree);
    }

    /// N, as a first guess for a link that was there before.
    std::array<double, 2> pushedBefore(const Edge& e) const {
        if (e.kind == LinkKind::joint)
            return {-static_cast<double>(state_.joints.force[e.link]), 0};
        const Vec2& force = e.kind == LinkKind::hinge ? state_.clusters.hinges[e.link].force
                                                      : state_.attachments[e.link].force;
        return {static_cast<double>(force[0]), static_cast<double>(force[1])};
    }

    /// Breadth first from an edge of a part with cycles. What cannot move is a node of its own for
    /// each of its links, as in trees.
    void startNetwork(std::uint32_t first) {
        if (used_[first] || !graph_.inNetwork(graph_.edges[first])) return;
        Tree tree = begin();
        tree.network = static_cast<std::uint32_t>(trees_.factors.size());
        tree.firstLink = static_cast<std::uint32_t>(trees_.links.size());
        nodeOf_.resize(graph_.vertexCount(), none);
        std::vector<std::uint32_t> vertices;
        const auto nodeAt = [&](const Edge& e, const EdgeEnd& end) {
            if (end.vertex != none && nodeOf_[end.vertex] != none) return nodeOf_[end.vertex];
            const std::uint32_t node = sizeOf(tree);
            trees_.nodes.push_back(graph_.nodeFor(end));
            trees_.nodes.back().link = e.link;  // tells where an attachment's supports are
            if (end.vertex == none) return node;
            nodeOf_[end.vertex] = node;
            vertices.push_back(end.vertex);
            return node;
        };
        const auto take = [&](std::uint32_t i) {
            if (used_[i]) return;
            used_[i] = true;
            const Edge& e = graph_.edges[i];
            const std::uint32_t here = nodeAt(e, e.a), there = nodeAt(e, e.b);
            trees_.links.push_back({e.kind, e.link, here, there, e.a.end, e.b.end});
            trees_.links.back().pushed = pushedBefore(e);
        };
        take(first);
        for (std::size_t k = 0; k < vertices.size(); ++k) graph_.forEachEdgeAt(vertices[k], take);
        tree.lastLink = static_cast<std::uint32_t>(trees_.links.size());
        trees_.factors.emplace_back();
        tree.last = static_cast<std::uint32_t>(trees_.nodes.size());
        if (analyseNetwork(state_, tree)) return finish(tree);
        // Its price has no bound: it is swept.
        trees_.factors.pop_back();
        trees_.nodes.resize(tree.first);
        trees_.links.resize(tree.firstLink);
        graph_.refuseNetwork(graph_.edges[first]);
        for (const auto v : vertices)
            graph_.forEachEdgeAt(v, [&](std::uint32_t i) { used_[i] = false; });
    }

    struct Step {
        std::uint32_t edge;
        bool forward;  // from its a to its b
    };

    /// Follows vertices of two edges from one end of an edge, as far as they go.
    std::vector<Step> follow(std::uint32_t start, bool forward) const {
        std::vector<Step> path{{start, forward}};
        for (;;) {
            const Step last = path.back();
            const Edge& e = graph_.edges[last.edge];
            const auto v = last.forward ? e.b.vertex : e.a.vertex;
            if (v == none || graph_.degree(v) != 2) return path;
            std::uint32_t next = none;
            graph_.forEachEdgeAt(v, [&](std::uint32_t i) {
                if (i != last.edge) next = i;
            });
            if (next == none || next == start || used_[next]) return path;
            path.push_back({next, graph_.edges[next].a.vertex == v});
        }
    }

    void startLine(std::uint32_t first) {
        std::vector<Step> path = follow(first, false);
        std::reverse(path.begin(), path.end());
        for (Step& step : path) step.forward = !step.forward;
        const auto onward = follow(first, true);
        path.insert(path.end(), onward.begin() + 1, onward.end());
        dropRepeats(path);
        if (path.size() < shortestLine) return;
        Tree tree = begin();
        tree.alone = 0;
        const Edge& edge = graph_.edges[path[0].edge];
        trees_.nodes.push_back(graph_.nodeFor(path[0].forward ? edge.a : edge.b));
        trees_.nodes.back().link = edge.link;
        for (const Step step : path) {
            addChild(step.edge, !step.forward, sizeOf(tree) - 1);
        }
        finish(tree);
    }

    /// A ring meets itself again: its last edges are left to the sweeps.
    void dropRepeats(std::vector<Step>& path) {
        ++stamp_;
        for (std::size_t k = 0; k < path.size(); ++k) {
            if (seen_[path[k].edge] == stamp_) {
                path.resize(k);
                break;
            }
            seen_[path[k].edge] = stamp_;
        }
        const auto vertexBefore = [&](const Step& s) {
            const Edge& e = graph_.edges[s.edge];
            return s.forward ? e.a.vertex : e.b.vertex;
        };
        const auto vertexAfter = [&](const Step& s) {
            const Edge& e = graph_.edges[s.edge];
            return s.forward ? e.b.vertex : e.a.vertex;
        };
        if (!path.empty() && vertexAfter(path.back()) != none &&
            vertexAfter(path.back()) == vertexBefore(path.front()))
            path.pop_back();
    }

    void listWhatRemains() {
        Structure& rest = state_.structure;
        rest.sweptJoints.clear();
        rest.sweptAttachments.clear();
        rest.sweptHinges.clear();
        std::vector<bool> attachmentUsed(state_.attachments.size(), false);
        for (std::uint32_t i = 0; i < graph_.edges.size(); ++i) {
            const Edge& e = graph_.edges[i];
            if (e.kind == LinkKind::attachment) attachmentUsed[e.link] = used_[i];
            if (used_[i]) continue;
            if (e.kind == LinkKind::joint) rest.sweptJoints.push_back(e.link);
            if (e.kind == LinkKind::hinge) rest.sweptHinges.push_back(e.link);
        }
        colourJoints();
        for (std::uint32_t i = 0; i < state_.attachments.size(); ++i) {
            if (attachmentUsed[i]) continue;
            rest.sweptAttachments.push_back(i);
            const Attachment& held = state_.attachments[i];
            tie(held.particle);
            for (std::uint32_t k = 0; k < held.count; ++k) tie(held.support[k]);
        }
        const Angles& angles = state_.angles;
        for (std::uint32_t i = 0; i < angles.size(); ++i) {
            if (angles.kind[i] != AngleKind::implicitElastic) continue;
            for (const auto p : {angles.a[i], angles.b[i], angles.c[i]}) tie(p);
        }
    }

    /// Greedily: each joint gets the first colour that no other has at its ends. Then sorts the
    /// list by colours, and within a colour joints between points before those of clusters.
    void colourJoints() {
        Structure& rest = state_.structure;
        rest.colours.assign(state_.joints.size(), 0);
        std::vector<std::uint64_t> taken(graph_.vertexCount(), 0);
        std::vector<std::uint8_t> ofCluster(state_.joints.size(), 0);
        for (std::uint32_t i = 0; i < graph_.edges.size(); ++i) {
            const Edge& e = graph_.edges[i];
            if (used_[i] || e.kind != LinkKind::joint) continue;
            std::uint64_t here = 0;
            for (const auto v : {e.a.vertex, e.b.vertex}) {
                if (v == none) continue;
                here |= taken[v];
                if (graph_.isCluster(v)) ofCluster[e.link] = 1;
            }
            const int colour = std::min<int>(std::countr_one(here), noColour);
            rest.colours[e.link] = static_cast<std::uint8_t>(colour);
            for (const auto v : {e.a.vertex, e.b.vertex})
                if (v != none) taken[v] |= std::uint64_t{1} << colour;
        }
        const auto key = [&](std::uint32_t j) { return 2 * rest.colours[j] + ofCluster[j]; };
        std::stable_sort(rest.sweptJoints.begin(), rest.sweptJoints.end(),
                         [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
    }

    /// A swept attachment or angular joint pulls on the tree of this particle, if it has one.
    void tie(std::uint32_t particle) {
        const auto tree = trees_.of(state_.particles.cluster[particle], particle);
        if (tree != none) trees_.list[tree].tied = 1;
    }

    State& state_;
    StiffGraph graph_;
    Trees& trees_;
    std::vector<std::uint32_t> nodeOf_;  // vertex: its node in a network
    std::vector<bool> used_;
    std::vector<std::uint32_t> seen_;  // edge: the last line that came across it
    std::uint32_t stamp_ = 0;
};

}  // namespace

double lastStepOf(const State& state, std::uint32_t particle) {
    // What was added since the last tick is in no tree yet.
    if (state.trees.list.empty() || particle >= state.trees.ofParticle.size())
        return state.lastStep;
    const auto tree = state.trees.of(state.particles.cluster[particle], particle);
    return tree == none ? state.lastStep : state.trees.list[tree].lastStep;
}

void dissolveTrees(State& state) {
    for (const Tree& tree : state.trees.list) {
        const double late = (state.lastStep - tree.lastStep) / 2;
        if (!tree.alone || late == 0) continue;
        for (auto k = tree.first; k < tree.last; ++k) {
            const TreeNode& n = state.trees.nodes[k];
            if (n.cluster != none) {
                Cluster& c = state.clusters.list[n.cluster];
                if (c.inverseMass > 0) c.velocity -= late * gravityOf(state, c.body);
            } else if (n.particle != none && state.particles.inverseMass[n.particle] > 0) {
                state.particles.velocity[n.particle] -=
                    late * gravityOf(state, state.particles.body[n.particle]);
            }
        }
    }
    state.trees.clear();
}

void buildTrees(State& state) {
    TreeBuilder(state).run();
    state.trees.earlier.clear();
    state.trees.rows.assign(state.trees.links.size(), {});
}

}  // namespace sulfur::detail
