#include "trees/stiff_graph.hpp"

#include <algorithm>

#include "joints/classify.hpp"

namespace sulfur::detail {

namespace {

/// Place of a member in the frame of its cluster.
Point placeOf(const State& state, std::uint32_t particle) {
    const Clusters& clusters = state.clusters;
    const Cluster& c = clusters.list[state.particles.cluster[particle]];
    const auto from = clusters.members.begin() + c.first, to = clusters.members.begin() + c.last;
    const auto at = std::lower_bound(from, to, particle);
    return clusters.places[static_cast<std::size_t>(at - clusters.members.begin())];
}

}  // namespace

bool canMove(const State& state, const TreeNode& node) {
    if (node.cluster == none)
        return node.particle != none && inverseMassAwake(state, node.particle) > 0;
    const Cluster& c = state.clusters.list[node.cluster];
    return c.freeInverseMass > 0 || c.freeInverseInertia > 0;
}

StiffGraph::StiffGraph(const State& state)
    : state_(state), particles_(static_cast<std::uint32_t>(state.particles.size())) {
    std::vector<std::uint32_t> joints;
    for (std::uint32_t j = 0; j < state.joints.size(); ++j)
        if (isStiff(j)) joints.push_back(j);
    edges.reserve(joints.size() + state.attachments.size() + state.clusters.hinges.size());
    for (const auto j : joints) addJoint(j);
    for (std::uint32_t i = 0; i < state.attachments.size(); ++i) addAttachment(i);
    for (std::uint32_t i = 0; i < state.clusters.hinges.size(); ++i) addHinge(i);
    listEdgesAround();
    markCycles();
}

std::uint32_t StiffGraph::vertexCount() const {
    return particles_ + static_cast<std::uint32_t>(state_.clusters.list.size());
}

TreeNode StiffGraph::nodeFor(const EdgeEnd& e) const {
    TreeNode n;
    n.cluster = e.cluster;
    if (e.cluster == none) n.particle = e.end.particle;
    return n;
}

/// A rigid component of which two particles are pinned cannot move.
StiffGraph::EdgeEnd StiffGraph::endAt(std::uint32_t cluster, const LinkEnd& end) const {
    EdgeEnd e{none, cluster, end};
    if (canMove(state_, nodeFor(e))) e.vertex = particles_ + cluster;
    return e;
}

StiffGraph::EdgeEnd StiffGraph::endOf(std::uint32_t particle) const {
    const auto cluster = state_.particles.cluster[particle];
    if (cluster != none) return endAt(cluster, {particle, placeOf(state_, particle)});
    EdgeEnd e{none, none, {particle}};
    if (canMove(state_, nodeFor(e))) e.vertex = particle;
    return e;
}

void StiffGraph::add(const Edge& edge) {
    if (edge.a.vertex != edge.b.vertex) edges.push_back(edge);
}

bool StiffGraph::isStiff(std::uint32_t j) const {
    const Joints& joints = state_.joints;
    return !joints.inCluster[j] && joints.kind[j] != JointKind::explicitElastic &&
           (joints.body[j] != none || !isCut(state_, j));
}

void StiffGraph::addJoint(std::uint32_t j) {
    add({LinkKind::joint, j, endOf(state_.joints.a[j]), endOf(state_.joints.b[j])});
}

/// An attachment is an edge if its supports move as one; else it is swept.
void StiffGraph::addAttachment(std::uint32_t i) {
    const Attachment& held = state_.attachments[i];
    if (isCut(state_, held)) return;
    EdgeEnd support = endOf(held.support[0]);
    if (held.count > 1) {
        Point place(0, 0);
        for (std::uint32_t k = 0; k < held.count; ++k) {
            const EdgeEnd one = endOf(held.support[k]);
            if (one.vertex != support.vertex) return;
            if (one.vertex != none && !isCluster(one.vertex)) return;
            place += static_cast<double>(held.weight[k]) * one.end.place;
        }
        support.end = {none, place};
        if (support.vertex == none) support.cluster = none;  // they may be of several
    }
    add({LinkKind::attachment, i, endOf(held.particle), support});
}

void StiffGraph::addHinge(std::uint32_t i) {
    const Hinge& hinge = state_.clusters.hinges[i];
    add({LinkKind::hinge, i, endAt(hinge.cluster, {none, hinge.place}), endOf(hinge.particle)});
}

void StiffGraph::listEdgesAround() {
    start_.assign(vertexCount() + 1, 0);
    for (const Edge& e : edges)
        for (const auto v : {e.a.vertex, e.b.vertex})
            if (v != none) ++start_[v + 1];
    for (std::size_t v = 1; v < start_.size(); ++v) start_[v] += start_[v - 1];
    around_.resize(start_.back());
    auto next = start_;
    for (std::uint32_t i = 0; i < edges.size(); ++i)
        for (const auto v : {edges[i].a.vertex, edges[i].b.vertex})
            if (v != none) around_[next[v]++] = i;
}

bool StiffGraph::isBraced(const Edge& e) const {
    return e.kind == LinkKind::joint && state_.joints.braced[e.link] != 0;
}

bool StiffGraph::isRigid(const Edge& e) const {
    return e.kind != LinkKind::joint || state_.joints.kind[e.link] == JointKind::rigid;
}

/// Lattices have cycles, even if springs that are forces close all of them. What is held at two
/// ends by what cannot move has one through the ground, if it is rigid somewhere.
void StiffGraph::markCycles() {
    sets_.reset(vertexCount());
    std::vector<std::uint32_t> closing;
    for (const Edge& e : edges) {
        const bool closes =
            e.a.vertex != none && e.b.vertex != none && !sets_.unite(e.a.vertex, e.b.vertex);
        if (closes || isBraced(e)) closing.push_back(anyVertex(e));
    }
    cyclic_.assign(vertexCount(), false);
    network_.assign(vertexCount(), false);
    for (const auto v : closing) cyclic_[sets_.find(v)] = true;
    std::vector<std::uint32_t> held(vertexCount(), 0);  // ends of a part that cannot move
    for (const Edge& e : edges)
        if (e.a.vertex == none || e.b.vertex == none) ++held[sets_.find(anyVertex(e))];
    for (const Edge& e : edges) {
        const auto part = sets_.find(anyVertex(e));
        if (isRigid(e) && (cyclic_[part] || held[part] > 1)) network_[part] = true;
    }
    for (const Edge& e : edges)
        if (isBraced(e)) network_[sets_.find(anyVertex(e))] = false;
    for (std::uint32_t v = 0; v < vertexCount(); ++v)
        if (network_[v]) cyclic_[v] = true;
}

}  // namespace sulfur::detail
