#include "solver/restitution.hpp"

#include <algorithm>
#include <cmath>

#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

/// Over the velocities of all contacts that rebound at once.
constexpr int sweeps = 4;

bool isFree(const State& state, const Grip& grip) {
    if (grip.cluster != none) return state.clusters.list[grip.cluster].inverseMass > 0;
    return state.particles.inverseMass[grip.particle] > 0;
}

/// m/s^2 by which gravity alone speeds the approach up: what falls together does not.
Real fallTogether(const State& state, const Contact& c) {
    const int difference = isFree(state, c.gripOfParticle) - isFree(state, c.gripOfA);
    return -static_cast<Real>(difference) * c.normal.dot(state.settings.gravity);
}

Vec2 relativeVelocity(const State& state, const Contact& c) {
    Vec2 v = velocityOf(state, c.gripOfParticle) - c.shareA * velocityOf(state, c.gripOfA);
    if (c.shareB != 0) v -= c.shareB * velocityOf(state, c.gripOfB);
    return v;
}

void strike(State& state, const Contact& c, Real impulse) {
    const Vec2 blow = impulse * c.normal;
    strike(state, c.gripOfParticle, blow);
    strike(state, c.gripOfA, -c.shareA * blow);
    if (c.shareB != 0) strike(state, c.gripOfB, -c.shareB * blow);
}

}  // namespace

void planRebound(const State& state, Contact& c) {
    // The velocities stand in the middle of the tick, half a kick after its start.
    const Real h = state.h, a = fallTogether(state, c);
    const Real gap = std::max<Real>(c.gap, 0);
    if (gap > h * c.approach) return;
    const Real start = c.approach - a * h / 2;
    const Real impact = std::sqrt(std::max<Real>(start * start + 2 * a * gap, 0));
    if (impact <= slowestRebound) return;
    // Newton's law of impact, then the rest of the tick in free flight.
    const Real left = h - std::min(h, 2 * gap / (std::max<Real>(start, 0) + impact));
    const Real parting = c.restitution * impact - a * left;
    const Real rise = c.restitution * impact * left - a * left * left / 2;
    if (parting <= 0 || rise < 0) return;
    c.rise = rise;
    c.rebound = parting + a * h / 2;
}

void rebound(State& state) {
    thread_local std::vector<std::uint32_t> rebounding;
    rebounding.clear();
    for (std::uint32_t i = 0; i < state.contacts.size(); ++i)
        if (state.contacts[i].rebound > 0 && state.contacts[i].normalLambda > 0)
            rebounding.push_back(i);
    if (rebounding.empty()) return;
    thread_local std::vector<Real> given;  // N s
    given.assign(rebounding.size(), 0);
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t k = 0; k < rebounding.size(); ++k) {
            const Contact& c = state.contacts[rebounding[k]];
            const Real missing = c.rebound - c.normal.dot(relativeVelocity(state, c));
            const Real before = given[k];
            // What the displacements have pushed already may be taken back, but no more.
            const Real least = -c.normalLambda / state.h;
            given[k] = std::max(least, before + missing / c.inverseEffectiveMass);
            strike(state, c, given[k] - before);
        }
    for (std::size_t k = 0; k < rebounding.size(); ++k)
        state.contacts[rebounding[k]].blow = given[k];
}

}  // namespace sulfur::detail
