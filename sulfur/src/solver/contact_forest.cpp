#include "solver/contact_forest.hpp"

#include <algorithm>
#include <cmath>

#include "rigid/grip.hpp"
#include "solver/contact_motion.hpp"

namespace sulfur::detail {

namespace {

using Vector3 = Cholesky3::Vector;

/// Of the active set, in a sweep. Steps of next to nothing are usual until those rows are found
/// that give way; a tree has gone far enough when less than this share of its way is left.
constexpr int leastSteps = 2, mostSteps = 10;
constexpr Real mostLeft = Real(0.5);

/// m/s, of the largest error: a tree that something strikes. So many rows give way in it that one
/// of so many active rows is left to the sweeps (nine tenths of such work had no effect), and a
/// smaller one takes the least number of steps and lets go of all such rows at once.
constexpr double struckSpeed = 0.1;
constexpr std::uint32_t largeTree = 96;

/// As shares of the change: rows that allow no more than this beyond the step give way with the one
/// that ends it. The others may hold in the next: let go of too early, a contact pushes on although
/// it opens, and heaps begin to boil.
constexpr Real givesWayWithin = Real(0.1);

/// A tree whose last step was shorter is left to the sweeps for the rest of the tick. (A heap onto
/// which things drop has some contact that allows next to nothing in nearly every tick.)
constexpr Real leastStep = Real(0.1);

/// It is left at once when more rows than these give way, and more than one in so many.
constexpr std::uint32_t leastGiving = 96, mostGiving = 5;

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

}  // namespace

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
    activate(state, index, sum);
}

/// Tangents that stick share by what their normals carry.
void ContactForest::activateTangent(const State& state, std::uint32_t index) {
    Real sum = 0;
    for (Member& m : membersOf(rows_[index])) {
        const Carried& c = carried_[m.contact];
        m.share = m.friction > 0 && !c.slipping ? c.normal : 0;
        sum += m.share;
    }
    activate(state, index, sum);
}

/// Adds the row, unless nobody has a share of it; the shares add up to `sum`, then to 1.
void ContactForest::activate(const State& state, std::uint32_t index, Real sum) {
    if (sum == 0) return;
    const Row& row = rows_[index];
    ActiveRow active{.row = index};
    for (Member& m : membersOf(row)) {
        if (m.share == 0) continue;
        m.share /= sum;
        active.error += static_cast<double>(m.share * errorOf(state, m, row.isNormal));
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

/// ... or the tangents would hold by more than static friction, all together: they ask for the
/// same, so that one can take over from another.
Real ContactForest::allowedAcross(const ActiveRow& active) const {
    Real bound = 0, growth = 0, tangent = 0;
    for (const Member& m : membersOf(rows_[active.row])) {
        if (m.share == 0) continue;
        const Carried& c = carried_[m.contact];
        bound += m.friction * c.normal;
        growth += m.friction * c.normalChange;
        tangent += c.tangent;
    }
    return std::min(shareOf(bound - tangent, active.change - growth),
                    shareOf(bound + tangent, -active.change - growth));
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

/// What is more than the friction of a member can hold goes to those that have room for it.
void ContactForest::shareTangents(const Row& row) {
    const auto boundOf = [&](const Member& m) {
        return m.share == 0 ? Real(0) : m.friction * carried_[m.contact].normal;
    };
    Real excess = 0, room = 0;
    for (const Member& m : membersOf(row)) {
        if (m.share == 0) continue;
        Real& tangent = carried_[m.contact].tangent;
        const Real held = std::clamp(tangent, -boundOf(m), boundOf(m));
        excess += tangent - held;
        tangent = held;
    }
    if (excess == 0) return;
    const auto roomOf = [&](const Member& m) {
        const Real along = std::copysign(Real(1), excess) * carried_[m.contact].tangent;
        return m.share == 0 ? Real(0) : boundOf(m) - along;
    };
    for (const Member& m : membersOf(row)) room += roomOf(m);
    for (const Member& m : membersOf(row))
        carried_[m.contact].tangent += excess * (room > 0 ? roomOf(m) / room : m.share);
}

/// Changes the multipliers of a row by its tree's step, and lets go of it if that is all that it
/// allows.
void ContactForest::takeStepOf(const ActiveRow& active) {
    const Row& row = rows_[active.row];
    Node& tree = treeOf(row);
    const bool endsStep = tree.struck || active.allowed <= tree.step + givesWayWithin;
    const bool givesWay = active.allowed < 1 && endsStep;
    for (const Member& m : membersOf(row)) {
        Carried& c = carried_[m.contact];
        (row.isNormal ? c.normal : c.tangent) += tree.step * m.share * active.change;
        c.normal = std::max<Real>(c.normal, 0);  // (Rounding may have left it below.)
        if (givesWay && m.share > 0) (row.isNormal ? c.given : c.slipping) = true;
    }
    if (!row.isNormal) shareTangents(row);
    tree.unfinished |= givesWay;
    ++tree.activeRows;
    tree.givingRows += givesWay ? 1 : 0;
}

/// Takes each tree's step. Of a tree in which no row gave way nothing is active any more, nor, if
/// it `mayEnd`, of one that has come far.
void ContactForest::takeStep(State& state, bool mayEnd) {
    findSteps();
    moveNodes(state);
    for (Node& node : nodes_) {
        node.unfinished = false;
        node.activeRows = node.givingRows = 0;
    }
    for (const ActiveRow& active : active_) takeStepOf(active);
    for (Node& node : nodes_) {
        if (!node.unfinished) continue;
        node.left *= 1 - node.step;
        const bool mustEnd = mayEnd && (node.struck || node.left < mostLeft);
        node.hopeless = isHopeless(node) || (mustEnd && node.struck && node.step < leastStep);
        node.unfinished = !node.hopeless && !mustEnd;
    }
}

/// Finds the trees that something strikes, and leaves large ones to the sweeps. Returns whether
/// there were any such.
bool ContactForest::leaveStruck(const State& state) {
    const double most = struckSpeed * static_cast<double>(state.h);
    for (Node& node : nodes_) node.activeRows = 0;
    for (const ActiveRow& active : active_) {
        Node& tree = treeOf(rows_[active.row]);
        ++tree.activeRows;
        tree.struck |= std::abs(active.error) > most;
    }
    bool any = false;
    for (Node& node : nodes_) {
        if (!node.struck || node.activeRows < largeTree) continue;
        node.hopeless = any = true;
        node.unfinished = false;
    }
    return any;
}

void ContactForest::solve(State& state) {
    if (!grown_) grow(state);
    takeMotions(state);
    takeMultipliers(state);
    for (Node& node : nodes_) {
        node.unfinished = !node.hopeless;
        node.left = 1;
        node.struck = false;
    }
    for (int i = 1; i <= mostSteps; ++i) {
        activateRows(state);
        if (i == 1 && leaveStruck(state)) activateRows(state);
        if (active_.empty()) break;
        assemble(state);
        eliminate();
        substitute();
        findChanges();
        takeStep(state, i >= leastSteps);
    }
    for (Node& node : nodes_) node.hopeless |= node.unfinished && node.step < leastStep;
    giveMultipliers(state);
}

}  // namespace sulfur::detail
