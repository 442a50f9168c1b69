// How far a step of a tree may go before it is halved.
#pragma once

#include <algorithm>
#include <cstdint>

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
