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
#include "solver/group_sweep.hpp"
#include "solver/mechanisms.hpp"
#include "solver/rails.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

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
    const auto tree = trees.of(m.cluster, m.particle);
    const bool takesPart = tree != none && trees.list[tree].alone != 0 &&
                           trees.list[tree].network == none && trees.touched[tree] != 0;
    return takesPart ? tree : none;
}

/// The answer of a tree to a row, or null.
const Eigen::Vector3d* answerOf(const State& state, const MechanismRow& row, std::uint32_t tree) {
    for (const TreeAnswer& answer : row.answers)
        if (answer.tree == tree) return &state.mechanisms.answers[answer.first];
    return nullptr;
}

using NodeMoves = std::pmr::vector<Eigen::Vector3d>;

/// Gives what moves the changes of a group: push(mover, change) what moves by itself, move(node,
/// by) those of trees, each once.
/// `sum`: room for what a tree gets.
template <class Push, class Move>
void give(const State& state, const MechanismGroup& group, NodeMoves& sum, Push&& push,
          Move&& move) {
    const Mechanisms& all = state.mechanisms;
    const auto rows = std::span(all.rows).subspan(group.first, group.last - group.first);
    for (const MechanismRow& row : rows)
        for (auto k = row.firstMover; k < row.lastMover && row.change != 0; ++k)
            if (all.nodes[k] == none) push(all.movers[k], row.change);
    for (auto t = group.firstTree; t < group.lastTree; ++t) {
        const Tree& tree = state.trees.list[all.trees[t]];
        const std::size_t count = tree.last - tree.first;
        sum.assign(count, Eigen::Vector3d::Zero());
        for (const MechanismRow& row : rows) {
            const Eigen::Vector3d* answer =
                row.change != 0 ? answerOf(state, row, all.trees[t]) : nullptr;
            for (std::size_t k = 0; k < count && answer; ++k) sum[k] += row.change * answer[k];
        }
        for (std::size_t k = 0; k < count; ++k)
            if (!sum[k].isZero(0)) move(state.trees.nodes[tree.first + k], sum[k]);
    }
}

/// Moves places without a velocity.
void shiftNode(State& state, std::uint32_t cluster, std::uint32_t particle,
               const Eigen::Vector3d& by) {
    if (cluster != none) {
        state.clusters.list[cluster].shift += by.head<2>().cast<Real>();
        state.clusters.list[cluster].twist += by[2];
    } else if (particle != none) {
        state.particles.position[particle] += by.head<2>();
    }
}

/// How far a row's coordinate has to go in this step to be where its drive allows it.
double wayToMend(const State& state, const MechanismRow& row) {
    double goal = 0;
    if (row.number == 0) {
        const Mechanism& m = state.mechanisms.list[row.mechanism];
        const DriveLimits limits = limitsOf(state, m, row.now, 0);
        goal = std::clamp(row.rigid ? static_cast<double>(m.drive.rest) : row.now, limits.lower,
                          limits.upper);
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

bool hasNode(const Tree& tree, std::uint32_t node) {
    return node >= tree.first && node < tree.last;
}

/// Its node in a tree.
std::uint32_t nodeOf(const State& state, const TurnedMover& m, const Tree& tree) {
    for (auto k = tree.first; k < tree.last; ++k) {
        const TreeNode& n = state.trees.nodes[k];
        if (m.cluster != none ? n.cluster == m.cluster : n.particle == m.particle) return k;
    }
    return none;
}

/// Makes room for the answer of a tree to a row, and puts there what the row gives its nodes.
std::span<Eigen::Vector3d> beginAnswer(State& state, MechanismRow& row, std::uint32_t tree) {
    const Tree& t = state.trees.list[tree];
    auto& answers = state.mechanisms.answers;
    const auto first = static_cast<std::uint32_t>(answers.size());
    answers.resize(answers.size() + (t.last - t.first), Eigen::Vector3d::Zero());
    for (auto k = row.firstMover; k < row.lastMover; ++k) {
        const TurnedMover& m = state.mechanisms.movers[k];
        const auto node = state.mechanisms.nodes[k];
        if (!hasNode(t, node)) continue;
        Eigen::Vector3d& own = answers[first + (node - t.first)];
        own.head<2>() = m.inverseMass * m.force;
        own[2] = m.inverseInertia * m.turning;
    }
    for (TreeAnswer& free : row.answers)
        if (free.tree == none) {
            free = {tree, first};
            break;
        }
    return std::span(answers).subspan(first, t.last - t.first);
}

/// How what has been eliminated last answers: those of the rows one after the other.
template <int N>
void answerInLanes(State& state, std::span<Eigen::Vector3d> given) {
    using Lanes = typename Elimination<N>::Lanes;
    constexpr auto most = static_cast<std::size_t>(Elimination<N>::lanes);
    auto& elimination = state.trees.scratch.elimination<N>();
    const std::size_t count = elimination.nodes.size();
    std::pmr::vector<Lanes> x(count, &state.arena);
    for (; !given.empty(); given = given.subspan(std::min(given.size(), most * count))) {
        const std::size_t sides = std::min(given.size() / count, most);
        std::fill(x.begin(), x.end(), Lanes::Zero());
        const auto forEach = [&](auto&& f) {
            for (std::size_t lane = 0; lane < sides; ++lane)
                for (std::size_t k = 0; k < count; ++k)
                    f(given[lane * count + k].template head<N>(),
                      x[k].col(static_cast<int>(lane)).matrix());
        };
        forEach([](const auto& one, auto&& lane) { lane = one; });
        elimination.answer(std::span(x));
        forEach([](auto&& one, const auto& lane) { one = lane; });
    }
}

/// Finds the trees that a group pushes, and how each answers its rows.
void answerGroup(State& state, MechanismGroup& group) {
    Mechanisms& all = state.mechanisms;
    const auto rows = std::span(all.rows).subspan(group.first, group.last - group.first);
    group.firstTree = static_cast<std::uint32_t>(all.trees.size());
    for (const MechanismRow& row : rows)
        for (auto k = row.firstMover; k < row.lastMover; ++k) {
            const auto tree = treeOf(state, all.movers[k]);
            if (tree == none) continue;
            all.nodes[k] = nodeOf(state, all.movers[k], state.trees.list[tree]);
            if (std::find(all.trees.begin() + group.firstTree, all.trees.end(), tree) ==
                all.trees.end())
                all.trees.push_back(tree);
        }
    group.lastTree = static_cast<std::uint32_t>(all.trees.size());
    for (auto k = group.firstTree; k < group.lastTree; ++k) {
        const Tree& tree = state.trees.list[all.trees[k]];
        std::size_t others = 0;  // place of the answers to all rows but the first
        for (MechanismRow& row : rows) {
            const auto nodes = all.nodesOf(row);
            if (std::none_of(nodes.begin(), nodes.end(),
                             [&](auto node) { return hasNode(tree, node); }))
                continue;
            const auto given = beginAnswer(state, row, all.trees[k]);
            if (others != 0) continue;
            answerOfTree(state, all.trees[k], given);
            others = all.answers.size();
        }
        const auto left = std::span(all.answers).subspan(others);
        if (tree.points)
            answerInLanes<2>(state, left);
        else
            answerInLanes<3>(state, left);
    }
}

/// How far a unit of one row moves the coordinate of another one. It is the same both ways.
double response(const State& state, const MechanismRow& to, const MechanismRow& by) {
    const Mechanisms& all = state.mechanisms;
    double sum = 0;
    for (auto k = to.firstMover; k < to.lastMover; ++k) {
        const TurnedMover& m = all.movers[k];
        const auto node = all.nodes[k];
        if (node == none) {
            for (const TurnedMover& n : all.moversOf(by))
                if (m.particle == n.particle && m.cluster == n.cluster)
                    sum += m.inverseMass * m.force.dot(n.force) +
                           m.inverseInertia * m.turning * n.turning;
            continue;
        }
        for (const TreeAnswer& answer : by.answers) {
            if (answer.tree == none) break;
            const Tree& tree = state.trees.list[answer.tree];
            if (hasNode(tree, node))
                sum += alongNode(m, all.answers[answer.first + (node - tree.first)]);
        }
    }
    return sum;
}

/// What a group needs for its sweeps: how its rows move each other.
void prepareGroup(State& state, const MechanismGroup& group) {
    Mechanisms& all = state.mechanisms;
    const auto rows = std::span(all.rows).subspan(group.first, group.last - group.first);
    const std::size_t size = rows.size();
    double* matrix = all.numbers.data() + group.matrix;
    for (std::size_t k = 0; k < size; ++k) {
        for (std::size_t j = 0; j <= k; ++j)
            matrix[k * size + j] = matrix[j * size + k] = response(state, rows[k], rows[j]);
        const double own = matrix[k * size + k];
        rows[k].mobility =
            own > GroupSweep::blocked * freeMobility(all.moversOf(rows[k])) ? own : 0;
    }
    GroupSweep(state, group).factorise();
}

/// Joins rows that push the same things or trees.
void groupRows(State& state) {
    Mechanisms& all = state.mechanisms;
    const auto count = static_cast<std::uint32_t>(all.rows.size());
    using Pushes = std::tuple<int, std::uint32_t, std::uint32_t>;  // what kind of thing, which, row
    std::pmr::vector<Pushes> pushes(&state.arena);
    for (std::uint32_t i = 0; i < count; ++i)
        for (const TurnedMover& m : all.moversOf(all.rows[i])) {
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
    const auto isBefore = [](const MechanismRow& a, const MechanismRow& b) {
        return std::tuple(a.group, a.mechanism, a.number) <
               std::tuple(b.group, b.mechanism, b.number);
    };
    // They mostly are in order already.
    if (!std::is_sorted(all.rows.begin(), all.rows.end(), isBefore))
        std::sort(all.rows.begin(), all.rows.end(), isBefore);
    all.groups.clear();
    std::uint32_t places = 0;
    for (std::uint32_t first = 0, last = 0; first < count; first = last) {
        while (last < count && last - first < GroupSweep::mostRows &&
               all.rows[last].group == all.rows[first].group)
            ++last;
        const std::uint32_t size = (last - first) * (last - first);
        all.groups.push_back({first, last, places, places + size, 0, 0});
        places += 2 * size;
    }
    all.numbers.assign(places, 0);
}

}  // namespace

void answerMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    if (all.rows.empty()) return;
    groupRows(state);
    all.nodes.assign(all.movers.size(), none);
    all.trees.clear();
    for (MechanismGroup& group : all.groups) {
        answerGroup(state, group);
        prepareGroup(state, group);
    }
}

void solveMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    NodeMoves sum(&state.arena);
    for (const MechanismGroup& group : all.groups) {
        const auto rows = std::span(all.rows).subspan(group.first, group.last - group.first);
        for (MechanismRow& row : rows) row.now = valueNow(state, row);
        GroupSweep(state, group).run(maxSpeed * static_cast<double>(state.h));
        give(
            state, group, sum, [&](const TurnedMover& m, double change) { push(state, m, change); },
            [&](const TreeNode& n, const Eigen::Vector3d& by) { moveNode(state, n, by); });
    }
}

void leadMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    NodeMoves sum(&state.arena);
    for (const MechanismGroup& group : all.groups) {
        const auto rows = std::span(all.rows).subspan(group.first, group.last - group.first);
        bool any = false;
        for (MechanismRow& row : rows) {
            row.now = valueNow(state, row);
            row.vain = isVain(state, row);
            row.now = wayToMend(state, row);
            any |= row.now != 0;
        }
        if (!any) continue;
        GroupSweep(state, group).lead();
        give(
            state, group, sum,
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
