// Mechanisms in a step: each is up to three rows on a coordinate, of which a drive is the first.
//
// A row begins with the force of the last step, given as a blow before anything is predicted, so
// that trees, which go through the step by themselves, bear it. What the sweeps then find is only
// how it changes. A row on a tree pushes all of it at once, so that what the tree's links answer
// needs no sweeps of its own.
#include "solver/mechanisms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory_resource>
#include <span>

#include "core/disjoint_sets.hpp"
#include "core/limits.hpp"
#include "core/settings.hpp"
#include "particles/motion.hpp"
#include "rigid/grip.hpp"
#include "solver/coordinates.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// More rows in a group than that are solved one part after the other.
constexpr std::uint32_t mostRows = 64;

/// Changes velocities by an impulse (N s or N m s) along the coordinate.
void strike(State& state, const Slopes& slopes, double impulse) {
    for (const TurnedMover& m : slopes) {
        if (m.cluster == none) {
            state.particles.velocity[m.particle] += m.inverseMass * impulse * m.force;
            continue;
        }
        Cluster& c = state.clusters.list[m.cluster];
        c.velocity += m.inverseMass * impulse * m.force;
        c.spin += m.inverseInertia * impulse * m.turning;
    }
}

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

/// Multiplier (kg m or kg m^2) for 1 N or 1 N m in a step.
double multiplierPerForce(const State& state) {
    return 1 / static_cast<double>(newtonsPerMultiplier(state));
}

bool hasSpring(const Drive& drive) {
    return drive.stiffness > 0 || drive.damping > 0;
}

/// What a drive asks for in this step. `start`: the coordinate when it began.
void settle(const State& state, const Drive& drive, MechanismRow& row) {
    const double h = static_cast<double>(state.h), perForce = multiplierPerForce(state);
    const auto led = [&](double goal, double error) {
        const double most = closingSpeed * h;
        return goal + error - std::clamp(tuned::recoveryShare * error, -most, most);
    };
    const double lower = static_cast<double>(drive.lower), upper = static_cast<double>(drive.upper);
    row.lower = led(lower, std::min(row.start - lower, 0.0));
    row.upper = led(upper, std::max(row.start - upper, 0.0));
    row.rigid = drive.stiffness == infinite;
    const double rest = static_cast<double>(drive.rest);
    row.rest = row.rigid ? led(rest, row.start - rest) : rest;
    row.hk = row.rigid ? 0 : perForce * static_cast<double>(drive.stiffness);
    row.hb = perForce / h * static_cast<double>(drive.damping);
    row.way = h * static_cast<double>(drive.motorSpeed);
    if (drive.motorTarget) {
        const double left = static_cast<double>(*drive.motorTarget) - row.start;
        row.way = std::clamp(left, -std::abs(row.way), std::abs(row.way));
    }
    row.most = perForce * static_cast<double>(drive.motorMax);
}

/// A drive without limits that holds a value.
Drive holding() {
    Drive drive;
    drive.stiffness = infinite;
    return drive;
}
const Drive holds0 = holding();

const Drive& driveOf(const Mechanism& m, std::uint32_t number) {
    return number == 0 ? m.drive : holds0;
}

bool hasRow(const Mechanism& m, RowOf row) {
    if (row == RowOf::drive) return true;
    return m.kind == MechanismKind::slider && (row == RowOf::across || m.turns == 0);
}

bool canMove(const Slopes& slopes) {
    return std::any_of(slopes.begin(), slopes.end(),
                       [](const TurnedMover& m) { return m.inverseMass + m.inverseInertia > 0; });
}

/// Whether it does anything in this step. A limit that is farther away than twice what the step
/// goes does not.
bool acts(const MechanismRow& row, const Drive& drive, double now) {
    const double ahead = 2 * (now - row.start);
    return hasSpring(drive) || drive.motorMax > 0 || row.low != 0 || row.high != 0 ||
           row.start + std::min(ahead, 0.0) < row.lower ||
           row.start + std::max(ahead, 0.0) > row.upper;
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
        if (row_.lower > -any) set(row_.low, change(row_.lower), 0, any);
        if (row_.upper < any) set(row_.high, change(row_.upper), -any, 0);
    }

private:
    static constexpr double any = std::numeric_limits<double>::infinity();

    /// Of the multiplier, to get there.
    double change(double goal) const { return (goal - row_.now) / row_.mobility; }
    void set(double& multiplier, double by, double least, double most) {
        const double before = multiplier;
        multiplier = std::clamp(before + by, least, most);
        row_.now += row_.mobility * (multiplier - before);
    }
    void pullSpring() {
        if (row_.rigid) return set(row_.spring, change(row_.rest), -any, any);
        if (row_.hk + row_.hb == 0) return;
        const double wanted =
            -(row_.hk * (row_.now - row_.rest) + row_.hb * (row_.now - row_.start));
        const double steep = 1 + (row_.hk + row_.hb) * row_.mobility;
        set(row_.spring, (wanted - row_.spring) / steep, -any, any);
    }

    MechanismRow& row_;
};

/// What holds a row when the step begins: its coordinate plus `compliance` times this multiplier is
/// to be `goal`.
RowHold holdOf(const MechanismRow& row) {
    if (row.low > 0) return {&MechanismRow::low, row.lower};
    if (row.high < 0) return {&MechanismRow::high, row.upper};
    if (row.rigid) return {&MechanismRow::spring, row.rest};
    if (row.most > 0 && std::abs(row.motor) < row.most)
        return {&MechanismRow::motor, row.start + row.way};
    const double stiff = row.hk + row.hb;
    if (stiff == 0) return {};
    return {&MechanismRow::spring, (row.hk * row.rest + row.hb * row.start) / stiff, 1 / stiff};
}

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
                    factor(k, k) = sum > tuned::redundantPivot * matrix(k, k) ? sum : 0;
            }
        }
    }

    void run() {
        for (MechanismRow& row : rows_) row.change = row.sum();
        if (rows_.size() > 1) solveHeld();
        for (int i = 0; i < tuned::mostRowPasses && pass(); ++i) {
        }
        for (MechanismRow& row : rows_) row.change = row.sum() - row.change;
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

/// Gives what moves the change of a row.
void give(State& state, const MechanismRow& row) {
    if (row.change == 0) return;
    const Trees& trees = state.trees;
    for (const TurnedMover& m : row.slopes)
        if (treeOf(state, m) == none) push(state, m, row.change);
    for (const TreeAnswer& answer : row.answers) {
        if (answer.tree == none) break;
        const Tree& tree = trees.list[answer.tree];
        for (auto k = tree.first; k < tree.last; ++k)
            moveNode(state, trees.nodes[k],
                     row.change * state.mechanisms.answers[answer.first + (k - tree.first)]);
    }
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
    const auto clusters = static_cast<std::uint32_t>(state.clusters.list.size()),
               particles = static_cast<std::uint32_t>(state.particles.size());
    DisjointSets sets(count, &state.arena);
    std::pmr::vector<std::uint32_t> firstAt(clusters + particles + state.trees.list.size(), none,
                                            &state.arena);
    for (std::uint32_t i = 0; i < count; ++i)
        for (const TurnedMover& m : all.rows[i].slopes) {
            if (!(m.inverseMass + m.inverseInertia > 0)) continue;
            const auto tree = treeOf(state, m);
            const auto at = tree != none        ? clusters + particles + tree
                            : m.cluster != none ? m.cluster
                                                : clusters + m.particle;
            if (firstAt[at] == none)
                firstAt[at] = i;
            else
                sets.unite(firstAt[at], i);
        }
    // The first row of a group comes before all groups that begin later.
    std::pmr::vector<std::uint32_t> firstOf(count, none, &state.arena), order(count, &state.arena);
    for (std::uint32_t i = 0; i < count; ++i) {
        auto& first = firstOf[sets.find(i)];
        if (first == none) first = i;
        order[i] = first;
    }
    for (std::uint32_t i = 0; i < count; ++i) all.rows[i].group = order[i];
    std::stable_sort(
        all.rows.begin(), all.rows.end(),
        [](const MechanismRow& a, const MechanismRow& b) { return a.group < b.group; });
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

bool isAwake(const State& state, const Mechanism& m) {
    return state.awake(state.bodySlots.dense(m.a)) || state.awake(state.bodySlots.dense(m.b));
}

}  // namespace

void startMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    all.rows.clear();
    all.answers.clear();
    all.groups.clear();
    if (all.empty()) return;
    const double h = static_cast<double>(state.h), perForce = multiplierPerForce(state);
    for (std::uint32_t i = 0; i < all.list.size(); ++i) {
        Mechanism& m = all.list[i];
        if (!isAwake(state, m)) continue;
        for (MechanismArm& arm : m.arms)
            if (arm.from) arm.angle = angleOf(state, arm, false);
        for (const auto number : {RowOf::drive, RowOf::across, RowOf::angle}) {
            if (!hasRow(m, number)) continue;
            MechanismRow row;
            row.mechanism = i;
            row.number = static_cast<std::uint32_t>(number);
            row.slopes = slopesOf(state, m, number);
            if (!canMove(row.slopes)) continue;
            row.start = valueOf(state, m, number, false);
            const RowForces& forces = m.forces[row.number];
            row.spring = perForce * static_cast<double>(forces.spring);
            row.motor = perForce * static_cast<double>(forces.motor);
            row.low = perForce * static_cast<double>(forces.lower);
            row.high = perForce * static_cast<double>(forces.upper);
            strike(state, row.slopes, h * static_cast<double>(forces.sum()));
            all.rows.push_back(row);
        }
    }
}

void settleMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    std::erase_if(all.rows, [&](MechanismRow& row) {
        const Mechanism& m = all.list[row.mechanism];
        const Drive& drive = driveOf(m, row.number);
        settle(state, drive, row);
        return !acts(row, drive, valueOf(state, m, RowOf(row.number), true));
    });
}

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
        for (std::uint32_t k = 0; k < size; ++k)
            all.rows[group.first + k].mobility = all.numbers[group.matrix + k * size + k];
        GroupSweep(state, group).factorise();
    }
}

void solveMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    for (const MechanismGroup& group : all.groups) {
        const auto rows = std::span(all.rows).subspan(group.first, group.last - group.first);
        for (MechanismRow& row : rows)
            row.now = valueOf(state, all.list[row.mechanism], RowOf(row.number), true);
        GroupSweep(state, group).run();
        for (const MechanismRow& row : rows) give(state, row);
    }
}

void recordMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    const double perMultiplier = static_cast<double>(newtonsPerMultiplier(state));
    for (Mechanism& m : all.list)
        if (isAwake(state, m)) m.forces = {};
    for (const MechanismRow& row : all.rows) {
        const auto newtons = [&](double multiplier) {
            return static_cast<Real>(perMultiplier * multiplier);
        };
        all.list[row.mechanism].forces[row.number] = {newtons(row.spring), newtons(row.motor),
                                                      newtons(row.low), newtons(row.high)};
    }
    for (Mechanism& m : all.list) {
        const std::uint8_t lower = m.forces[0].lower > 0, upper = m.forces[0].upper < 0;
        if (lower > m.atLower || upper > m.atUpper)
            state.events.limitsReached.push_back({m.id, upper > m.atUpper});
        if (lower < m.atLower || upper < m.atUpper)
            state.events.limitsLeft.push_back({m.id, upper < m.atUpper});
        m.atLower = lower;
        m.atUpper = upper;
    }
}

}  // namespace sulfur::detail
