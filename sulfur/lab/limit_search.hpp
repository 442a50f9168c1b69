// The largest elastic constant before the rope explodes.
#pragma once

#include <optional>

#include "integrators/integrator.hpp"
#include "rope.hpp"

namespace sulfur::lab {

/// When a rope counts as having lost its stability, and how its limit is searched.
struct SearchOptions {
    double seconds = 20;       ///< simulated
    double energyMargin = 10;  ///< times Rope::budget of kinetic energy is an explosion
    bool mustRest = true;      ///< whether a rope that never comes to rest is unstable too
    double restShare = 0.01;   ///< of the budget: more kinetic energy in the last second is no
                               ///< rest; air friction alone leaves 0.0003 after 20 s
    double resolution = 0.01;  ///< relative, of the limit that is found
    double lowest = 10;        ///< N/m, the first that is tried
    double highest = 1e9;      ///< N/m, the last that is tried
};

/// Whether the rope is finite and within its energy at every tick, and at rest in the end.
bool survives(const Rope& rope, Integrator& integrator, double rate, const SearchOptions& options);

struct LimitFound {
    double stable = 0;               ///< N/m, survived; 0: none did
    std::optional<double> exploded;  ///< N/m; nothing: no limit found up to `stable`
    int trials = 0;
};

/// Doubles the elastic constant from options.lowest until the rope explodes (tenfold steps for an
/// integrator that has no limit in theory), then halves the bracket until it is narrow enough.
/// `rope.stiffness` is ignored.
LimitFound findLimit(RopeConstants rope, const IntegratorEntry& entry, double rate,
                     const SearchOptions& options);

}  // namespace sulfur::lab
