#include "solver/contact_forest.hpp"

#include <algorithm>
#include <bit>
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

/// m/s: a contact that begins pushes unless it opens by more than this. (In a stack that begins to
/// fall as a whole only the lowest contact closes.)
constexpr Real mostErrorOfNew = Real(5e-5);

/// A tree whose last step was shorter is left to the sweeps for the rest of the tick. (A heap onto
/// which things drop has some contact that allows next to nothing in nearly every tick.)
constexpr Real leastStep = Real(0.1);

/// It is left at once when more rows than these give way, and more than one in so many.
constexpr std::uint32_t leastGiving = 96, mostGiving = 5;

/// As shares of an arm: within this, rows ask for the same.
constexpr double alikeWithin = 1e-2;

/// So many contacts of an edge are compared with each.
constexpr std::uint32_t mostAlike = 16;

/// Of loads: exponents and sixteenths, the upper bits of a float.
constexpr std::uint32_t loadLevels = 1u << 12;

std::uint32_t loadLevel(Real load) {
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

/// The node of what the grip holds; or `still` if it does not move, `soft` if it is part of
/// something soft.
std::uint32_t ContactForest::nodeOf(const State& state, const Grip& grip) {
    const bool rigid = grip.cluster != none;
    auto& node = rigid ? nodeOfCluster_[grip.cluster] : nodeOfParticle_[grip.particle];
    if (node != unknown) return node;
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
        if (a != still) keyed_.push_back({a << 32 | b, i});
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
            const auto b = static_cast<std::uint32_t>(nodes);
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
    const auto isTaken = [&](std::uint32_t contact) { return carried_[contact].given; };
    for (auto k = e.first; k < e.last; ++k) carried_[keyed_[k].contact].given = false;
    for (auto k = e.first; k < e.last; ++k) {
        if (isTaken(keyed_[k].contact)) continue;
        Row row = makeRow(state, edge, keyed_[k].contact, areNormals);
        row.first = static_cast<std::uint32_t>(members_.size());
        for (auto other = k; other < std::min(e.last, k + mostAlike); ++other) {
            const auto contact = keyed_[other].contact;
            if (isTaken(contact)) continue;
            if (other != k && !isAlike(row, makeRow(state, edge, contact, areNormals))) continue;
            members_.push_back(makeMember(state, contact, areNormals));
            carried_[contact].given = true;
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

void ContactForest::takeMotions(const State& state) {
    for (Node& node : nodes_) {
        if (node.cluster == none) {
            node.moved.displacement = state.particles.displacement[node.particle];
            continue;
        }
        const Cluster& c = state.clusters.list[node.cluster];
        node.moved = {c.displacement, c.sine, c.versine};
    }
}

void ContactForest::takeMultipliers(const State& state) {
    for (const Keyed& k : keyed_) {
        const Contact& c = state.contacts[k.contact];
        carried_[k.contact] = {.normal = c.normalLambda, .tangent = c.tangentLambda};
    }
}

void ContactForest::giveMultipliers(State& state) const {
    for (const Keyed& k : keyed_) {
        Contact& c = state.contacts[k.contact];
        c.normalLambda = carried_[k.contact].normal;
        c.tangentLambda = carried_[k.contact].tangent;
    }
}

Vec2 ContactForest::wayOf(const Hold& hold) const {
    const Motion& m = nodes_[hold.node].moved;
    return m.displacement + m.sine * perpendicular(hold.arm) - m.versine * hold.arm;
}

Real ContactForest::errorOf(const State& state, const Member& m, bool isNormal) const {
    if (!m.entire) {
        const Contact& c = state.contacts[m.contact];
        return isNormal ? gapLeft(state, c) : slipOf(state, c);
    }
    Vec2 way(0, 0);
    if (m.particle.node != none) way += wayOf(m.particle);
    if (m.capsule.node != none) way -= m.shareA * wayOf(m.capsule);
    return m.base + m.direction.dot(way);
}

/// Normals that push share what is added as they share what there is; where none does, those that
/// should push begin alike.
void ContactForest::activateNormal(const State& state, std::uint32_t index) {
    const std::span<Member> members = membersOf(rows_[index]);
    ActiveRow active{.row = index};
    Real sum = 0;
    for (Member& m : members) {
        const Carried& c = carried_[m.contact];
        m.share = c.given ? 0 : c.normal;
        sum += m.share;
    }
    if (sum == 0)
        for (Member& m : members) {
            if (carried_[m.contact].given || errorOf(state, m, true) >= m.pushesBelow) continue;
            m.share = 1;
            sum += 1;
        }
    if (sum == 0) return;
    for (Member& m : members) {
        if (m.share == 0) continue;
        m.share /= sum;
        active.error += static_cast<double>(m.share * errorOf(state, m, true));
    }
    active_.push_back(active);
}

/// Tangents that stick share by what their normals carry.
void ContactForest::activateTangent(const State& state, std::uint32_t index) {
    const std::span<Member> members = membersOf(rows_[index]);
    ActiveRow active{.row = index};
    Real sum = 0;
    for (Member& m : members) {
        const Carried& c = carried_[m.contact];
        m.share = m.friction > 0 && !c.slipping ? c.normal : 0;
        sum += m.share;
    }
    if (sum == 0) return;
    for (Member& m : members) {
        if (m.share == 0) continue;
        m.share /= sum;
        active.error += static_cast<double>(m.share * errorOf(state, m, false));
    }
    active_.push_back(active);
}

void ContactForest::activateRows(const State& state) {
    active_.clear();
    for (std::uint32_t r = 0; r < rows_.size(); ++r) {
        if (!treeOf(rows_[r]).unfinished) continue;
        if (rows_[r].isNormal)
            activateNormal(state, r);
        else
            activateTangent(state, r);
    }
}

namespace {

/// Adds weight * v v^T to the lower half.
void addSquare(Cholesky3::Matrix& lower, const Vector3& v, const Vector3& weighted) {
    for (int column = 0; column < 3; ++column)
        for (int row = column; row < 3; ++row) lower(row, column) += weighted[row] * v[column];
}

}  // namespace

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
        addSquare(a.system, row.a, weighted);
        a.motion -= active.error * weighted;
        if (e.b == none) continue;
        Node& b = nodes_[e.b];
        const Vector3 other = row.weight * row.b;
        addSquare(b.system, row.b, other);
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

/// How much each multiplier must change for the solution.
void ContactForest::findChanges() {
    for (Carried& c : carried_) c.normalChange = 0;
    for (ActiveRow& active : active_) {
        const Row& row = rows_[active.row];
        const Edge& e = edges_[row.edge];
        double left = active.error + row.a.dot(nodes_[e.a].motion);
        if (e.b != none) left += row.b.dot(nodes_[e.b].motion);
        active.change = static_cast<Real>(-row.weight * left);
        if (!row.isNormal) continue;
        for (const Member& m : membersOf(row))
            carried_[m.contact].normalChange = m.share * active.change;
    }
}

namespace {

Real shareOf(Real room, Real change) {
    return change <= room ? Real(1) : std::max<Real>(room, 0) / change;
}

}  // namespace

/// The share of the change that a row allows: until a normal would pull ...
Real ContactForest::allowedAlong(const ActiveRow& active) const {
    Real sum = 0;
    for (const Member& m : membersOf(rows_[active.row]))
        if (m.share > 0) sum += carried_[m.contact].normal;
    return shareOf(sum, -active.change);
}

/// ... or a tangent would hold by more than static friction.
Real ContactForest::allowedAcross(const ActiveRow& active) const {
    Real allowed = 1;
    for (const Member& m : membersOf(rows_[active.row])) {
        if (m.share == 0) continue;
        const Carried& c = carried_[m.contact];
        const Real bound = m.friction * c.normal, growth = m.friction * c.normalChange;
        const Real change = m.share * active.change;
        allowed = std::min({allowed, shareOf(bound - c.tangent, change - growth),
                            shareOf(bound + c.tangent, -change - growth)});
    }
    return allowed;
}

/// As far as its rows allow, per tree.
void ContactForest::findSteps() {
    for (Node& node : nodes_) node.step = 1;
    for (ActiveRow& active : active_) {
        const Row& row = rows_[active.row];
        active.allowed = row.isNormal ? allowedAlong(active) : allowedAcross(active);
        Real& step = treeOf(row).step;
        step = std::min(step, active.allowed);
    }
}

/// Moves the nodes by what the impulses of their rows make of them.
void ContactForest::moveNodes(State& state) {
    for (Node& node : nodes_) {
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
    takeMotions(state);
}

/// Whether so many rows give way that one step more would not bring it far either.
bool ContactForest::isHopeless(const Node& tree) {
    return tree.step < leastStep && tree.givingRows > leastGiving &&
           mostGiving * tree.givingRows > tree.activeRows;
}

/// Takes each tree's step, and lets go of those rows that did not allow all of it: of all at once,
/// because a large tree has many. Returns whether there were any; of a tree in which there were
/// none nothing is active any more.
bool ContactForest::takeStep(State& state) {
    findSteps();
    moveNodes(state);
    for (Node& node : nodes_) {
        node.unfinished = false;
        node.activeRows = node.givingRows = 0;
    }
    bool anyGiven = false;
    for (const ActiveRow& active : active_) {
        const Row& row = rows_[active.row];
        Node& tree = treeOf(row);
        const bool givesWay = active.allowed < 1;
        for (const Member& m : membersOf(row)) {
            Carried& c = carried_[m.contact];
            (row.isNormal ? c.normal : c.tangent) += tree.step * m.share * active.change;
            if (givesWay && m.share > 0) (row.isNormal ? c.given : c.slipping) = true;
        }
        anyGiven |= givesWay;
        tree.unfinished |= givesWay;
        ++tree.activeRows;
        tree.givingRows += givesWay ? 1 : 0;
    }
    for (Node& node : nodes_) {
        if (!node.unfinished || !isHopeless(node)) continue;
        node.unfinished = false;
        node.hopeless = true;
    }
    return anyGiven;
}

void ContactForest::forget(const State& state) {
    grown_ = false;
    nodeOfCluster_.reserve(state.clusters.list.size());
    nodeOfParticle_.reserve(state.particles.size());
    start_.reserve(std::max<std::size_t>(state.particles.size(), loadLevels) + 1);
    const std::size_t contacts = state.contacts.size();
    if (carried_.capacity() < contacts) carried_.reserve(2 * contacts);
}

void ContactForest::solve(State& state) {
    if (!grown_) grow(state);
    takeMotions(state);
    takeMultipliers(state);
    for (Node& node : nodes_) node.unfinished = !node.hopeless;
    for (int i = 0; i < mostSteps; ++i) {
        activateRows(state);
        if (active_.empty()) break;
        assemble(state);
        eliminate();
        substitute();
        findChanges();
        if (!takeStep(state)) break;
    }
    for (Node& node : nodes_) node.hopeless |= node.unfinished && node.step < leastStep;
    giveMultipliers(state);
}

}  // namespace sulfur::detail
