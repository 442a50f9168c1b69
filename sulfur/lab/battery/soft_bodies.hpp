// Lattices of springs: what they keep, and that nothing makes them explode.
#pragma once

#include <cstdint>
#include <vector>

#include "battery/row.hpp"

namespace sulfur::lab {

/// A lattice of 4 x 4 particles and 33 springs without damping shakes and spins in free space.
/// Largest change of its linear momentum in `ticks`, over m v_max, at most 1e-6 (double build
/// 1e-12), and of its angular momentum about its centre, over m v_max times its largest radius at
/// the start, at most 1e-4 (1e-9). v_max is the fastest that any particle ever was.
Rows freeSoftBody(long ticks, const Setup& setup);

/// A random lattice: 4 x 3 cells with one in four springs left out, masses spread evenly in their
/// logarithm over a ratio of `massRatio` (0.1 kg at most), hung from one corner and released with
/// random velocities up to 1 m/s.
struct RandomLattice {
    double stiffness = 400;  ///< N/m, or infinite
    double massRatio = 1;    ///< 1 to 10^6
    double seconds = 10;
    std::uint64_t seed = 1;
};
struct RandomLatticeResult {
    bool finite = false;
    /// Largest mean of the energy (gravity included) over any second, above that of the start, over
    /// the energy of the start above the ground that the lattice could reach if nothing stretched.
    double energyGain = 0;
};
RandomLatticeResult releaseLattice(const RandomLattice& options, const Setup& setup);

/// Releases lattices with `seeds` seeds for each combination, at each rate. One row a combination
/// for the largest gain of energy, at most 10 %, and one for the runs that are not finite: none.
struct RandomLattices {
    std::vector<double> stiffness;
    std::vector<double> massRatios;
    std::vector<int> rates;
    double seconds = 10;
    int seeds = 1;
    /// k = 0, 1, 10^2, ... 10^12 and infinite; 60 Hz to 10 kHz; ratios of 1, 10^3 and 10^6.
    static RandomLattices all();
};
Rows randomLattices(const RandomLattices& options, const Setup& setup);

/// A damped lattice of 5 x 5 particles (400 N/m, 1 N s/m, cells of 0.25 m) whose particles start
/// somewhere within `disorder` cells of their places. After 30 s: how many are not finite (none),
/// the root mean square speed about the centre of mass (at most 1 mm/s) and, for a disorder of up
/// to half a cell, the share of cells that are inside out (none).
Rows scrambledLattice(double disorder, std::uint64_t seed, const Setup& setup);

}  // namespace sulfur::lab
