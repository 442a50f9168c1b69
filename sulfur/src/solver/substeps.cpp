#include "solver/substeps.hpp"

#include <algorithm>

#include "solver/motion.hpp"

namespace sulfur::detail {

namespace {

constexpr int wantedRate = 480;     // Hz, of steps, while something asks for it
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

/// Whether the caller has just put something somewhere that can touch.
bool anyPlacedSurface(const State& state) {
    if (!state.anyPlaced) return false;
    const auto hasSurface = [&](const BodyRecord& body) {
        const auto first = state.particles.reach.begin() + body.firstParticle;
        return std::any_of(first, first + static_cast<std::ptrdiff_t>(body.particles.size()),
                           [](Real reach) { return reach > 0; });
    };
    return std::any_of(state.bodies.begin(), state.bodies.end(), [&](const BodyRecord& body) {
        return body.placed && body.kind != BodyKind::fixed && hasSurface(body);
    });
}

bool asksForShortSteps(const State& state) {
    return state.substeps.strained != 0 || state.work.anyUnresolved || !state.entwined.empty() ||
           anyPlacedSurface(state) || anyFast(state);
}

}  // namespace

Real tickDuration(const State& state) {
    return 1 / static_cast<Real>(state.settings.tickRate);
}

void setStep(State& state, Real h) {
    if (h == state.h) return;
    const Real newtons = newtonsPerMultiplier(state);
    state.h = h;
    const Real scale = newtons / newtonsPerMultiplier(state);
    for (ContactMemory& m : state.contactMemory) {
        m.normalLambda *= scale;
        m.tangentLambda *= scale;
        m.sustained *= scale;
    }
    state.structure.stale = true;
    state.broad.pairsStale = true;
}

void chooseSubsteps(State& state) {
    Substeps& steps = state.substeps;
    const int most = mostSubsteps(state);
    const double tick = 1.0 / state.settings.tickRate;
    if (most > 1)
        steps.left = asksForShortSteps(state) ? calmAfter : std::max(steps.left - tick, 0.0);
    steps.count = most > 1 && steps.left > 0 ? static_cast<std::uint32_t>(most) : 1;
    steps.strained = 0;
    state.statistics.substeps = steps.count;
    setStep(state, tickDuration(state) / static_cast<Real>(steps.count));
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
