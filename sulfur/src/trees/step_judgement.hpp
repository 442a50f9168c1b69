// How far a step of a tree may go before it is halved.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/limits.hpp"

namespace sulfur::detail {

inline constexpr std::uint32_t mostSteps = 64;
inline constexpr double treeTolerance = 1e-8;  // of a link's length

/// What one step may do before it is halved: whip is 2 w (tension / length) h^2, summed over the
/// links of a node; turn is the sine of the angle that a link turns by.
inline constexpr double mostWhip = 1, mostTurn = 0.2;
/// The shortest steps may do this: less exact, but still far from the explosion, which linear
/// theory puts at a whip of 4.
inline constexpr double tolerableWhip = 3, tolerableTurn = 0.7;
/// Below both of these the steps are doubled.
inline constexpr double calmWhip = 0.15, calmTurn = 0.08;

/// Of Newton's method for a chain. A pass uses the factors of an earlier one as long as each takes
/// all but this part of the error away.
inline constexpr int mostChainPasses = 10, mostChainFactors = 6;
inline constexpr double worthwhile = 0.05;
/// m; what the shortest step of the fastest world still closes at once.
inline constexpr double smallStretch = closingSpeed / (10000 * mostSteps);
/// Smaller than this, relative to what moves there, nothing can: the link is redundant.
inline constexpr double redundantPivot = 1e-13;
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
