// The graph of what is stiff. Its vertices are the particles that move by themselves and the rigid
// components, its edges the stiff joints, attachments and hinges between them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/disjoint_sets.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

/// Whether physics moves it while its body is awake.
bool canMove(const State& state, const TreeNode& node);

class StiffGraph {
public:
    struct EdgeEnd {
        std::uint32_t vertex = none;   // none: it cannot move
        std::uint32_t cluster = none;  // of which it is a member
        LinkEnd end;
    };
    struct Edge {
        LinkKind kind = LinkKind::joint;
        std::uint32_t link = none;
        EdgeEnd a, b;
    };

    explicit StiffGraph(const State& state);

    std::uint32_t vertexCount() const;
    /// The node for an end of an edge.
    TreeNode nodeFor(const EdgeEnd& e) const;
    bool isCluster(std::uint32_t vertex) const { return vertex >= particles_; }
    std::size_t degree(std::uint32_t vertex) const { return start_[vertex + 1] - start_[vertex]; }

    bool inCycle(const Edge& edge) { return cyclic_[sets_.find(anyVertex(edge))]; }
    /// Whether its part has cycles that are solved as a whole: they have something rigid, and no
    /// spring of a lattice.
    bool inNetwork(const Edge& edge) { return network_[sets_.find(anyVertex(edge))]; }
    void refuseNetwork(const Edge& edge) { network_[sets_.find(anyVertex(edge))] = false; }

    /// Calls f(edge) for the numbers of the edges at a vertex, in order.
    template <class Function>
    void forEachEdgeAt(std::uint32_t vertex, Function&& f) const {
        for (auto k = start_[vertex]; k < start_[vertex + 1]; ++k) f(around_[k]);
    }

    std::vector<Edge> edges;

private:
    static std::uint32_t anyVertex(const Edge& edge) {
        return edge.a.vertex != none ? edge.a.vertex : edge.b.vertex;
    }
    EdgeEnd endOf(std::uint32_t particle) const;
    EdgeEnd endAt(std::uint32_t cluster, const LinkEnd& end) const;
    void add(const Edge& edge);
    bool isStiff(std::uint32_t joint) const;
    void addJoint(std::uint32_t j);
    void addAttachment(std::uint32_t i);
    void addHinge(std::uint32_t i);
    void listEdgesAround();
    bool isBraced(const Edge& e) const;
    bool isRigid(const Edge& e) const;
    void markCycles();

    const State& state_;
    std::uint32_t particles_;  // vertices below this are particles
    std::vector<std::uint32_t> start_, around_;
    DisjointSets sets_;
    std::vector<bool> cyclic_, network_;  // of the first vertex of each set
};

}  // namespace sulfur::detail
