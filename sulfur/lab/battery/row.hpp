// One line of the battery: what was measured beside what must hold.
#pragma once

#include <string>
#include <vector>

namespace sulfur::lab {

struct Row {
    std::string name;     ///< scene, quantity and its unit
    double measured = 0;  ///< NaN where nothing could be measured; it then fails
    double bound = 0;     ///< the largest value that passes
    bool passed = false;  ///< measured <= bound
};

using Rows = std::vector<Row>;

/// A row that passes when `measured` is a number and at most `bound`.
Row atMost(std::string name, double measured, double bound);

/// What the scenes of the battery are run with.
struct Setup {
    int tickRate = 500;  ///< Hz, where a scene says no other
    int sweeps = 4;
};

}  // namespace sulfur::lab
