// What quaoar_solve does for each of its options.
#pragma once

#include <string>
#include <vector>

#include "solve.hpp"

namespace quaoar {

struct SolverArguments {
    std::vector<std::string> levels;
    std::string out;
    std::string check;
    bool fresh = false;   ///< begin without the way that is known
    bool repair = false;  ///< only what does not hold
    bool table = false;
    int fair = 0;       ///< resting states
    int bot = 0;        ///< games with the way that is known
    bool keep = false;  ///< what these have shown
    int skill = 3;
    double wander = 0;  ///< hours of random play
    SolveOptions solve;
};

/// Does what was asked for; the exit status.
int runSolver(const SolverArguments& arguments);

}  // namespace quaoar
