// The largest stable stiffness over the rate and the damping.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "integrators/integrator.hpp"
#include "rope.hpp"

namespace sulfur::lab {

/// The largest stiffness at which the rope hanging at rest is stable: no small disturbance of its
/// places and velocities grows, found from the eigenvalues of one tick of the integrator itself,
/// differentiated there. Nothing that a linear law leaves out is missing but large motion: the
/// rope has its ends, its weight and its sideways motion. `rope.stiffness` is ignored.
struct HangingLimit {
    bool any = false;  ///< whether 1 N/m, the least that is tried, is stable
    std::optional<double>
        limit;  ///< N/m; nothing: none is stable, or there is none below `highest`
};
HangingLimit hangingLimit(RopeConstants rope, const IntegratorEntry& entry, double rate,
                          double highest);

/// One integrator at one rate and damping.
struct StabilityCell {
    double rate = 0;     ///< Hz
    double damping = 0;  ///< N s/m
    HangingLimit measured;
    std::optional<double> law;  ///< N/m, see linearLimit; nothing: no limit below `highest`
};

struct StabilityMapOptions {
    RopeConstants rope{.particles = 10, .airFriction = 0};
    int rates = 24;         ///< from 60 Hz to 10 kHz, in equal ratios
    int dampings = 16;      ///< 0, then from 0.01 to 10 N s/m, in equal ratios
    double highest = 1e10;  ///< N/m
};

struct StabilityMap {
    std::string key, title, law;  ///< of the integrator
    std::vector<double> rates, dampings;
    std::vector<StabilityCell> cells;  ///< damping by damping, each at all rates
};

StabilityMap measureStabilityMap(const IntegratorEntry& entry, const StabilityMapOptions& options);

std::string asText(const std::vector<StabilityMap>& maps, const StabilityMapOptions& options);
std::string asCsv(const std::vector<StabilityMap>& maps);
std::string asJson(const std::vector<StabilityMap>& maps);
/// Two heat maps side by side: as measured, and by the linear law.
std::string asSvg(const StabilityMap& map);

}  // namespace sulfur::lab
