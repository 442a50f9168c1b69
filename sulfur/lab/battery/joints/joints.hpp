// The scenes with wheels, hinges and other mechanisms, a family a function. Each runs at 500, 240,
// 120 and 60 Hz. What Box2D 3 does in the same scene, with 4 substeps, is told beside it where the
// laboratory was built with it; its rows have no bound.
#pragma once

#include "battery/row.hpp"

namespace sulfur::lab {

/// A disc rolls down 20 degrees for 2 s with 2/3 g sin, within 0.5 %. Rigid wheels of rim and hub
/// and a soft tyre should with g sin / (1 + I / (m r^2)); the corners of their rims brake them.
Rows rolling(const Setup& setup);

/// A strip of angular joints and a row of boxes on welds bend under a load at their end as theory
/// says, and a clamped column bears 0.98 of Euler's load, not 1.02 of it: within 2 %.
Rows bending(const Setup& setup);

/// A motor keeps its speed against a torque, and tells it, within 0.1 %; one that is too weak gives
/// all that it has. It lifts a beam at a steady speed.
Rows motors(const Setup& setup);

/// Limits that are met at 10 rad/s are passed by less than 0.01 rad, and not at all afterwards.
Rows limits(const Setup& setup);

/// A wagon on a rail at 30 degrees slides with g sin, stops at the rail's end, and is lifted by a
/// motor with its weight's share, within 0.1 %.
Rows sliders(const Setup& setup);

/// A car drives over half discs: its wheels stay within 1 mm of their axes, and it keeps its speed.
Rows bumps(const Setup& setup);

/// Two gears under a load keep their ratio for 1,000 turns (quick: 100) within 1e-6 rad.
Rows gears(const Setup& setup);

/// Ragdolls of ten hinges with limits fall down stairs for 10 minutes (quick: 20 s), each for 8 s:
/// no joint should come apart by 1 mm, and none does by 4.
Rows ragdolls(const Setup& setup);

/// All of them.
Rows joints(const Setup& setup);

}  // namespace sulfur::lab
