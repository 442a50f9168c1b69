// Rigid bodies in free flight.
#pragma once

#include "battery/row.hpp"

namespace sulfur::lab {

/// A crate of 1 m and 1 kg spins freely, without gravity, `distance` metres right of and above the
/// origin. Relative change of angular momentum and of energy between the first tick and the last,
/// each at most 0.1 %.
Rows spinningCrate(double turnsPerSecond, double distance, double seconds, const Setup& setup);

/// The same, where a tick turns the crate too far for accuracy: the largest energy of spin in any
/// tick, over that of the first one, minus 1 (at most 0.1 %), and how many particles are not
/// finite in the end (none).
Rows fastCrate(double turnsPerSecond, double seconds, const Setup& setup);

/// A triangle with sides of 4 cm of 3 particles and 3 rigid joints, spinning so that its particles
/// move at `speed` m/s. The same two rows.
Rows spinningShard(double speed, double seconds, const Setup& setup);

}  // namespace sulfur::lab
