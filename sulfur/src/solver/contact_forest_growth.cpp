// How the trees of contacts are found, and what holds in them.
#include <algorithm>
#include <bit>
#include <cmath>

#include "core/bucket_sort.hpp"
#include "rigid/grip.hpp"
#include "solver/contact_forest.hpp"
#include "solver/contact_motion.hpp"

namespace sulfur::detail {

namespace {

/// Of the penalty, in effective masses of the contact: what is left of an error is about a part in
/// so many, and rounding, in double, is far below.
constexpr double stiffnessOfPenalty = 1e5;

/// m/s: a contact that begins pushes unless it opens by more than this. (In a stack that begins to
/// fall as a whole only the lowest contact closes.)
constexpr Real mostErrorOfNew = Real(5e-5);

/// As shares of an arm: within this, rows ask for the same.
constexpr double alikeWithin = 1e-2;

/// So many contacts of an edge are compared with each.
constexpr std::uint32_t mostAlike = 16;

/// Of loads: exponents and sixteenths, the upper bits of a float.
constexpr std::uint32_t loadLevels = 1u << 12;

std::uint32_t loadLevel(Real load) {
    if (!(load > 0)) return 0;
    return std::bit_cast<std::uint32_t>(static_cast<float>(load)) >> 19;
}

/// In place of a node.
constexpr std::uint32_t still = none, soft = none - 1, unknown = none - 2;

bool isStill(const State& state, const Grip& grip) {
    if (grip.cluster == none) return state.particles.inverseMass[grip.particle] == 0;
    const Cluster& c = state.clusters.list[grip.cluster];
    return c.inverseMass == 0 && c.inverseInertia == 0;
}

using Vector3 = Cholesky3::Vector;

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

/// A heap in which so many contacts carry something has a large tree.
constexpr std::uint32_t largeHeap = 128;

/// Whether what a contact carries, or should, leaves it with an error of more than `most` m.
bool isStruck(const State& state, const Contact& c, Real most) {
    const Vec2 moved = relativeDisplacement(state, c);
    const Real gap = gapLeft(c, moved);
    if (c.normalLambda <= 0) return gap < -most;
    const bool holds = c.rough && !c.sliding && c.tangentInverseMass > 0;
    return std::abs(gap) > most || (holds && std::abs(slipOf(c, moved)) > most);
}

}  // namespace

std::uint32_t ContactForest::firstOf(const Keyed& k) {
    return static_cast<std::uint32_t>(k.nodes >> 32);
}

std::uint32_t ContactForest::secondOf(const Keyed& k) {
    return static_cast<std::uint32_t>(k.nodes);
}

void ContactForest::forget(const State& state) {
    grown_ = false;
    mayHelp_ = true;
    nodeOfCluster_.reserve(state.clusters.list.size());
    nodeOfParticle_.reserve(state.particles.size());
    start_.reserve(std::max<std::size_t>(state.particles.size(), loadLevels) + 1);
    const std::size_t contacts = state.contacts.size();
    if (carried_.capacity() < contacts) carried_.reserve(2 * contacts);
}

/// The node of what the grip holds; or `still` if it does not move, `soft` if it is part of
/// something soft.
std::uint32_t ContactForest::nodeOf(const State& state, const Grip& grip) {
    const auto node = knownNodeOf(grip);
    return node != unknown ? node : addNode(state, grip);
}

std::uint32_t ContactForest::addNode(const State& state, const Grip& grip) {
    const bool rigid = grip.cluster != none;
    auto& node = rigid ? nodeOfCluster_[grip.cluster] : nodeOfParticle_[grip.particle];
    if (isStill(state, grip)) return node = still;
    if (isSoft(state, grip)) return node = soft;
    node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_.back().cluster = grip.cluster;
    nodes_.back().particle = grip.particle;
    return node;
}

std::uint32_t ContactForest::knownNodeOf(const Grip& grip) const {
    return grip.cluster != none ? nodeOfCluster_[grip.cluster] : nodeOfParticle_[grip.particle];
}

void ContactForest::collectContacts(const State& state) {
    nodes_.clear();
    keyed_.clear();
    nodeOfCluster_.assign(state.clusters.list.size(), unknown);
    nodeOfParticle_.assign(state.particles.size(), unknown);
    for (std::uint32_t i = 0; i < state.contacts.size(); ++i) {
        const Contact& c = state.contacts[i];
        std::uint64_t a = nodeOf(state, c.gripOfParticle), b = nodeOf(state, c.gripOfA);
        if (a == soft || b == soft) continue;
        if (c.shareB != 0 && nodeOf(state, c.gripOfB) == soft) continue;
        if (a > b) std::swap(a, b);
        if (a == still) continue;
        keyed_.push_back({a << 32 | b, i});
        if (c.normalLambda > 0) ++nodes_[a].carrying;
    }
    leaveStruckHeaps(state);
    bucketSort(keyed_, keyedScratch_, start_, nodes_.size(), firstOf);
}

/// Which contacts join into heaps, whether or not a tree will have them. Returns whether any heap
/// is large.
bool ContactForest::findHeaps() {
    trees_.reset(nodes_.size());
    for (const Keyed& k : keyed_)
        if (secondOf(k) != still) trees_.unite(firstOf(k), secondOf(k));
    heaps_.assign(nodes_.size(), {});
    bool anyLarge = false;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        const auto first = trees_.find(i);
        heaps_[i].first = first;
        heaps_[first].carrying += nodes_[i].carrying;
        anyLarge |= heaps_[first].carrying >= largeHeap;
    }
    return anyLarge;
}

/// Leaves heaps to the sweeps whose tree would be large and struck, before one is grown in them:
/// where things drop onto a heap all the time, that is most of what growing would cost.
void ContactForest::leaveStruckHeaps(const State& state) {
    if (!findHeaps()) return;
    const auto heapOf = [&](const Keyed& k) -> Heap& { return heaps_[heaps_[firstOf(k)].first]; };
    const Real most = struckSpeed * state.h;
    bool anyStruck = false;
    for (const Keyed& k : keyed_) {
        Heap& heap = heapOf(k);
        if (heap.carrying < largeHeap || heap.struck) continue;
        heap.struck = isStruck(state, state.contacts[k.contact], most);
        anyStruck |= heap.struck;
    }
    if (anyStruck) std::erase_if(keyed_, [&](const Keyed& k) { return heapOf(k).struck; });
}

void ContactForest::collectEdges(const State& state) {
    edges_.clear();
    for (std::uint32_t k = 0; k < keyed_.size(); ++k) {
        const auto nodes = keyed_[k].nodes;
        if (k == 0 || keyed_[k - 1].nodes != nodes) {
            edges_.emplace_back();
            edges_.back().a = firstOf(keyed_[k]);
            const auto b = secondOf(keyed_[k]);
            edges_.back().b = b == still ? none : b;
            edges_.back().first = k;
        }
        edges_.back().last = k + 1;
        edges_.back().carried += state.contacts[keyed_[k].contact].normalLambda;
    }
}

/// A spanning forest of those edges that carry most (Kruskal), loads being told apart to a
/// sixteenth. What does not move closes no cycle.
void ContactForest::chooseEdges() {
    byLoad_.clear();
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        edges_[e].chosen = edges_[e].b == none;
        if (!edges_[e].chosen) byLoad_.push_back(e);
    }
    countingSort(byLoad_, byLoadScratch_, start_, loadLevels,
                 [&](std::uint32_t e) { return loadLevels - 1 - loadLevel(edges_[e].carried); });
    trees_.reset(nodes_.size());
    for (const auto e : byLoad_) edges_[e].chosen = trees_.unite(edges_[e].a, edges_[e].b);
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
    carried_.assign(state.contacts.size(), {});
    collectContacts(state);
    collectEdges(state);
    chooseEdges();
    orderNodes();
    collectRows(state);
    grown_ = true;
}

ContactForest::Member ContactForest::makeMember(const State& state, std::uint32_t contact,
                                                bool isNormal) const {
    const Contact& c = state.contacts[contact];
    Member m;
    m.contact = contact;
    m.direction = isNormal ? c.normal : tangentOf(c);
    m.base = isNormal ? std::max<Real>(c.gap - c.slack, 0) - c.rise : c.conveyed;
    m.shareA = c.shareA;
    const auto take = [&](const Grip& grip, Real share, Hold& hold) {
        const auto node = knownNodeOf(grip);
        if (node == still)
            m.base += share * m.direction.dot(displacementOf(state, grip));
        else
            hold = {node, grip.cluster == none ? Vec2(0, 0) : grip.arm};
    };
    take(c.gripOfParticle, 1, m.particle);
    take(c.gripOfA, -c.shareA, m.capsule);
    if (c.shareB != 0) {
        Hold second;
        take(c.gripOfB, -c.shareB, second);
        m.entire = second.node == none;
    }
    m.pushesBelow = c.inherited ? 0 : mostErrorOfNew * state.h;
    if (c.rough && !c.sliding && c.tangentInverseMass > 0) m.friction = c.staticFriction;
    return m;
}

bool ContactForest::isAlike(const Row& p, const Row& q) const {
    return areAlike(p.a, q.a) && (edges_[p.edge].b == none || areAlike(p.b, q.b));
}

/// The rows of an edge along its normals, or across them.
void ContactForest::collectRowsOf(const State& state, std::uint32_t edge, bool areNormals) {
    const Edge& e = edges_[edge];
    const auto isTaken = [&](std::uint32_t contact) { return carried_[contact].inRow; };
    for (auto k = e.first; k < e.last; ++k) carried_[keyed_[k].contact].inRow = false;
    for (auto k = e.first; k < e.last; ++k) {
        if (isTaken(keyed_[k].contact)) continue;
        Row row = makeRow(state, edge, keyed_[k].contact, areNormals);
        row.first = static_cast<std::uint32_t>(members_.size());
        for (auto other = k; other < std::min(e.last, k + mostAlike); ++other) {
            const auto contact = keyed_[other].contact;
            if (isTaken(contact)) continue;
            if (other != k && !isAlike(row, makeRow(state, edge, contact, areNormals))) continue;
            members_.push_back(makeMember(state, contact, areNormals));
            carried_[contact].inRow = true;
        }
        row.last = static_cast<std::uint32_t>(members_.size());
        rows_.push_back(row);
    }
}

void ContactForest::collectRows(const State& state) {
    rows_.clear();
    members_.clear();
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        if (!edges_[e].chosen) continue;
        collectRowsOf(state, e, true);
        collectRowsOf(state, e, false);
    }
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
    const bool particleFirst = knownNodeOf(c.gripOfParticle) == edges_[edge].a;
    row.a = particleFirst ? particle : capsule;
    row.b = particleFirst ? capsule : particle;
    return row;
}

}  // namespace sulfur::detail
