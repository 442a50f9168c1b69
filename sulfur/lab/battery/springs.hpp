// One particle on a spring, the other end held.
#pragma once

#include "battery/row.hpp"

namespace sulfur::lab {

/// The largest omega h at which a spring without damping is integrated by NSV alone (0 to 2).
double explicitRange(const Setup& setup);

/// Swings without damping for `periods`, with omega h = `angle`, which should be in the explicit
/// range. Relative change of amplitude, at most 0.1 %; relative error of the frequency against that
/// of leapfrog, 2 asin(omega h / 2) / h, at most 0.1 %.
Rows undampedSpring(double angle, int periods, const Setup& setup);

/// A particle of 1 kg on a spring of `stiffness` N/m with `damping` N s/m below critical. Relative
/// error of the decay rate against damping / 2m: at most 0.94 % beside that of the scheme, which is
/// -ln(1 - h c) / (h c) - 1 with c = damping / m, or h c / 2 to first order.
Row dampedSpring(double stiffness, double damping, const Setup& setup);

/// How a particle of 1 kg on a spring moves as `stiffness` goes in `steps` equal ratios to 10^10
/// N/m, then becomes infinite; from 1 N/m, or from damping^2, which is four times the stiffness of
/// critical damping (where the frequency begins at 0 with a steep slope of its own). Each motion
/// has the root z = r exp(i angle) per tick: r is the share of the amplitude that a tick leaves,
/// the angle the frequency. A jump is what a step changes beyond the change of the step before it
/// (the slope that the physics has).
///
/// The largest jump of r, absolute, and of the angle, relative where r >= 0.05: at most 10 %.
Rows seamlessStiffness(double damping, int steps, const Setup& setup);

}  // namespace sulfur::lab
