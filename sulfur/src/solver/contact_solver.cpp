// Contacts: projection by the least distance with the masses' shares, and friction.
#include <algorithm>
#include <cmath>

#include "collision/contact_memory.hpp"
#include "core/pieces.hpp"
#include "solver/constraint_kinds.hpp"
#include "solver/contact_motion.hpp"
#include "solver/contact_recovery.hpp"
#include "solver/motion.hpp"

namespace sulfur::detail {

namespace {

/// Contacts that are looked at in a microsecond.
constexpr std::size_t judgedInMicrosecond = 250;

/// The accumulated multiplier never pulls.
void solveNormal(State& state, Contact& c) {
    const Real before = c.normalLambda;
    c.normalLambda = std::max<Real>(0, before - gapLeft(state, c) / c.inverseEffectiveMass);
    push(state, c, (c.normalLambda - before) * c.normal);
}

/// Coulomb: what sticks is held as long as static friction suffices, what slides is braked by
/// kinetic friction.
Real coulombLambda(const State& state, const Contact& c) {
    const Real most = frictionOf(c) * c.normalLambda;
    return std::clamp(c.tangentLambda - slipOf(state, c) / c.tangentInverseMass, -most, most);
}

/// The paper's: a force of -mu v, here implicitly, so that no mu is too large.
Real slidingLambda(const State& state, const Contact& c) {
    if (c.normalLambda <= 0) return 0;
    const Real rate = c.kineticFriction * state.h;
    return c.tangentLambda -
           (rate * slipOf(state, c) + c.tangentLambda) / (1 + rate * c.tangentInverseMass);
}

void solveFriction(State& state, Contact& c) {
    if (c.tangentInverseMass == 0) return;  // held by a pin in that direction
    const Real before = c.tangentLambda;
    c.tangentLambda = state.settings.friction == Friction::coulomb ? coulombLambda(state, c)
                                                                   : slidingLambda(state, c);
    push(state, c, (c.tangentLambda - before) * tangentOf(c));
}

void solve(State& state, Contact& c) {
    solveNormal(state, c);
    if (c.staticFriction > 0) solveFriction(state, c);
}

void recoverGap(State& state, Contact& c) {
    const Real left = recoveryOf(state, c) - c.normal.dot(relativeShift(state, c));
    const Real before = c.recoveryLambda;
    c.recoveryLambda = std::max<Real>(0, before + left / c.inverseEffectiveMass);
    shift(state, c, (c.recoveryLambda - before) * c.normal);
}

}  // namespace

namespace {

/// The stiff joints of something soft begin every tick without their multipliers; contacts that
/// began with theirs would push it out of shape before the sweeps have found the joints' answer.
/// Chains and trees answer at once.
bool touchesSoft(const State& state, const Contact& c) {
    const auto isSwept = [&](const Grip& grip) {
        return isSoft(state, grip) && state.trees.ofParticle[grip.particle] == none;
    };
    return isSwept(c.gripOfParticle) || isSwept(c.gripOfA) || (c.shareB != 0 && isSwept(c.gripOfB));
}

void warmStart(State& state, Contact& c, const ContactMemory& before) {
    if (c.rough) {
        c.drift = before.drift;
        c.sliding = before.sliding != 0;
    }
    if (touchesSoft(state, c)) return;
    // The same force in a step of another length.
    const Real scale = before.step == state.h
                           ? 1
                           : newtonsPerMultiplier(state, before.step) / newtonsPerMultiplier(state);
    c.normalLambda = scale * before.sustained;
    if (c.rough) {
        const Real most = frictionOf(c) * c.normalLambda;
        c.tangentLambda = std::clamp(scale * before.tangentLambda, -most, most);
    }
}

/// Which memories have an heir already: each has one.
class Heirs {
public:
    explicit Heirs(State& state) : state_(state) { taken().assign(state.contactMemory.size(), 0); }

    /// So many contacts go on from where they were: first those whose place is the same to the end,
    /// then, from what is left, those that have an end in common with what they were.
    void inherit(std::size_t count) {
        thread_local std::vector<std::uint32_t> others;
        others.clear();
        for (std::uint32_t i = 0; i < count; ++i)
            if (!inherit(i, true)) others.push_back(i);
        for (const auto i : others) inherit(i, false);
    }

private:
    bool inherit(std::uint32_t i, bool exactly) {
        Contact& c = state_.contacts[i];
        if (c.inherited) return true;
        const ContactMemory* before = recall(state_, c.particle, c.a, c.b);
        if (!before) return true;  // nor will it find any later
        if ((before->a == c.a && before->b == c.b) != exactly) return false;
        auto& isTaken = taken_[static_cast<std::size_t>(before - state_.contactMemory.data())];
        if (isTaken || before->normal.dot(c.normal) < Real(0.9)) return false;
        isTaken = c.inherited = true;
        warmStart(state_, c, *before);
        return true;
    }

    static std::vector<std::uint8_t>& taken() {
        thread_local std::vector<std::uint8_t> scratch;
        return scratch;
    }

    State& state_;
    std::vector<std::uint8_t>& taken_ = taken();
};

}  // namespace

void warmStartContacts(State& state) {
    Heirs(state).inherit(state.contacts.size());
}

void solveContacts(State& state, const std::vector<std::uint32_t>& which, bool backwards) {
    const auto solveOne = [&](std::uint32_t i) { solve(state, state.contacts[i]); };
    if (backwards)
        std::for_each(which.rbegin(), which.rend(), solveOne);
    else
        std::for_each(which.begin(), which.end(), solveOne);
}

void pushWithMultipliers(State& state, const Contact& c) {
    push(state, c, c.normalLambda * c.normal + c.tangentLambda * tangentOf(c));
}

void recoverDrifts(State& state, const std::vector<std::uint32_t>& which) {
    for (const auto i : which) {
        const Contact& c = state.contacts[i];
        if (c.drift != 0 && c.tangentInverseMass > 0)
            shift(state, c, -driftRecovered(state, c) / c.tangentInverseMass * tangentOf(c));
    }
}

void solveRecovery(State& state, const std::vector<std::uint32_t>& which) {
    for (const auto i : which)
        if (state.contacts[i].gap < 0) recoverGap(state, state.contacts[i]);
}

namespace {

/// All recoveries together may not move anything faster than this.
constexpr Real mostRecoverySpeed = Real(0.9);  // m/s

Vec2 shortened(const Vec2& v, Real most) {
    const Real length = v.norm();
    return length > most ? Vec2(most / length * v) : v;
}

}  // namespace

void applyRecovery(State& state, const Grip& grip) {
    const Real most = mostRecoverySpeed * state.h;
    if (grip.cluster != none) {
        Cluster& c = state.clusters.list[grip.cluster];
        const double turn = static_cast<double>(most) / c.reach;
        c.shift = shortened(c.shift, most);
        c.twist = std::clamp(c.twist, -turn, turn);
        return;
    }
    Vec2& shift = state.particles.shift[grip.particle];
    state.particles.position[grip.particle] += shortened(shift, most).cast<double>();
    shift = Vec2(0, 0);
}

namespace {

/// m/s^2: a contact slides when friction gives all it can and still the slip of a tick is more
/// than what this makes of a tick. Less is what sweeps leave of contacts that share a load.
constexpr Real slidingStarts = Real(0.25);

/// `restSlip`: m, see slipOfRest().
void judgeSliding(const State& state, Contact& c, Real restSlip) {
    const Real slip = slipOf(state, c);
    const Real most = frictionOf(c) * c.normalLambda;
    const bool slips = std::abs(slip) > slidingStarts * state.h * state.h;
    const bool givesAll = std::abs(c.tangentLambda) > Real(0.9) * most;
    c.sliding = (slips && givesAll) || std::abs(slip) > restSlip;
    const bool sticks = c.normalLambda > 0 && !c.sliding;
    c.drift = sticks ? c.drift - driftRecovered(state, c) + slip : 0;
}

}  // namespace

void finishContacts(State& state) {
    const Real restSlip = slipOfRest(state);
    inPieces(state.tasks, state.contacts.size(), judgedInMicrosecond,
             [&](std::size_t first, std::size_t last) {
                 for (auto i = first; i < last; ++i)
                     if (state.contacts[i].rough) judgeSliding(state, state.contacts[i], restSlip);
             });
    rememberContacts(state);
}

void guardContacts(State& state) {
    for (Contact& c : state.contacts)
        if (gapLeft(state, c) < deepestOf(c)) solveNormal(state, c);
}

}  // namespace sulfur::detail
