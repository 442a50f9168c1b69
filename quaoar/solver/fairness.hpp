// Whether a level has places from which nobody can go on and in which nobody dies.
#pragma once

#include <vector>

#include "policy.hpp"

namespace quaoar {

struct FairOptions {
    int states = 200;
    std::uint64_t seed = 1;
    int jobs = 1;
    double patience = 10;  ///< s in which a hopeless hero must die
    double budget = 400;   ///< simulated seconds of the search for a way on
};

struct FairReport {
    int goOn = 0;
    int die = 0;
    std::vector<sulfur::Point> stuck;  ///< metres
};

/// Plays at random up to states of rest and looks for a way on from each: to the exit, to a place
/// of the policy (null: none is known), or two metres nearer to the exit.
FairReport checkFairness(const Ground& ground, const Policy* policy, const FairOptions& options);

}  // namespace quaoar
