// A chain of point masses on massless rods, as exactly as one can afford.
#pragma once

#include <vector>

#include "integrators/system.hpp"

namespace sulfur::lab {

/// The first rod hangs from the origin, which is fixed. Every rod keeps its length, gravity pulls
/// down. Rigid pendulums, double pendulums and ropes are such chains.
struct ChainPlan {
    std::vector<double> lengths;  ///< m
    std::vector<double> masses;   ///< kg, at the far end of each rod
    double gravity = 9.81;        ///< m/s^2
};

/// The exact equations of motion (the rods' forces from the accelerations of their lengths, one
/// tridiagonal solve) under the classical Runge-Kutta method, in double. It is of fourth order, so
/// that small steps converge quickly; it does not know the library's methods.
class ChainReference {
public:
    ChainReference(ChainPlan plan, State start)
        : plan_(std::move(plan)), state_(std::move(start)) {}

    void step(double h);
    const State& state() const { return state_; }

private:
    void accelerations(const State& state, Vecs& out);

    ChainPlan plan_;
    State state_, stage_;
    Vecs a_, sumX_, sumV_, rods_;
    std::vector<double> diagonal_, upper_, tension_;
};

/// Where the particles of a chain are at equal intervals.
struct ChainPath {
    std::vector<State> states;  ///< at 0, interval, 2 interval, ...
    double error = 0;  ///< m: largest distance of the last particle from where steps twice as long
                       ///< put it
    double step = 0;   ///< s, of the method
};

/// Halves the steps, from `interval` on, until the path changes by less than `tolerance` metres, or
/// `most` steps an interval are reached; `error` says what was.
ChainPath convergedPath(const ChainPlan& plan, const State& start, double interval,
                        std::size_t intervals, double tolerance, int most = 1024);

}  // namespace sulfur::lab
