// Mechanisms in a step: each is up to three rows on a coordinate, of which a drive is the first.
//
// A row begins with the force of the last step, given as a blow before anything is predicted, so
// that trees, which go through the step by themselves, bear it. What the sweeps then find is only
// how it changes.
#include "solver/mechanisms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory_resource>
#include <span>

#include "bodies/mechanism_bodies.hpp"
#include "contacts/touch_rows.hpp"
#include "core/limits.hpp"
#include "core/settings.hpp"
#include "particles/motion.hpp"
#include "solver/coordinates.hpp"
#include "solver/rails.hpp"

namespace sulfur::detail {

namespace {

/// Multiplier (kg m or kg m^2) for 1 N or 1 N m in a step.
double multiplierPerForce(const State& state) {
    return 1 / static_cast<double>(newtonsPerMultiplier(state));
}

bool hasSpring(const Drive& drive) {
    return drive.stiffness > 0 || drive.damping > 0;
}

/// What a drive asks for in this step. `start`: the coordinate when it began. What is wrong then
/// stays so: leadMechanisms() mends it by moving places. A velocity that did would be kept by
/// whoever stands in the way, and both would push ever harder.
void settle(const State& state, const Drive& drive, const DriveLimits& limits, MechanismRow& row) {
    const double h = static_cast<double>(state.h), perForce = multiplierPerForce(state);
    row.lower = std::min(limits.lower, row.start);
    row.upper = std::max(limits.upper, row.start);
    row.rigid = drive.stiffness == infinite;
    const double rest = static_cast<double>(drive.rest);
    row.rest = row.rigid ? row.start : rest;
    row.hk = row.rigid ? 0 : perForce * static_cast<double>(drive.stiffness);
    row.hb = perForce / h * static_cast<double>(drive.damping);
    row.way = h * static_cast<double>(drive.motorSpeed);
    if (drive.motorTarget) {
        const double left = static_cast<double>(*drive.motorTarget) - row.start;
        row.way = std::clamp(left, -std::abs(row.way), std::abs(row.way));
    }
    row.bound = perForce * maxForce;
    row.most = std::min(perForce * static_cast<double>(drive.motorMax), row.bound);
}

/// A drive without limits that holds a value.
Drive holding() {
    Drive drive;
    drive.stiffness = infinite;
    return drive;
}
const Drive atZero = holding();

const Drive& driveOf(const Mechanism& m, std::uint32_t number) {
    return number == 0 ? m.drive : atZero;
}

bool hasRow(const Mechanism& m, RowOf row) {
    if (row == RowOf::drive) return true;
    return m.kind == MechanismKind::slider && (row == RowOf::across || m.turns == 0);
}

bool canMove(std::span<const TurnedMover> slopes) {
    return std::any_of(slopes.begin(), slopes.end(),
                       [](const TurnedMover& m) { return m.inverseMass + m.inverseInertia > 0; });
}

/// Who is pushed by contacts in this step: movers, and trees that have such nodes.
class Pushed {
public:
    explicit Pushed(State& state)
        : state_(state), trees_(state.trees.list.size(), unknown, &state.arena) {}

    bool any(const MechanismRow& row) {
        const auto movers = state_.mechanisms.moversOf(row);
        return std::any_of(movers.begin(), movers.end(), [&](const TurnedMover& m) {
            const auto tree = state_.trees.of(m.cluster, m.particle);
            return tree == none ? isPushed(m.cluster, m.particle) : isPushed(tree);
        });
    }

private:
    static constexpr std::uint8_t unknown = 2;

    bool isPushed(std::uint32_t cluster, std::uint32_t particle) const {
        const auto mover =
            cluster != none ? moverOfCluster(state_, cluster) : moverOfParticle(state_, particle);
        return mover != none && state_.core.movers.colours[mover] != 0;
    }
    bool isPushed(std::uint32_t tree) {
        if (trees_[tree] != unknown) return trees_[tree] != 0;
        const Tree& t = state_.trees.list[tree];
        const auto first = state_.trees.nodes.begin();
        trees_[tree] = std::any_of(first + t.first, first + t.last, [&](const TreeNode& n) {
            return (n.cluster != none || n.particle != none) && isPushed(n.cluster, n.particle);
        });
        return trees_[tree] != 0;
    }

    const State& state_;
    std::pmr::vector<std::uint8_t> trees_;
};

/// Whether it does anything in this step. A limit does not that is farther away than twice what the
/// step goes, unless contacts may push towards it.
bool acts(const MechanismRow& row, const Drive& drive, double now, Pushed& pushed) {
    if (hasSpring(drive) || drive.motorMax > 0 || row.low != 0 || row.high != 0) return true;
    const double ahead = 2 * (now - row.start);
    if (row.start + std::min(ahead, 0.0) < row.lower ||
        row.start + std::max(ahead, 0.0) > row.upper)
        return true;
    return (std::isfinite(row.lower) || std::isfinite(row.upper)) && pushed.any(row);
}

bool isAwake(const State& state, const Mechanism& m) {
    return state.awake(state.bodySlots.dense(m.a)) || state.awake(state.bodySlots.dense(m.b));
}

/// Where its arms are as the step begins.
void noteAngles(const State& state, Mechanism& m) {
    const double apart = m.angle ? angleApart(state, m, false) : 0;
    for (MechanismArm& arm : m.arms)
        if (arm.from) arm.angle = angleOf(state, arm, false);
    if (m.angle) m.arms[1].angle = m.arms[0].angle + apart;
}

/// How events name it.
MechanismId toldId(const Mechanism& m) {
    return m.angle ? MechanismId{} : m.id;
}

}  // namespace

RowHold holdOf(const MechanismRow& row) {
    if (row.low > 0) return {&MechanismRow::low, row.lower};
    if (row.high < 0) return {&MechanismRow::high, row.upper};
    if (row.rigid) return {&MechanismRow::spring, row.rest};
    if (row.most > 0 && std::abs(row.motor) < row.most)
        return {&MechanismRow::motor, row.start + row.way};
    const double stiff = row.hk + row.hb;
    // A spring so weak that roundings outweigh it holds nothing, and 1 / stiff may be no number.
    if (!(stiff * row.mobility > std::numeric_limits<double>::epsilon())) return {};
    return {&MechanismRow::spring, (row.hk * row.rest + row.hb * row.start) / stiff, 1 / stiff};
}

void startMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    all.rows.clear();
    all.movers.clear();
    all.answers.clear();
    all.groups.clear();
    if (all.empty()) return;
    const double h = static_cast<double>(state.h), perForce = multiplierPerForce(state);
    for (std::uint32_t i = 0; i < all.list.size(); ++i) {
        Mechanism& m = all.list[i];
        if (!isAwake(state, m) || isCut(state, m)) continue;
        if (!m.rail.isNothing()) followRail(state, m);
        noteAngles(state, m);
        for (const auto number : {RowOf::drive, RowOf::across, RowOf::angle}) {
            if (!hasRow(m, number)) continue;
            const CoordinateSlopes slopes = slopesOf(state, m, number);
            if (!canMove(slopes)) continue;
            MechanismRow& row = all.rows.emplace_back();
            row.mechanism = i;
            row.number = static_cast<std::uint32_t>(number);
            row.turning = turningOf(state, m, number);
            row.firstMover = static_cast<std::uint32_t>(all.movers.size());
            all.movers.insert(all.movers.end(), slopes.begin(), slopes.end());
            row.lastMover = static_cast<std::uint32_t>(all.movers.size());
            row.start = valueOf(state, m, number, false);
            const RowForces forces = m.vain[row.number] != 0 ? RowForces{} : m.forces[row.number];
            row.spring = perForce * static_cast<double>(forces.spring);
            row.motor = perForce * static_cast<double>(forces.motor);
            row.low = perForce * static_cast<double>(forces.lower);
            row.high = perForce * static_cast<double>(forces.upper);
            strike(state, slopes, h * static_cast<double>(forces.sum()));
        }
    }
}

void settleMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    if (all.rows.empty()) return;
    Pushed pushed(state);
    std::erase_if(all.rows, [&](MechanismRow& row) {
        const Mechanism& m = all.list[row.mechanism];
        const Drive& drive = driveOf(m, row.number);
        const double now = valueNow(state, row);
        const double reach = 2 * std::abs(now - row.start);
        settle(state, drive, row.number == 0 ? limitsOf(state, m, row.start, reach) : DriveLimits{},
               row);
        return !acts(row, drive, now, pushed);
    });
}

void recordMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    const double perMultiplier = static_cast<double>(newtonsPerMultiplier(state));
    for (Mechanism& m : all.list)
        if (isAwake(state, m) || isCut(state, m)) {
            m.forces = {};
            m.vain = {};
        }
    for (const MechanismRow& row : all.rows) {
        const auto newtons = [&](double multiplier) {
            return static_cast<Real>(perMultiplier * multiplier);
        };
        all.list[row.mechanism].vain[row.number] = row.vain;
        all.list[row.mechanism].forces[row.number] = {newtons(row.spring), newtons(row.motor),
                                                      newtons(row.low), newtons(row.high)};
    }
    for (Mechanism& m : all.list) {
        const std::uint8_t lower = m.forces[0].lower > 0, upper = m.forces[0].upper < 0;
        if (lower > m.atLower || upper > m.atUpper)
            state.events.limitsReached.push_back({toldId(m), upper > m.atUpper, m.angle});
        if (lower < m.atLower || upper < m.atUpper)
            state.events.limitsLeft.push_back({toldId(m), upper < m.atUpper, m.angle});
        m.atLower = lower;
        m.atUpper = upper;
    }
}

}  // namespace sulfur::detail
