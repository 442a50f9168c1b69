#include "trees/network_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "core/settings.hpp"
#include "model/slow_speeds.hpp"
#include "rigid/grip.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

NetworkContacts::NetworkContacts(State& state, std::uint32_t group)
    : state_(state),
      number_(group),
      group_(state.trees.networkGroups[group]),
      work_(state.trees.networkSweep),
      settled_(static_cast<double>(slowSpeedsOf(state.settings).settledChange * state.h)) {}

// --- what touches ------------------------------------------------------------------------------

void NetworkContacts::list() {
    work_.contacts.clear();
    work_.bodies.clear();
    const auto& all = state_.trees.networkTouches;
    const auto isBefore = [](const NetworkTouch& a, std::uint32_t n) { return a.group < n; };
    auto held = std::lower_bound(all.begin(), all.end(), number_, isBefore);
    for (; held != all.end() && held->group == number_; ++held) addTouch(*held);
}

/// A contact, and its friction after it.
void NetworkContacts::addTouch(const NetworkTouch& held) {
    const TouchView t = viewOfTouch(state_, held.touch);
    const auto normal = static_cast<std::uint32_t>(rows());
    addRow(held, t, t.normal);
    PressedRow& pressed = work_.contacts.back();
    // What overlaps already is pushed apart without a velocity.
    pressed.value = static_cast<double>(t.gap) - std::min(static_cast<double>(t.gapBefore), 0.0);
    pressed.overlap = -static_cast<double>(t.gapBefore) - static_cast<double>(t.slop);
    pressed.before = static_cast<double>(t.pressing);
    if (!(t.staticFriction > 0)) return;
    addRow(held, t, t.tangent);
    PressedRow& rubs = work_.contacts.back();
    rubs.normal = normal;
    rubs.value = static_cast<double>(t.slide);
    rubs.before = static_cast<double>(t.rubbing);
    rubs.brake = static_cast<double>(t.kineticFriction);
    rubs.hold = static_cast<double>(t.staticFriction);
}

void NetworkContacts::addRow(const NetworkTouch& held, const TouchView& t,
                             const TouchDirection& d) {
    PressedRow row;
    row.touch = held.touch;
    row.nodes = held.nodes;
    for (std::size_t k = 0; k < 3; ++k) {
        const Freedoms along(static_cast<double>(d.ways[k][0]), static_cast<double>(d.ways[k][1]),
                             static_cast<double>(d.arms[k]));
        if (row.nodes[k] != none) {
            const auto& of = group_.trees;
            const auto member = std::lower_bound(of.begin(), of.end(), held.trees[k]) - of.begin();
            row.members[k] = static_cast<std::uint32_t>(member);
            row.along[k] =
                ofMovable(along, work_.members[row.members[k]].inverseMass[row.nodes[k]]);
            continue;
        }
        const SolverBody& body = state_.core.movers.bodies[t.movers[k]];
        const auto w = static_cast<double>(body.inverseMass);
        const Freedoms inverseMass(w, w, static_cast<double>(body.inverseInertia));
        row.along[k] = ofMovable(along, inverseMass);
        if (!row.along[k].isZero(0)) row.bodies[k] = bodyOf(t.movers[k], inverseMass);
    }
    work_.contacts.push_back(row);
}

std::uint32_t NetworkContacts::bodyOf(std::uint32_t mover, const Freedoms& inverseMass) {
    const auto known = std::find_if(work_.bodies.begin(), work_.bodies.end(),
                                    [&](const auto& b) { return b.mover == mover; });
    const auto b = static_cast<std::uint32_t>(known - work_.bodies.begin());
    if (known == work_.bodies.end()) work_.bodies.push_back({mover, inverseMass});
    return b;
}

// --- how it answers ----------------------------------------------------------------------------

double NetworkContacts::along(const PressedRow& row, Vectors of) const {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (row.nodes[k] != none)
            sum += row.along[k].dot((work_.members[row.members[k]].*of)[row.nodes[k]]);
    return sum;
}
/// Adds what the nodes of a row get by so much of it.
void NetworkContacts::addTo(Vectors of, const PressedRow& row, double amount) {
    for (std::size_t k = 0; k < 3; ++k)
        if (row.nodes[k] != none)
            (work_.members[row.members[k]].*of)[row.nodes[k]] += amount * row.along[k];
}

/// Gap or slide now.
double NetworkContacts::valueOf(const PressedRow& row) const {
    double value = row.value + along(row, &NetworkMember::moved);
    for (std::size_t k = 0; k < 3; ++k)
        if (row.bodies[k] != none) value += row.along[k].dot(work_.bodies[row.bodies[k]].moved);
    return value;
}

bool NetworkContacts::areKnown() const {
    return group_.answers.size() == rows() * rows();
}

/// 1/kg, without the network: by the bodies that both push.
double NetworkContacts::ownAnswer(std::size_t i, std::size_t j) const {
    const PressedRow &a = work_.contacts[i], &b = work_.contacts[j];
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (a.bodies[k] == none) continue;
        for (std::size_t m = 0; m < 3; ++m)
            if (a.bodies[k] == b.bodies[m])
                sum +=
                    a.along[k].cwiseProduct(b.along[m]).dot(work_.bodies[a.bodies[k]].inverseMass);
    }
    return sum;
}

void NetworkContacts::findAnswers() {
    const std::size_t count = rows();
    auto& answers = group_.answers;
    answers.assign(count * count, 0);
    std::pmr::vector<PressedRow> pressed(&state_.arena);
    for (std::uint32_t m = 0; m < group_.trees.size(); ++m) {
        pressed.assign(count, {});
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const PressedRow& row = work_.contacts[i];
                if (row.nodes[k] == none || row.members[k] != m) continue;
                pressed[i].nodes[k] = row.nodes[k];
                pressed[i].along[k] = row.along[k];
            }
        const Tree& tree = state_.trees.list[group_.trees[m]];
        NetworkFactor& factor = state_.trees.factors[tree.network];
        addAnswersOfNetwork(state_, tree, factor.swept, pressed, answers);
        group_.work += 2 * count * factor.pattern.entries();
    }
    for (std::size_t j = 0; j < count; ++j)
        for (std::size_t i = 0; i < count; ++i) answers[j * count + i] += ownAnswer(i, j);
}

// --- what presses ------------------------------------------------------------------------------

void NetworkContacts::bound() {
    double mass = 0, closing = 0;
    const auto add = [&](const Freedoms& inverseMass) {
        if (inverseMass[0] > 0) mass += 1 / inverseMass[0];
    };
    for (std::size_t m = 0; m < group_.trees.size(); ++m)
        for (const Freedoms& w : work_.members[m].inverseMass) add(w);
    for (const PressingBody& body : work_.bodies) add(body.inverseMass);
    for (const PressedRow& row : work_.contacts)
        if (row.normal == none) closing = std::max(closing, -valueOf(row));
    group_.mostPressing = mostPressing(state_, mass, closing);
}

/// As much of a multiplier as the laws of contact and friction allow.
double NetworkContacts::allowed(const PressedRow& row, double total) const {
    if (row.normal == none) return std::clamp(total, 0.0, group_.mostPressing);
    const PressedRow& normal = work_.contacts[row.normal];
    const double pressing = std::max(normal.before + normal.pressed + normal.change, 0.0);
    const bool sticks = std::abs(total) <= row.hold * pressing;
    const double most = (sticks ? row.hold : row.brake) * pressing;
    return std::clamp(total, -most, most);
}

/// Projected Gauss-Seidel. `values`: of the rows before any change, m.
template <class Total, class Law>
void NetworkContacts::relax(std::span<double> values, Total&& totalOf, Law&& law) {
    const auto& answers = group_.answers;
    auto& rows = work_.contacts;
    for (int pass = 0; pass < tuned::networkContactPasses; ++pass) {
        double most = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double answer = answers[i * rows.size() + i], total = totalOf(rows[i]);
            if (!(answer > 0)) continue;
            const double change = law(rows[i], total - values[i] / answer) - total;
            if (change == 0) continue;
            rows[i].change += change;
            most = std::max(most, std::abs(change) * answer);
            const auto count = static_cast<Eigen::Index>(rows.size());
            Eigen::Map<Eigen::VectorXd>(values.data(), count) +=
                change * Eigen::Map<const Eigen::VectorXd>(&answers[i * rows.size()], count);
        }
        if (most <= settled_ / tuned::rounds) break;
    }
}

void NetworkContacts::solve() {
    std::pmr::vector<double> values(rows(), 0, &state_.arena);
    for (std::size_t i = 0; i < rows(); ++i) {
        work_.contacts[i].change = 0;
        values[i] = valueOf(work_.contacts[i]) + along(work_.contacts[i], &NetworkMember::nodes);
    }
    relax(
        values, [](const PressedRow& r) { return r.before + r.pressed + r.change; },
        [&](const PressedRow& r, double total) { return allowed(r, total); });
}

Freedoms pushOf(const State& state, std::uint32_t mover) {
    if (mover == none) return Freedoms::Zero();
    const SolverBody& body = state.core.movers.bodies[mover];
    const Motion3& placed = state.core.placed[mover];
    return {static_cast<double>(body.x - placed.x), static_cast<double>(body.y - placed.y),
            static_cast<double>(body.turn - placed.turn)};
}
void placeBy(State& state, std::uint32_t mover, const Freedoms& push) {
    if (mover == none) return;
    SolverBody& body = state.core.movers.bodies[mover];
    const Motion3& placed = state.core.placed[mover];
    if (body.inverseMass > 0) {
        body.x = placed.x + static_cast<Real>(push[0]);
        body.y = placed.y + static_cast<Real>(push[1]);
    }
    if (body.inverseInertia > 0) body.turn = placed.turn + static_cast<Real>(push[2]);
}

void NetworkContacts::solvePushes() {
    const double h = static_cast<double>(state_.h);
    const double share = std::min(tuned::recoveryRate * h, tuned::recoveryShare);
    std::pmr::vector<double> values(rows(), 0, &state_.arena);
    for (std::size_t i = 0; i < rows(); ++i) {
        PressedRow& row = work_.contacts[i];
        row.change = 0;
        values[i] = along(row, &NetworkMember::nodes) -
                    std::clamp(share * row.overlap, 0.0, tuned::recoverySpeed * h);
        for (std::size_t k = 0; k < 3; ++k)
            if (row.bodies[k] != none)
                values[i] += row.along[k].dot(pushOf(state_, work_.bodies[row.bodies[k]].mover));
    }
    relax(
        values, [](const PressedRow& r) { return r.change; },
        [](const PressedRow& r, double total) {
            return r.normal == none && r.overlap > 0 ? std::max(total, 0.0) : 0.0;
        });
}

bool NetworkContacts::overlap() const {
    return std::any_of(work_.contacts.begin(), work_.contacts.end(),
                       [](const PressedRow& row) { return row.normal == none && row.overlap > 0; });
}

void NetworkContacts::placeBodies() {
    for (PressingBody& body : work_.bodies) body.moved = pushOf(state_, body.mover);
    for (const PressedRow& row : work_.contacts) moveBodies(row, row.change);
    for (const PressingBody& body : work_.bodies) placeBy(state_, body.mover, body.moved);
}

void NetworkContacts::moveBodies(const PressedRow& row, double amount) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (row.bodies[k] == none) continue;
        PressingBody& body = work_.bodies[row.bodies[k]];
        body.moved += amount * body.inverseMass.cwiseProduct(row.along[k]);
    }
}

void NetworkContacts::takeChanges() {
    for (const PressedRow& row : work_.contacts) addTo(&NetworkMember::residual, row, -row.change);
}
void NetworkContacts::addPressed() {
    for (const PressedRow& row : work_.contacts) addTo(&NetworkMember::nodes, row, row.pressed);
}

void NetworkContacts::advance(double share) {
    for (PressedRow& row : work_.contacts) {
        row.pressed += share * row.change;
        moveBodies(row, share * row.change);
    }
}

void NetworkContacts::keepBest() {
    for (PressedRow& row : work_.contacts) row.best = row.pressed;
}

double NetworkContacts::error() const {
    double most = 0;
    for (const PressedRow& row : work_.contacts) {
        if (row.normal != none) continue;
        const double value = valueOf(row);
        const double wrong = row.before + row.pressed > 0 ? std::abs(value) : -value;
        most = std::max(most, wrong - settled_);
    }
    return most;
}

void NetworkContacts::brake() {
    std::pmr::vector<std::uint32_t> touches(&state_.arena);
    for (const PressedRow& row : work_.contacts)
        if (row.normal == none) touches.push_back(row.touch);
    detail::brake(state_, group_.trees, touches, Brake::always);
}

void NetworkContacts::push() {
    for (const PressedRow& row : work_.contacts) {
        addTo(&NetworkMember::nodes, row, row.best);
        const Real amount = static_cast<Real>(row.best);
        const auto isNode = [&](std::size_t k) { return row.nodes[k] != none; };
        pressFromOutside(state_, row.touch, row.normal == none ? amount : 0,
                         row.normal == none ? 0 : amount, {isNode(0), isNode(1), isNode(2)});
    }
}

}  // namespace sulfur::detail
