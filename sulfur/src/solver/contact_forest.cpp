#include "solver/contact_forest.hpp"

#include <algorithm>
#include <cmath>

#include "core/bucket_sort.hpp"
#include "rigid/grip.hpp"
#include "solver/contact_motion.hpp"

namespace sulfur::detail {

namespace {

/// Of the penalty, in effective masses of the contact: what is left of an error is about a part in
/// so many, and rounding, in double, is far below.
constexpr double stiffnessOfPenalty = 1e5;

/// Of the active set, in a sweep.
constexpr int mostSteps = 2;

/// m/s: a contact that begins, and is not closing by more than minus this, may have to push.
constexpr Real mostErrorOfNew = Real(5e-5);

/// As shares of an arm: within this, rows ask for the same.
constexpr double alikeWithin = 1e-2;

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

/// How the motion of what the grip holds moves the grip along `direction`.
Vector3 jacobian(const Grip& grip, const Vec2& direction) {
    const Point along = direction.cast<double>();
    const double lever = grip.cluster == none ? 0 : cross(grip.arm.cast<double>(), along);
    return {along[0], along[1], lever};
}

/// Whether two rows mean the same to a node.
bool areAlike(const Vector3& p, const Vector3& q) {
    const double lever = std::max(std::abs(p[2]), std::abs(q[2]));
    return (p.head<2>() - q.head<2>()).squaredNorm() < alikeWithin * alikeWithin &&
           std::abs(p[2] - q[2]) <= alikeWithin * lever;
}

}  // namespace

/// The node of what the grip holds, or none if it does not move, or is part of something soft.
std::uint32_t ContactForest::nodeOf(const State& state, const Grip& grip) {
    const bool rigid = grip.cluster != none;
    if (rigid) {
        const Cluster& c = state.clusters.list[grip.cluster];
        if (c.inverseMass == 0 && c.inverseInertia == 0) return none;
    } else if (state.particles.inverseMass[grip.particle] == 0) {
        return none;
    }
    auto& node = rigid ? nodeOfCluster_[grip.cluster] : nodeOfParticle_[grip.particle];
    if (node == none) {
        node = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        nodes_.back().cluster = grip.cluster;
        nodes_.back().particle = grip.particle;
    }
    return node;
}

void ContactForest::collectContacts(const State& state) {
    nodes_.clear();
    keyed_.clear();
    nodeOfCluster_.assign(state.clusters.list.size(), none);
    nodeOfParticle_.assign(state.particles.size(), none);
    for (std::uint32_t i = 0; i < state.contacts.size(); ++i) {
        const Contact& c = state.contacts[i];
        if (c.shareB != 0 && (isSoft(state, c.gripOfB) || isSoft(state, c.gripOfA))) continue;
        if (isSoft(state, c.gripOfParticle) || isSoft(state, c.gripOfA)) continue;
        std::uint64_t a = nodeOf(state, c.gripOfParticle), b = nodeOf(state, c.gripOfA);
        if (a > b) std::swap(a, b);
        if (a != none) keyed_.push_back({a << 32 | b, i});
    }
    bucketSort(keyed_, keyedScratch_, start_, nodes_.size(),
               [](const Keyed& k) { return static_cast<std::uint32_t>(k.nodes >> 32); });
}

void ContactForest::collectEdges(const State& state) {
    edges_.clear();
    for (std::uint32_t k = 0; k < keyed_.size(); ++k) {
        const auto nodes = keyed_[k].nodes;
        if (k == 0 || keyed_[k - 1].nodes != nodes) {
            edges_.emplace_back();
            edges_.back().a = static_cast<std::uint32_t>(nodes >> 32);
            edges_.back().b = static_cast<std::uint32_t>(nodes);
            edges_.back().first = k;
        }
        edges_.back().last = k + 1;
        edges_.back().carried += state.contacts[keyed_[k].contact].normalLambda;
    }
}

/// A spanning forest of those edges that carry most (Kruskal). What does not move closes no cycle.
void ContactForest::chooseEdges() {
    byLoad_.clear();
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        edges_[e].chosen = edges_[e].b == none;
        if (!edges_[e].chosen) byLoad_.push_back({-edges_[e].carried, e});
    }
    std::sort(byLoad_.begin(), byLoad_.end());
    trees_.reset(nodes_.size());
    for (const auto& [load, e] : byLoad_) edges_[e].chosen = trees_.unite(edges_[e].a, edges_[e].b);
}

/// Parents before their children.
void ContactForest::orderNodes() {
    start_.assign(nodes_.size() + 1, 0);
    const auto forEachLink = [&](auto&& visit) {
        for (const Edge& e : edges_) {
            if (!e.chosen || e.b == none) continue;
            visit(e.a, e.b);
            visit(e.b, e.a);
        }
    };
    forEachLink([&](std::uint32_t from, std::uint32_t) { ++start_[from + 1]; });
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    neighbour_.resize(start_.back());
    forEachLink([&](std::uint32_t from, std::uint32_t to) { neighbour_[start_[from]++] = to; });
    for (std::size_t i = start_.size() - 1; i > 0; --i) start_[i] = start_[i - 1];
    start_[0] = 0;
    order_.clear();
    for (std::uint32_t root = 0; root < nodes_.size(); ++root) {
        if (trees_.find(root) != root) continue;
        nodes_[root].root = root;
        order_.push_back(root);
        for (auto at = order_.size() - 1; at < order_.size(); ++at) {
            const auto i = order_[at];
            for (auto k = start_[i]; k < start_[i + 1]; ++k) {
                if (neighbour_[k] == nodes_[i].parent) continue;
                nodes_[neighbour_[k]].parent = i;
                nodes_[neighbour_[k]].root = root;
                order_.push_back(neighbour_[k]);
            }
        }
    }
}

void ContactForest::grow(const State& state) {
    collectContacts(state);
    collectEdges(state);
    chooseEdges();
    orderNodes();
    collectRows(state);
    grown_ = true;
}

ContactForest::Row ContactForest::makeRow(const State& state, std::uint32_t edge,
                                          std::uint32_t contact, bool isNormal) const {
    const Contact& c = state.contacts[contact];
    const Vec2 direction = isNormal ? c.normal : tangentOf(c);
    Row row;
    row.edge = edge;
    row.isNormal = isNormal;
    const Real w = isNormal ? c.inverseEffectiveMass : c.tangentInverseMass;
    row.weight = w > 0 ? stiffnessOfPenalty / static_cast<double>(w) : 0;
    const Vector3 particle = jacobian(c.gripOfParticle, direction);
    const Vector3 capsule = -static_cast<double>(c.shareA) * jacobian(c.gripOfA, direction);
    const auto node = c.gripOfParticle.cluster != none ? nodeOfCluster_[c.gripOfParticle.cluster]
                                                       : nodeOfParticle_[c.gripOfParticle.particle];
    const bool particleFirst = node == edges_[edge].a;
    row.a = particleFirst ? particle : capsule;
    row.b = particleFirst ? capsule : particle;
    return row;
}

template <class Function>
void ContactForest::forEachMember(const Row& row, Function&& f) {
    for (auto m = row.firstMember; m != none; m = members_[m].next) f(members_[m]);
}

template <class Function>
void ContactForest::forEachMember(const Row& row, Function&& f) const {
    for (auto m = row.firstMember; m != none; m = members_[m].next) f(members_[m]);
}

/// To one that asks for the same, or as a new one.
void ContactForest::addToRows(const Row& row, std::uint32_t firstOfEdge, std::uint32_t contact) {
    const bool one = edges_[row.edge].b == none;
    auto same = std::find_if(rows_.begin() + firstOfEdge, rows_.end(), [&](const Row& other) {
        return other.isNormal == row.isNormal && areAlike(other.a, row.a) &&
               (one || areAlike(other.b, row.b));
    });
    if (same == rows_.end()) {
        rows_.push_back(row);
        same = rows_.end() - 1;
    }
    members_.push_back({.contact = contact, .next = same->firstMember});
    same->firstMember = static_cast<std::uint32_t>(members_.size() - 1);
}

void ContactForest::collectRows(const State& state) {
    rows_.clear();
    members_.clear();
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        if (!edges_[e].chosen) continue;
        const auto firstOfEdge = static_cast<std::uint32_t>(rows_.size());
        for (auto k = edges_[e].first; k < edges_[e].last; ++k)
            for (const bool isNormal : {true, false}) {
                const auto contact = keyed_[k].contact;
                addToRows(makeRow(state, e, contact, isNormal), firstOfEdge, contact);
            }
    }
}

/// Whether its normal is part of the step: it pushes, or should.
bool ContactForest::pushes(const State& state, std::uint32_t contact) const {
    const Contact& c = state.contacts[contact];
    if (given_[contact]) return false;
    return c.normalLambda > 0 || gapLeft(state, c) < (c.inherited ? 0 : mostErrorOfNew * state.h);
}

bool ContactForest::sticks(const State& state, std::uint32_t contact) const {
    const Contact& c = state.contacts[contact];
    return c.normalLambda > 0 && c.rough && !c.sliding && !slipping_[contact] &&
           c.tangentInverseMass > 0;
}

/// A row with the members that isActive(contact); what they carry tells how they share what is
/// added.
template <class IsActive, class Error>
void ContactForest::activate(const State& state, std::uint32_t index, IsActive&& isActive,
                             Error&& errorOf) {
    const Row& row = rows_[index];
    Real carried = 0, count = 0;
    forEachMember(row, [&](Member& m) {
        m.share = isActive(m.contact) ? 1 : 0;
        count += m.share;
        carried += m.share * state.contacts[m.contact].normalLambda;
    });
    if (count == 0) return;
    ActiveRow active{.row = index};
    forEachMember(row, [&](Member& m) {
        if (m.share == 0) return;
        const Contact& c = state.contacts[m.contact];
        m.share = carried > 0 ? c.normalLambda / carried : 1 / count;
        if (m.share > 0) active.error += static_cast<double>(m.share * errorOf(c));
    });
    active_.push_back(active);
}

/// Normals that push or should, tangents that stick.
void ContactForest::activateRows(const State& state) {
    active_.clear();
    for (std::uint32_t r = 0; r < rows_.size(); ++r) {
        if (!nodes_[nodes_[edges_[rows_[r].edge].a].root].unfinished) continue;
        if (rows_[r].isNormal)
            activate(
                state, r, [&](std::uint32_t contact) { return pushes(state, contact); },
                [&](const Contact& c) { return gapLeft(state, c); });
        else
            activate(
                state, r, [&](std::uint32_t contact) { return sticks(state, contact); },
                [&](const Contact& c) { return slipOf(state, c); });
    }
}

/// (M + sum of weight J^T J) u = - sum of weight J^T error.
void ContactForest::assemble(const State& state) {
    for (Node& node : nodes_) {
        node.motion.setZero();
        if (!nodes_[node.root].unfinished) continue;
        node.system = masses(state, node.cluster, node.particle).asDiagonal();
        node.towardsParent.setZero();
    }
    for (const ActiveRow& active : active_) {
        const Row& row = rows_[active.row];
        const Edge& e = edges_[row.edge];
        Node& a = nodes_[e.a];
        const Vector3 weighted = row.weight * row.a;
        a.system.noalias() += weighted * row.a.transpose();
        a.motion -= active.error * weighted;
        if (e.b == none) continue;
        Node& b = nodes_[e.b];
        const Vector3 other = row.weight * row.b;
        b.system.noalias() += other * row.b.transpose();
        b.motion -= active.error * other;
        if (a.parent == e.b)
            a.towardsParent.noalias() += weighted * row.b.transpose();
        else
            b.towardsParent.noalias() += other * row.a.transpose();
    }
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
        parent.system.noalias() -= node.towardsParent.transpose().lazyProduct(through);
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

/// How much each multiplier must change for the solution.
void ContactForest::findChanges() {
    std::fill(normalChange_.begin(), normalChange_.end(), Real(0));
    for (ActiveRow& active : active_) {
        const Row& row = rows_[active.row];
        const Edge& e = edges_[row.edge];
        double left = active.error + row.a.dot(nodes_[e.a].motion);
        if (e.b != none) left += row.b.dot(nodes_[e.b].motion);
        active.change = static_cast<Real>(-row.weight * left);
        if (row.isNormal)
            forEachMember(row, [&](const Member& m) {
                normalChange_[m.contact] = m.share * active.change;
            });
    }
}

namespace {

Real shareOf(Real room, Real change) {
    return change <= room ? Real(1) : std::max<Real>(room, 0) / change;
}

}  // namespace

/// The share of the change that a row allows: until a normal would pull ...
Real ContactForest::allowedAlong(const State& state, const ActiveRow& active) const {
    Real carried = 0;
    forEachMember(rows_[active.row], [&](const Member& m) {
        if (m.share > 0) carried += state.contacts[m.contact].normalLambda;
    });
    return shareOf(carried, -active.change);
}

/// ... or a tangent would hold by more than static friction.
Real ContactForest::allowedAcross(const State& state, const ActiveRow& active) const {
    Real allowed = 1;
    forEachMember(rows_[active.row], [&](const Member& m) {
        if (m.share == 0) return;
        const Contact& c = state.contacts[m.contact];
        const Real bound = c.staticFriction * c.normalLambda;
        const Real growth = c.staticFriction * normalChange_[m.contact];
        const Real change = m.share * active.change;
        allowed = std::min({allowed, shareOf(bound - c.tangentLambda, change - growth),
                            shareOf(bound + c.tangentLambda, -change - growth)});
    });
    return allowed;
}

/// As far as its rows allow, per tree.
void ContactForest::findSteps(const State& state) {
    for (Node& node : nodes_) node.step = 1;
    for (ActiveRow& active : active_) {
        Real& step = nodes_[treeOf(active)].step;
        active.allowed = rows_[active.row].isNormal ? allowedAlong(state, active)
                                                    : allowedAcross(state, active);
        step = std::min(step, active.allowed);
    }
}

/// Moves the nodes by what the impulses of their rows make of them.
void ContactForest::moveNodes(State& state) const {
    for (const Node& node : nodes_) {
        const Vector3 motion = static_cast<double>(nodes_[node.root].step) * node.motion;
        const Vec2 displacement = motion.head<2>().cast<Real>();
        if (node.cluster == none) {
            state.particles.displacement[node.particle] += displacement;
            continue;
        }
        Cluster& c = state.clusters.list[node.cluster];
        c.displacement += displacement;
        turnBy(c, motion[2]);
    }
}

/// Takes each tree's step, and lets go of those rows that allowed no more. Returns whether there
/// were any; of a tree in which there were none nothing is active any more.
bool ContactForest::takeStep(State& state) {
    findSteps(state);
    moveNodes(state);
    bool anyGiven = false;
    for (const ActiveRow& active : active_) {
        const Row& row = rows_[active.row];
        Node& tree = nodes_[treeOf(active)];
        const bool givesWay = tree.step < 1 && active.allowed <= tree.step;
        forEachMember(row, [&](const Member& m) {
            Contact& c = state.contacts[m.contact];
            (row.isNormal ? c.normalLambda : c.tangentLambda) +=
                tree.step * m.share * active.change;
            if (givesWay && m.share > 0) (row.isNormal ? given_ : slipping_)[m.contact] = 1;
        });
        anyGiven |= givesWay;
        tree.unfinished |= givesWay;
    }
    return anyGiven;
}

void ContactForest::forget(const State& state) {
    grown_ = false;
    nodeOfCluster_.reserve(state.clusters.list.size());
    nodeOfParticle_.reserve(state.particles.size());
    start_.reserve(state.particles.size() + 1);
    const std::size_t contacts = state.contacts.size();
    if (given_.capacity() >= contacts) return;
    given_.reserve(2 * contacts);
    slipping_.reserve(2 * contacts);
    normalChange_.reserve(2 * contacts);
}

void ContactForest::solve(State& state) {
    if (!grown_) grow(state);
    given_.assign(state.contacts.size(), 0);
    slipping_.assign(state.contacts.size(), 0);
    normalChange_.resize(state.contacts.size());
    for (Node& node : nodes_) node.unfinished = true;
    for (int i = 0; i < mostSteps; ++i) {
        activateRows(state);
        if (active_.empty()) return;
        assemble(state);
        eliminate();
        substitute();
        findChanges();
        for (Node& node : nodes_) node.unfinished = false;
        if (!takeStep(state)) return;
    }
}

}  // namespace sulfur::detail
