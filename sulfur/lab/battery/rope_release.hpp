// A rope with a load, released horizontally.
#pragma once

#include "battery/row.hpp"

namespace sulfur::lab {

/// `links` rigid links of `linkLength` metres and 0.05 kg hang from a pin at one end; the last
/// particle weighs `load` times a link. It starts at rest and horizontal.
struct RopeRelease {
    double linkLength = 0.05;
    double load = 1;
    int links = 40;
    double seconds = 10;
    double stretchBound = 1e-4;
    bool accurate = true;  ///< whether energy and path have bounds too
};

/// Rows:
/// - the largest |length / rest length - 1| of any link after any tick; bound stretchBound;
/// - how many particles are not finite in the end: none;
/// and, when accurate, with the energy averaged over 0.05 s (as World::energy says),
/// as a share of the weight times the way from the start to hanging straight down:
/// - the largest energy lost, at most 5 %, and gained, at most 2 %;
/// - the largest distance of the load from a converged reference (ChainReference) until it turns
///   back for the first time, over the rope's length: at most 2 %.
Rows releaseRope(const RopeRelease& options, const Setup& setup);

}  // namespace sulfur::lab
