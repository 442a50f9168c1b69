#include "solver/substeps.hpp"

#include <algorithm>

namespace sulfur::detail {

namespace {

constexpr int wantedRate = 500;     // Hz, of steps, while something asks for it
constexpr double calmAfter = 0.5;   // s
constexpr double fastTravel = 0.1;  // radii in a tick

int mostSubsteps(const State& state) {
    return (wantedRate + state.settings.tickRate - 1) / state.settings.tickRate;
}

/// Whether anything that can touch covers too much of its own thickness in a tick.
bool anyFast(const State& state) {
    const Particles& p = state.particles;
    const double tick = 1.0 / state.settings.tickRate;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double most = fastTravel * static_cast<double>(p.reach[i]);
        if (most > 0 && tick * tick * p.velocity[i].squaredNorm() > most * most) return true;
    }
    return false;
}

}  // namespace

void setStep(State& state, Real h) {
    if (h == state.h) return;
    const Real scale = h / state.h * (h / state.h);
    for (ContactMemory& m : state.contactMemory) {
        m.normalLambda *= scale;
        m.tangentLambda *= scale;
        m.sustained *= scale;
    }
    state.h = h;
    state.structure.stale = true;
    state.broad.pairsStale = true;
}

void chooseSubsteps(State& state) {
    Substeps& steps = state.substeps;
    const int most = mostSubsteps(state);
    const double tick = 1.0 / state.settings.tickRate;
    if (most > 1) {
        if (state.anyPlaced || !state.entwined.empty() || steps.strained != 0 || anyFast(state))
            steps.left = calmAfter;
        else
            steps.left = std::max(steps.left - tick, 0.0);
    }
    steps.count = most > 1 && steps.left > 0 ? static_cast<std::uint32_t>(most) : 1;
    steps.strained = 0;
    state.statistics.substeps = steps.count;
    setStep(state, 1 / static_cast<Real>(state.settings.tickRate) / static_cast<Real>(steps.count));
}

bool mayDivideTicks(const State& state) {
    return mostSubsteps(state) > 1;
}

void noteStrain(State& state, bool leftError) {
    const auto moves = [&](std::uint32_t body) {
        return state.bodies[body].kind == BodyKind::dynamic && !state.bodies[body].asleep;
    };
    const auto asks = [&](const Contact& c) {
        return c.normalLambda > 0 && (c.fast || c.rebound > 0 || (c.rough && c.sliding) ||
                                      (moves(c.bodyA) && moves(c.bodyB)));
    };
    if (leftError || std::any_of(state.contacts.begin(), state.contacts.end(), asks))
        state.substeps.strained = 1;
}

}  // namespace sulfur::detail
