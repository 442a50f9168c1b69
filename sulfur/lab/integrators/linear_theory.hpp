// What linear theory says about the stability of an integrator on a long chain.
#pragma once

#include <optional>

#include "integrators/integrator.hpp"

namespace sulfur::lab {

/// A chain of equal masses, springs and dampers, deformed along itself by little.
struct ChainConstants {
    double mass = 0.05;       ///< kg
    double damping = 0.2;     ///< N s/m
    double duration = 0.002;  ///< s of a tick
};

/// The largest stiffness (N/m) for which no mode of the chain grows, found by stepping every mode
/// (wave number 0 to the shortest wave) with the integrator itself; nothing when there is no limit
/// below `highest`. A mode with mu = 4 sin^2(theta / 2) has the stiffness mu k and damping mu b.
std::optional<double> linearLimit(const IntegratorEntry& entry, const ChainConstants& chain,
                                  double highest);

}  // namespace sulfur::lab
