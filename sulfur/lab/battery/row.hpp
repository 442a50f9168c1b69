// One line of the battery: what was measured beside what must hold.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sulfur::lab {

struct Row {
    std::string name;     ///< scene, quantity and its unit
    double measured = 0;  ///< NaN where nothing could be measured; it then fails
    double bound = 0;     ///< the largest value that passes; infinite when it is only reported
    bool passed = false;  ///< measured <= bound
};

using Rows = std::vector<Row>;

/// A row that passes when `measured` is a number and at most `bound`.
Row atMost(std::string name, double measured, double bound);

/// A row that tells something for which nothing must hold but that it is a number.
Row reported(std::string name, double measured);

/// A row whose bound is out of reach so far: it passes up to the best that was reached, so that
/// this is not lost again, and its name says what was asked.
Row fallsShort(const std::string& name, double measured, double reached, double asked);

class Album;

/// Random worlds, from the first to the last.
struct SeedRange {
    std::uint64_t first = 1, last = 1;
};

/// What the scenes of the battery are run with.
struct Setup {
    int tickRate = 500;  ///< Hz, where a scene says no other
    int sweeps = 4;
    bool quick = false;  ///< shorter runs of the scenes that take minutes
    int shots = 10000;   ///< of each kind
    std::optional<SeedRange> seeds = std::nullopt;  ///< of the random worlds
    Album* album = nullptr;  ///< gets pictures of the scenes with contacts, if there is one

    /// The same for a world whose ticks are the steps of this one: below 480 Hz a tick is several
    /// equal steps. Laws of the integrator are those of a step.
    Setup ofSteps() const {
        Setup steps = *this;
        steps.tickRate = tickRate * ((479 + tickRate) / tickRate);
        return steps;
    }

    /// Whether a quick run has `quickSeconds` instead.
    double seconds(double whole, double quickSeconds) const { return quick ? quickSeconds : whole; }
};

}  // namespace sulfur::lab
