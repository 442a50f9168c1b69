// How far a step of a tree may go before it is halved.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/limits.hpp"
#include "core/settings.hpp"

namespace sulfur::detail {

using tuned::calmTurn;
using tuned::calmWhip;
using tuned::mostSteps;
using tuned::mostTurn;
using tuned::mostWhip;
using tuned::redundantPivot;
using tuned::tolerableTurn;
using tuned::tolerableWhip;
using tuned::treeTolerance;
using tuned::worthwhile;
inline constexpr int mostChainPasses = tuned::chainPasses, mostChainFactors = tuned::newtonPasses;
/// m; what the shortest step of the fastest world still closes at once.
inline constexpr double smallStretch = closingSpeed / (10000 * mostSteps);
/// 1 / largest error of a link of length `rest` that counts as none, in units of treeTolerance.
inline double shareOf(double rest) {
    return std::min(1 / rest, 1e3);
}

/// How a step of a tree, or all of them in a tick, went.
struct Outcome {
    bool converged = true;
    double whip = 0, turn = 0;
    void add(const Outcome& other) {
        converged &= other.converged;
        whip = std::max(whip, other.whip);
        turn = std::max(turn, other.turn);
    }
    bool calm() const { return whip < calmWhip && turn < calmTurn; }
    bool good() const { return converged && whip <= mostWhip && turn <= mostTurn; }
    bool tolerable() const { return converged && whip <= tolerableWhip && turn <= tolerableTurn; }
};

}  // namespace sulfur::detail
