// Mechanisms in the sweeps. What pushes the same things or trees is a group: it is solved in the
// space of its multipliers, where a tree is the answer of all of its links to each row.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory_resource>
#include <span>
#include <tuple>

#include "core/disjoint_sets.hpp"
#include "core/limits.hpp"
#include "core/settings.hpp"
#include "rigid/grip.hpp"
#include "solver/coordinates.hpp"
#include "solver/mechanisms.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// More rows in a group than that are solved one part after the other.
constexpr std::uint32_t mostRows = 64;
/// Of a push, that trees or other rows leave: less than that is rounding, and nothing can move.
constexpr double blocked = 1e-6;

/// Changes displacements of one mover by a push (kg m or kg m^2).
void push(State& state, const TurnedMover& m, double impulse) {
    if (m.cluster == none) {
        state.particles.displacement[m.particle] +=
            (m.inverseMass * impulse * m.force).cast<Real>();
        return;
    }
    Cluster& c = state.clusters.list[m.cluster];
    c.displacement += (m.inverseMass * impulse * m.force).cast<Real>();
    turnBy(c, m.inverseInertia * impulse * m.turning);
}

void moveNode(State& state, const TreeNode& node, const Eigen::Vector3d& by) {
    if (node.cluster != none) {
        Cluster& c = state.clusters.list[node.cluster];
        c.displacement += by.head<2>().cast<Real>();
        turnBy(c, by[2]);
    } else if (node.particle != none) {
        state.particles.displacement[node.particle] += by.head<2>().cast<Real>();
    }
}

/// The tree, moving alone, that moves it and takes part in the sweeps; or none.
std::uint32_t treeOf(const State& state, const TurnedMover& m) {
    const Trees& trees = state.trees;
    const auto tree = m.cluster != none ? trees.ofCluster[m.cluster] : trees.ofParticle[m.particle];
    const bool takesPart = tree != none && trees.list[tree].alone != 0 &&
                           trees.list[tree].network == none && trees.touched[tree] != 0;
    return takesPart ? tree : none;
}

/// What a row does where its coordinate is: spring, motor and limits, one after the other; a limit
/// has the last word. Changes its multipliers, as if nothing but itself moved it.
class RowLaw {
public:
    explicit RowLaw(MechanismRow& row) : row_(row) {}

    void run() {
        if (!(row_.mobility > 0)) return;
        pullSpring();
        if (row_.most > 0) set(row_.motor, change(row_.start + row_.way), -row_.most, row_.most);
        if (std::isfinite(row_.lower)) set(row_.low, change(row_.lower), 0, row_.bound);
        if (std::isfinite(row_.upper)) set(row_.high, change(row_.upper), -row_.bound, 0);
    }

private:
    /// Of the multiplier, to get there.
    double change(double goal) const { return (goal - row_.now) / row_.mobility; }
    void set(double& multiplier, double by, double least, double most) {
        const double before = multiplier;
        multiplier = std::clamp(before + by, least, most);
        row_.now += row_.mobility * (multiplier - before);
    }
    void pullSpring() {
        if (row_.rigid) return set(row_.spring, change(row_.rest), -row_.bound, row_.bound);
        if (row_.hk + row_.hb == 0) return;
        const double wanted =
            -(row_.hk * (row_.now - row_.rest) + row_.hb * (row_.now - row_.start));
        const double steep = 1 + (row_.hk + row_.hb) * row_.mobility;
        set(row_.spring, (wanted - row_.spring) / steep, -row_.bound, row_.bound);
    }

    MechanismRow& row_;
};

/// Rows in the space of their multipliers. What held in the last step is solved at once; then each
/// row does what its law says, until nothing changes any more.
class GroupSweep {
public:
    GroupSweep(State& state, const MechanismGroup& group)
        : rows_(std::span(state.mechanisms.rows).subspan(group.first, group.last - group.first)),
          matrix_(state.mechanisms.numbers.data() + group.matrix),
          factor_(state.mechanisms.numbers.data() + group.factor) {}

    void factorise() {
        const std::size_t n = rows_.size();
        for (std::size_t k = 0; k < n; ++k) {
            const RowHold& hold = rows_[k].hold = holdOf(rows_[k]);
            for (std::size_t j = 0; j <= k; ++j) {
                const bool both = hold.multiplier && rows_[j].hold.multiplier;
                double sum = both ? matrix(k, j) + (j == k ? hold.compliance : 0) : 0;
                for (std::size_t i = 0; i < j; ++i)
                    sum -= factor(k, i) * factor(j, i) * factor(i, i);
                if (j < k)
                    factor(k, j) = factor(j, j) > 0 ? sum / factor(j, j) : 0;
                else
                    factor(k, k) = sum > blocked * matrix(k, k) ? sum : 0;
            }
        }
    }

    /// `farthest`: rad or m, that a coordinate may go in a sweep. What asks for more asks for what
    /// cannot be.
    void run(double farthest) {
        std::array<std::array<double, 4>, mostRows> before;
        std::array<double, mostRows> from{};
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const MechanismRow& row = rows_[k];
            before[k] = {row.spring, row.motor, row.low, row.high};
            from[k] = row.now;
        }
        if (rows_.size() > 1) solveHeld();
        for (int i = 0; i < tuned::mostRowPasses && pass(); ++i) {
        }
        double way = 0;
        for (std::size_t k = 0; k < rows_.size(); ++k)
            way = std::max(way, std::abs(rows_[k].now - from[k]));
        const double share = std::min(1.0, farthest / std::max(way, 1e-300));
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            MechanismRow& row = rows_[k];
            const auto led = [&](double& multiplier, double was) {
                if (share < 1) multiplier = was + share * (multiplier - was);
            };
            led(row.spring, before[k][0]);
            led(row.motor, before[k][1]);
            led(row.low, before[k][2]);
            led(row.high, before[k][3]);
            row.change = row.sum() - (before[k][0] + before[k][1] + before[k][2] + before[k][3]);
        }
    }

    /// `row.now`: how far each coordinate is to be moved. Finds what does that, as `row.change`.
    void lead() {
        for (MechanismRow& row : rows_) row.change = 0;
        bool changed = true;
        for (int i = 0; i < tuned::mostRowPasses && changed; ++i) {
            changed = false;
            for (std::size_t k = 0; k < rows_.size(); ++k) {
                if (!(rows_[k].mobility > 0)) continue;
                const double more = rows_[k].now / rows_[k].mobility;
                rows_[k].change += more;
                for (std::size_t j = 0; j < rows_.size(); ++j) rows_[j].now -= matrix(j, k) * more;
                changed |= std::abs(more) > tuned::settledRow * std::abs(rows_[k].change);
            }
            changed &= rows_.size() > 1;
        }
    }

private:
    double& matrix(std::size_t k, std::size_t j) const { return matrix_[k * rows_.size() + j]; }
    double& factor(std::size_t k, std::size_t j) const { return factor_[k * rows_.size() + j]; }

    void solveHeld() {
        const std::size_t n = rows_.size();
        std::array<double, mostRows> x{};
        for (std::size_t k = 0; k < n; ++k) {
            const MechanismRow& row = rows_[k];
            if (!row.hold.multiplier) continue;
            x[k] = row.hold.goal - row.now - row.hold.compliance * row.*row.hold.multiplier;
            for (std::size_t j = 0; j < k; ++j) x[k] -= factor(k, j) * x[j];
        }
        for (std::size_t k = n; k-- > 0;) {
            if (!(factor(k, k) > 0)) continue;
            x[k] /= factor(k, k);
            for (std::size_t j = k + 1; j < n; ++j)
                if (factor(j, j) > 0) x[k] -= factor(j, k) * x[j];
        }
        for (std::size_t k = 0; k < n; ++k) {
            if (!(factor(k, k) > 0)) continue;
            rows_[k].*rows_[k].hold.multiplier += x[k];
            for (std::size_t j = 0; j < n; ++j) rows_[j].now += matrix(j, k) * x[k];
        }
    }

    /// Returns whether that has changed anything worth another one.
    bool pass() {
        bool changed = false;
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            MechanismRow& row = rows_[k];
            const double before = row.sum(), was = row.now;
            RowLaw(row).run();
            const double change = row.sum() - before;
            row.now = was;
            for (std::size_t j = 0; j < rows_.size(); ++j) rows_[j].now += matrix(j, k) * change;
            changed |= std::abs(change) > tuned::settledRow * std::abs(row.sum());
        }
        return changed && rows_.size() > 1;
    }

    std::span<MechanismRow> rows_;
    double* matrix_;
    double* factor_;
};

/// Gives what moves the change of a row: push(mover, change) what moves by itself, move(node, by)
/// those of trees.
template <class Push, class Move>
void give(const State& state, const MechanismRow& row, Push&& push, Move&& move) {
    if (row.change == 0) return;
    const Trees& trees = state.trees;
    for (const TurnedMover& m : row.slopes)
        if (treeOf(state, m) == none) push(m, row.change);
    for (const TreeAnswer& answer : row.answers) {
        if (answer.tree == none) break;
        const Tree& tree = trees.list[answer.tree];
        for (auto k = tree.first; k < tree.last; ++k)
            move(trees.nodes[k],
                 row.change * state.mechanisms.answers[answer.first + (k - tree.first)]);
    }
}

/// Moves places without a velocity.
void shiftNode(State& state, std::uint32_t cluster, std::uint32_t particle,
               const Eigen::Vector3d& by) {
    if (cluster != none) {
        state.clusters.list[cluster].shift += by.head<2>().cast<Real>();
        state.clusters.list[cluster].twist += by[2];
    } else if (particle != none) {
        state.particles.shift[particle] += by.head<2>().cast<Real>();
    }
}

/// How far a row's coordinate has to go in this step to be where its drive allows it.
double wayToMend(const State& state, const MechanismRow& row) {
    double goal = 0;
    if (row.number == 0) {
        const Drive& drive = state.mechanisms.list[row.mechanism].drive;
        goal = std::clamp(row.rigid ? static_cast<double>(drive.rest) : row.now,
                          static_cast<double>(drive.lower), static_cast<double>(drive.upper));
    }
    const double most = closingSpeed * static_cast<double>(state.h);
    return std::clamp(tuned::recoveryShare * (goal - row.now), -most, most);
}

/// Whether something stands in its way that gives as little as it does. Both would push ever
/// harder, if they began with that.
bool isVain(const State& state, const MechanismRow& row) {
    const RowHold hold = holdOf(row);
    if (!hold.multiplier || hold.compliance > 0) return false;
    return !(std::abs(row.now - hold.goal) <= tuned::vainSpeed * static_cast<double>(state.h));
}

/// What of a unit of the row arrives at a node of a tree.
double alongNode(const TurnedMover& m, const Eigen::Vector3d& moved) {
    return m.force.dot(moved.head<2>()) + m.turning * moved[2];
}

/// Its place among the nodes of its tree.
std::uint32_t nodeOf(const State& state, const TurnedMover& m, const Tree& tree) {
    for (auto k = tree.first; k < tree.last; ++k) {
        const TreeNode& n = state.trees.nodes[k];
        if (m.cluster != none ? n.cluster == m.cluster : n.particle == m.particle)
            return k - tree.first;
    }
    return none;
}

/// How a tree answers a row: what the row gives its nodes, and what its links then take.
void answer(State& state, MechanismRow& row, std::uint32_t tree) {
    const Tree& t = state.trees.list[tree];
    auto& answers = state.mechanisms.answers;
    const auto first = static_cast<std::uint32_t>(answers.size());
    answers.resize(answers.size() + (t.last - t.first), Eigen::Vector3d::Zero());
    for (const TurnedMover& m : row.slopes) {
        if (treeOf(state, m) != tree) continue;
        Eigen::Vector3d& own = answers[first + nodeOf(state, m, t)];
        own.head<2>() = m.inverseMass * m.force;
        own[2] = m.inverseInertia * m.turning;
    }
    answerOfTree(state, tree, std::span(answers).subspan(first, t.last - t.first));
    for (TreeAnswer& free : row.answers) {
        if (free.tree != none) continue;
        free = {tree, first};
        return;
    }
}

/// How far a unit of a row would move its coordinate if no tree held anything.
double freeMobility(const MechanismRow& row) {
    double sum = 0;
    for (const TurnedMover& m : row.slopes)
        sum += m.inverseMass * m.force.squaredNorm() + m.inverseInertia * m.turning * m.turning;
    return sum;
}

/// How far a unit of one row moves the coordinate of another one.
double response(const State& state, const MechanismRow& to, const MechanismRow& by) {
    double sum = 0;
    for (const TurnedMover& m : to.slopes) {
        const auto tree = treeOf(state, m);
        if (tree == none) {
            for (const TurnedMover& n : by.slopes)
                if (m.particle == n.particle && m.cluster == n.cluster)
                    sum += m.inverseMass * m.force.dot(n.force) +
                           m.inverseInertia * m.turning * n.turning;
            continue;
        }
        for (const TreeAnswer& answer : by.answers)
            if (answer.tree == tree)
                sum += alongNode(
                    m, state.mechanisms
                           .answers[answer.first + nodeOf(state, m, state.trees.list[tree])]);
    }
    return sum;
}

/// Joins rows that push the same things or trees.
void groupRows(State& state) {
    Mechanisms& all = state.mechanisms;
    const auto count = static_cast<std::uint32_t>(all.rows.size());
    using Pushes = std::tuple<int, std::uint32_t, std::uint32_t>;  // what kind of thing, which, row
    std::pmr::vector<Pushes> pushes(&state.arena);
    for (std::uint32_t i = 0; i < count; ++i)
        for (const TurnedMover& m : all.rows[i].slopes) {
            if (!(m.inverseMass + m.inverseInertia > 0)) continue;
            const auto tree = treeOf(state, m);
            if (tree != none)
                pushes.emplace_back(0, tree, i);
            else
                pushes.emplace_back(m.cluster != none ? 1 : 2,
                                    m.cluster != none ? m.cluster : m.particle, i);
        }
    std::sort(pushes.begin(), pushes.end());
    DisjointSets sets(count, &state.arena);
    for (std::size_t k = 1; k < pushes.size(); ++k) {
        const auto& [kind, thing, row] = pushes[k];
        const auto& [kindBefore, thingBefore, rowBefore] = pushes[k - 1];
        if (kind == kindBefore && thing == thingBefore) sets.unite(rowBefore, row);
    }
    // The first row of a group comes before all groups that begin later.
    std::pmr::vector<std::uint32_t> firstOf(count, none, &state.arena);
    for (std::uint32_t i = 0; i < count; ++i) {
        auto& first = firstOf[sets.find(i)];
        if (first == none) first = i;
        all.rows[i].group = first;
    }
    std::sort(all.rows.begin(), all.rows.end(), [](const MechanismRow& a, const MechanismRow& b) {
        return std::tuple(a.group, a.mechanism, a.number) <
               std::tuple(b.group, b.mechanism, b.number);
    });
    all.groups.clear();
    std::uint32_t places = 0;
    for (std::uint32_t first = 0, last = 0; first < count; first = last) {
        while (last < count && last - first < mostRows &&
               all.rows[last].group == all.rows[first].group)
            ++last;
        const std::uint32_t size = (last - first) * (last - first);
        all.groups.push_back({first, last, places, places + size});
        places += 2 * size;
    }
    all.numbers.assign(places, 0);
}

}  // namespace

void answerMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    if (all.rows.empty()) return;
    groupRows(state);
    for (MechanismRow& row : all.rows)
        for (const TurnedMover& m : row.slopes) {
            const auto tree = treeOf(state, m);
            const bool isNew = std::none_of(row.answers.begin(), row.answers.end(),
                                            [&](const TreeAnswer& a) { return a.tree == tree; });
            if (tree != none && isNew) answer(state, row, tree);
        }
    for (const MechanismGroup& group : all.groups) {
        const std::uint32_t size = group.last - group.first;
        for (std::uint32_t k = 0; k < size; ++k)
            for (std::uint32_t j = 0; j < size; ++j)
                all.numbers[group.matrix + k * size + j] =
                    response(state, all.rows[group.first + k], all.rows[group.first + j]);
        for (std::uint32_t k = 0; k < size; ++k) {
            MechanismRow& row = all.rows[group.first + k];
            const double own = all.numbers[group.matrix + k * size + k];
            row.mobility = own > blocked * freeMobility(row) ? own : 0;
        }
        GroupSweep(state, group).factorise();
    }
}

void solveMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    for (const MechanismGroup& group : all.groups) {
        const auto rows = std::span(all.rows).subspan(group.first, group.last - group.first);
        for (MechanismRow& row : rows)
            row.now = valueOf(state, all.list[row.mechanism], RowOf(row.number), true);
        GroupSweep(state, group).run(maxSpeed * static_cast<double>(state.h));
        for (const MechanismRow& row : rows)
            give(
                state, row, [&](const TurnedMover& m, double change) { push(state, m, change); },
                [&](const TreeNode& n, const Eigen::Vector3d& by) { moveNode(state, n, by); });
    }
}

void leadMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    for (const MechanismGroup& group : all.groups) {
        const auto rows = std::span(all.rows).subspan(group.first, group.last - group.first);
        bool any = false;
        for (MechanismRow& row : rows) {
            row.now = valueOf(state, all.list[row.mechanism], RowOf(row.number), true);
            row.vain = isVain(state, row);
            row.now = wayToMend(state, row);
            any |= row.now != 0;
        }
        if (!any) continue;
        GroupSweep(state, group).lead();
        for (const MechanismRow& row : rows)
            give(
                state, row,
                [&](const TurnedMover& m, double change) {
                    const Point way = m.inverseMass * change * m.force;
                    shiftNode(state, m.cluster, m.particle,
                              {way[0], way[1], m.inverseInertia * change * m.turning});
                },
                [&](const TreeNode& n, const Eigen::Vector3d& by) {
                    shiftNode(state, n.cluster, n.particle, by);
                });
    }
}

}  // namespace sulfur::detail
