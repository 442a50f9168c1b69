#include "solver/substeps.hpp"

#include <algorithm>

#include "collision/broad_phase.hpp"
#include "collision/pairs.hpp"

namespace sulfur::detail {

namespace {

constexpr int wantedRate = 480;       // Hz, of steps, while something asks for it
constexpr double calmAfter = 0.5;     // s
constexpr Real fastTravel = Real(0.1);  // of a thickness, in a tick

int mostSubsteps(const State& state) {
    return (wantedRate + state.settings.tickRate - 1) / state.settings.tickRate;
}

/// Whether a candidate may meet within the tick, by the present velocities, with a way through each
/// other that shows. Bodies that are new since the last tick are known by `anyPlaced`.
bool anyFastMeeting(const State& state, double tick) {
    const BroadPhase& broad = state.broad;
    if (broad.collidersStale || broad.pairsStale) return true;
    thread_local std::vector<Vec2> ways;
    thread_local Outings outings;
    const Particles& p = state.particles;
    ways.assign(p.size(), Vec2(0, 0));
    for (const Range range : state.work.awake)
        for (auto i = range.first; i < range.last; ++i)
            ways[i] = (tick * p.velocity[i]).cast<Real>();
    measureOutings(state, ways, outings);
    bool any = false;
    forEachNear(broad, outings, [&](const Watch& w) {
        const Vec2& way = ways[w.candidate.particle];
        const Real travel = std::max((way - ways[w.a]).norm(), (way - ways[w.b]).norm());
        const Real thickness =
            p.reach[w.candidate.particle] + broad.collider(w.candidate.collider).radius;
        any |= travel > fastTravel * thickness;
    });
    return any;
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
        if (state.anyPlaced || !state.entwined.empty() || steps.strained != 0 ||
            anyFastMeeting(state, tick))
            steps.left = calmAfter;
        else
            steps.left = std::max(steps.left - tick, 0.0);
    }
    steps.count = most > 1 && steps.left > 0 ? static_cast<std::uint32_t>(most) : 1;
    steps.strained = 0;
    setStep(state, 1 / static_cast<Real>(state.settings.tickRate) / static_cast<Real>(steps.count));
}

void noteStrain(State& state, bool leftError) {
    if (mostSubsteps(state) == 1) return;
    const auto asks = [](const Contact& c) {
        return c.normalLambda > 0 && (c.fast || (c.rough && c.sliding));
    };
    if (leftError || std::any_of(state.contacts.begin(), state.contacts.end(), asks))
        state.substeps.strained = 1;
}

}  // namespace sulfur::detail
