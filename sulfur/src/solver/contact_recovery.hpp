// How overlaps and drifts are taken back: by moving positions, not displacements, so that it leaves
// no velocity behind and nothing is thrown.
#pragma once

#include <algorithm>

#include "rigid/grip.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

/// Share of an overlap that is taken back in a tick, and the speed that this may not exceed.
constexpr Real recoveryShare = Real(0.2);
constexpr Real recoverySpeed = Real(0.5);  // m/s

/// Whether it carries something over a gap that its slack has let open. The sweeps would leave the
/// gap as it is for ever, and towers would lean more and more. (Chains hold themselves straight.)
inline bool standsOpen(const Contact& c) {
    return c.normalLambda > 0 && c.gap > 0 && c.gap <= c.slack;
}

/// m, by which the gap grows in this tick, or shrinks.
inline Real recoveryOf(const State& state, const Contact& c) {
    return std::min(-c.gap * recoveryShare, recoverySpeed * state.h);
}

/// m, what of a drift is taken back in this tick.
inline Real driftRecovered(const State& state, const Contact& c) {
    const Real most = recoverySpeed * state.h;
    return std::clamp(c.drift * recoveryShare, -most, most);
}

/// Moves what the grip holds by what was added up for it, within a bound of speed.
void applyRecovery(State& state, const Grip& grip);

}  // namespace sulfur::detail
