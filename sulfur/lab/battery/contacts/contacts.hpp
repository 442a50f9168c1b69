// The scenes with contacts, a family a function. Lengths in metres, at 500 Hz, nothing sleeps
// unless a row says so.
#pragma once

#include "battery/row.hpp"

namespace sulfur::lab {

/// A crate on a slope whose steepness is 0.98 of the static friction coefficient creeps less than
/// 0.1 mm in 60 s; at 1.02 of it, with a kinetic coefficient of 0.8 of the static one, it starts
/// by itself and has the acceleration g (sin - mu_k cos) within 1 %.
Rows inclines(const Setup& setup);

/// A disc falls 2 m with a restitution e of 0.5 and 0.9: its first five rebounds are e^(2n) times
/// as high, within 3 %.
Rows rebounds(const Setup& setup);

/// 20 crates one on another stand for 60 s: they sink less than 1 cm, shift less than 1 cm and
/// move slower than 1 mm/s; with sleep they sleep within 5 s and are then at rest. With a top crate
/// 100 times as heavy they sink less than 5 cm.
Rows stacks(const Setup& setup);

/// Pyramids of crates with a base of 10, 20 and 40 stand for 60 s (quick: 10 s); base 40 sinks less
/// than 5 cm and no crate shifts by 1 cm.
Rows pyramids(const Setup& setup);

}  // namespace sulfur::lab
