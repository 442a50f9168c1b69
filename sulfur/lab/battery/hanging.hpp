// Chains that hang: where they come to rest and how they swing.
#pragma once

#include "battery/row.hpp"

namespace sulfur::lab {

/// A rope of 40 rigid links of 0.05 m between two pins 1.2 m apart, braked by air until it rests.
/// Largest distance of a particle from the discrete catenary, over the rope's length: 0.1 %.
Row hangingBetweenPins(const Setup& setup);

/// A rope of 40 elastic links of 0.05 m (0.05 kg, `stiffness` N/m) hung from one end, let down and
/// braked by air until it rests. Largest distance of a particle from the chain's equilibrium, over
/// the length of the rope in equilibrium: 0.1 %.
Row hangingStretched(double stiffness, const Setup& setup);

/// A rope of 40 rigid links of 0.05 m hung from one end swings in its `mode` (1, 2, 3) by little.
/// Relative error of the frequency against that of the discrete chain (eigenvalues of its
/// stiffness under its own weight): at most 0.5 %.
Row swingFrequency(int mode, const Setup& setup);

/// 20 springs of 1 and 10^6 N/m in turn, 0.1 m long, with particles of 1 g between them, hang from
/// one end, braked by air until they rest. Largest relative error of a spring's force
/// (JointInfo::force) against the weight below it: at most 1 %.
Row alternatingSprings(const Setup& setup);

}  // namespace sulfur::lab
