// Free fall and slow drift: what rounding may take away.
#pragma once

#include "battery/row.hpp"

namespace sulfur::lab {

/// A particle falls for 1 s from `distance` metres right of and above the origin. Error of its
/// place, m, against -g t^2 / 2: at most 1 mm, at 10 kHz 1 cm.
Row freeFall(double distance, const Setup& setup);

/// A particle 1 km right of and above the origin drifts at 0.01 m/s without gravity. Relative
/// error of the distance it covers: at most 1 %.
Row slowDrift(double seconds, const Setup& setup);

}  // namespace sulfur::lab
