#include "solver/contact_forest.hpp"

#include <algorithm>
#include <cmath>

#include "core/pieces.hpp"
#include "rigid/grip.hpp"
#include "solver/contact_motion.hpp"

namespace sulfur::detail {

namespace {

using Vector3 = Cholesky3::Vector;

/// Of the active set, in a sweep. Steps of next to nothing are usual until those rows are found
/// that give way; a tree has gone far enough when less than this share of its way is left.
constexpr int leastSteps = 2, mostSteps = 10;
constexpr Real mostLeft = Real(0.5);

/// A tree with so many active rows is large.
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

/// In a microsecond: rows in one part of a step, nodes and multipliers that are moved to and fro.
constexpr std::size_t rowsInMicrosecond = 60, nodesInMicrosecond = 80;
constexpr std::size_t multipliersInMicrosecond = 300, clearedInMicrosecond = 1500;

}  // namespace

/// Rows are divided between edges that begin at different nodes: edges are in the order of the
/// nodes at which they begin.
void ContactForest::divide(Tasks* tasks) {
    tasks_ = tasks;
    const std::size_t count = rows_.size();
    pieceCount_ = piecesOf(tasks, count, rowsInMicrosecond);
    if (pieces_.size() < pieceCount_) pieces_.resize(pieceCount_);
    const auto begins = [&](const Row& row) { return edges_[row.edge].a; };
    const auto startOf = [&](std::size_t i) {
        auto row = pieceStart(i, pieceCount_, count);
        while (row > 0 && row < count && begins(rows_[row]) == begins(rows_[row - 1])) ++row;
        return static_cast<std::uint32_t>(row);
    };
    const auto nodeAt = [&](std::uint32_t row) {
        if (row == 0) return std::uint32_t{0};
        return row < count ? begins(rows_[row]) : static_cast<std::uint32_t>(nodes_.size());
    };
    for (std::size_t i = 0; i < pieceCount_; ++i) {
        Piece& piece = pieces_[i];
        piece.firstRow = startOf(i);
        piece.lastRow = i + 1 < pieceCount_ ? startOf(i + 1) : static_cast<std::uint32_t>(count);
        piece.leadingOn.reserve(piece.lastRow - piece.firstRow);
        piece.tallies.reserve(piece.lastRow - piece.firstRow);
        piece.firstNode = nodeAt(piece.firstRow);
        piece.lastNode =
            i + 1 < pieceCount_ ? nodeAt(piece.lastRow) : static_cast<std::uint32_t>(nodes_.size());
    }
}

template <class Function>
void ContactForest::forEachNode(Function&& f) {
    inPieces(tasks_, nodes_.size(), nodesInMicrosecond, [&](std::size_t first, std::size_t last) {
        for (auto i = first; i < last; ++i) f(nodes_[i]);
    });
}

/// Calls add(active row, its tree's tally) for the active rows of a piece.
template <class Function>
void ContactForest::tallyActive(Piece& piece, Function&& add) {
    piece.tallies.clear();
    Tally tally;
    for (ActiveRow& active : activeOf(piece)) {
        const auto root = rootOf(rows_[active.row]);
        if (root != tally.root) {
            if (tally.root != none) piece.tallies.push_back(tally);
            tally = {.root = root};
        }
        add(active, tally);
    }
    if (tally.root != none) piece.tallies.push_back(tally);
}

/// Calls f(tree, tally) for what the pieces have found.
template <class Function>
void ContactForest::forEachTally(Function&& f) {
    for (std::size_t i = 0; i < pieceCount_; ++i)
        for (const Tally& tally : pieces_[i].tallies) f(nodes_[tally.root], tally);
}

void ContactForest::takeMotions(const State& state) {
    forEachNode([&](Node& node) {
        if (node.cluster == none) {
            node.moved.displacement = state.particles.displacement[node.particle];
            return;
        }
        const Cluster& c = state.clusters.list[node.cluster];
        node.moved = {c.displacement, c.sine, c.versine};
    });
}

void ContactForest::takeMultipliers(const State& state) {
    inPieces(tasks_, keyed_.size(), multipliersInMicrosecond,
             [&](std::size_t first, std::size_t last) {
                 for (auto k = first; k < last; ++k) {
                     const Contact& c = state.contacts[keyed_[k].contact];
                     carried_[keyed_[k].contact] = {.normal = c.normalLambda,
                                                    .tangent = c.tangentLambda};
                 }
             });
}

void ContactForest::giveMultipliers(State& state) const {
    inPieces(tasks_, keyed_.size(), multipliersInMicrosecond,
             [&](std::size_t first, std::size_t last) {
                 for (auto k = first; k < last; ++k) {
                     Contact& c = state.contacts[keyed_[k].contact];
                     c.normalLambda = carried_[keyed_[k].contact].normal;
                     c.tangentLambda = carried_[keyed_[k].contact].tangent;
                 }
             });
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
void ContactForest::activateNormal(const State& state, std::uint32_t index, Piece& piece) {
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
    activate(state, index, sum, piece);
}

/// Tangents that stick share by what their normals carry.
void ContactForest::activateTangent(const State& state, std::uint32_t index, Piece& piece) {
    Real sum = 0;
    for (Member& m : membersOf(rows_[index])) {
        const Carried& c = carried_[m.contact];
        m.share = m.friction > 0 && !c.slipping ? c.normal : 0;
        sum += m.share;
    }
    activate(state, index, sum, piece);
}

/// Adds the row, unless nobody has a share of it; the shares add up to `sum`, then to 1.
void ContactForest::activate(const State& state, std::uint32_t index, Real sum, Piece& piece) {
    if (sum == 0) return;
    const Row& row = rows_[index];
    ActiveRow active{.row = index};
    for (Member& m : membersOf(row)) {
        if (m.share == 0) continue;
        m.share /= sum;
        active.error += static_cast<double>(m.share * errorOf(state, m, row.isNormal));
    }
    const auto other = edges_[row.edge].b;
    if (other != none && other >= piece.lastNode) piece.leadingOn.push_back(piece.lastActive);
    active_[piece.lastActive++] = active;
}

/// Returns whether there are any.
bool ContactForest::activateRows(const State& state) {
    active_.resize(rows_.size());
    forEachPiece([&](Piece& piece) {
        piece.firstActive = piece.lastActive = piece.firstRow;
        piece.leadingOn.clear();
        for (auto r = piece.firstRow; r < piece.lastRow; ++r) {
            if (!treeOf(rows_[r]).unfinished) continue;
            if (rows_[r].isNormal)
                activateNormal(state, r, piece);
            else
                activateTangent(state, r, piece);
        }
    });
    const auto end = pieces_.begin() + std::ptrdiff_t(pieceCount_);
    return std::any_of(pieces_.begin(), end,
                       [](const Piece& piece) { return piece.lastActive > piece.firstActive; });
}

/// How much each multiplier must change for the solution.
void ContactForest::findChanges() {
    inPieces(tasks_, carried_.size(), clearedInMicrosecond,
             [&](std::size_t first, std::size_t last) {
                 for (auto i = first; i < last; ++i) carried_[i].normalChange = 0;
             });
    forEachPiece([&](Piece& piece) {
        for (ActiveRow& active : activeOf(piece)) {
            const Row& row = rows_[active.row];
            const Edge& e = edges_[row.edge];
            double left = active.error + row.a.dot(nodes_[e.a].motion);
            if (e.b != none) left += row.b.dot(nodes_[e.b].motion);
            active.change = static_cast<Real>(-row.weight * left);
            if (!row.isNormal) continue;
            for (const Member& m : membersOf(row))
                carried_[m.contact].normalChange = m.share * active.change;
        }
    });
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
    forEachPiece([&](Piece& piece) {
        tallyActive(piece, [&](ActiveRow& active, Tally& tally) {
            const bool isNormal = rows_[active.row].isNormal;
            active.allowed = isNormal ? allowedAlong(active) : allowedAcross(active);
            tally.step = std::min(tally.step, active.allowed);
        });
    });
    forEachTally(
        [](Node& tree, const Tally& tally) { tree.step = std::min(tree.step, tally.step); });
}

/// Moves the nodes by what the impulses of their rows make of them.
void ContactForest::moveNodes(State& state) {
    forEachNode([&](Node& node) {
        const Vector3 motion = static_cast<double>(nodes_[node.root].step) * node.motion;
        const Vec2 displacement = motion.head<2>().cast<Real>();
        if (node.cluster == none) {
            state.particles.displacement[node.particle] += displacement;
            return;
        }
        Cluster& c = state.clusters.list[node.cluster];
        c.displacement += displacement;
        turnBy(c, motion[2]);
    });
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
/// allows. Returns whether it does.
bool ContactForest::takeStepOf(const ActiveRow& active) {
    const Row& row = rows_[active.row];
    const Node& tree = treeOf(row);
    const bool endsStep = tree.struck || active.allowed <= tree.step + givesWayWithin;
    const bool givesWay = active.allowed < 1 && endsStep;
    for (const Member& m : membersOf(row)) {
        Carried& c = carried_[m.contact];
        (row.isNormal ? c.normal : c.tangent) += tree.step * m.share * active.change;
        c.normal = std::max<Real>(c.normal, 0);  // (Rounding may have left it below.)
        if (givesWay && m.share > 0) (row.isNormal ? c.given : c.slipping) = true;
    }
    if (!row.isNormal) shareTangents(row);
    return givesWay;
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
    forEachPiece([&](Piece& piece) {
        tallyActive(piece, [&](const ActiveRow& active, Tally& tally) {
            ++tally.activeRows;
            tally.givingRows += takeStepOf(active) ? 1 : 0;
        });
    });
    forEachTally([](Node& tree, const Tally& tally) {
        tree.unfinished |= tally.givingRows > 0;
        tree.activeRows += tally.activeRows;
        tree.givingRows += tally.givingRows;
    });
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
    const double most = static_cast<double>(struckSpeed * state.h);
    for (Node& node : nodes_) node.activeRows = 0;
    for (std::size_t i = 0; i < pieceCount_; ++i)
        for (const ActiveRow& active : activeOf(pieces_[i])) {
            Node& tree = nodes_[rootOf(rows_[active.row])];
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
    divide(state.tasks);
    takeMotions(state);
    takeMultipliers(state);
    for (Node& node : nodes_) {
        node.unfinished = !node.hopeless;
        node.left = 1;
        node.struck = false;
    }
    for (int i = 1; i <= mostSteps; ++i) {
        bool any = activateRows(state);
        if (i == 1 && leaveStruck(state)) any = activateRows(state);
        if (!any) break;
        assemble(state);
        eliminate();
        substitute();
        findChanges();
        takeStep(state, i >= leastSteps);
    }
    for (Node& node : nodes_) node.hopeless |= node.unfinished && node.step < leastStep;
    mayHelp_ = std::any_of(rows_.begin(), rows_.end(),
                           [&](const Row& row) { return !treeOf(row).hopeless; });
    giveMultipliers(state);
}

}  // namespace sulfur::detail
