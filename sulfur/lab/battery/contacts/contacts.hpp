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

/// An arch of wedges between fixed abutments and a house of cards stand for 60 s (quick: 20 s): no
/// part is more than 0.1 m from its place.
Rows arches(const Setup& setup);

/// The mean upward force of the contacts with the floor over 1 s is the weight of what stands on
/// it, within 1 %.
Rows weights(const Setup& setup);

/// Ropes of 0.5 kg with loads up to 100 times that over the edges of crates hold for 20 s; they are
/// never deeper in them than half of their radius. Over a peg a rope slips within 15 % of the
/// ratio of loads that theory says, 40 % when the load is 10,000 times a link.
Rows ropesOverEdges(const Setup& setup);

/// Bodies that start in each other by 10 to 100 % are apart after 3 s, within a tenth of a
/// capsule's thickness, and in free space no particle is ever faster than 1 m/s.
Rows overlaps(const Setup& setup);

/// Equal impulses give a soft and a rigid body of the same mass the same velocity of the centre,
/// within 1e-5; projectiles change no total momentum by more than 1e-6.
Rows impulses(const Setup& setup);

/// What slides over the seams of a floor has no vertical speed above 1e-3 of its speed.
Rows seams(const Setup& setup);

/// Segments that fall end-on or lie across a seam come to rest on a floor of segments (the paper's
/// figure 7).
Rows segments(const Setup& setup);

/// `setup.shots` random shots (quick: at most 1,000) against thin walls and as many against bodies:
/// none passes through, and no energy grows by more than 1e-4 of itself.
Rows shots(const Setup& setup);

/// 1,000 (quick: 200) discs, crates, jellies and ropes of 0.2 to 0.3 m pour through a funnel, turn
/// in a drum and are pressed together to a fill of 85 %: none is lost, and at last no overlap is
/// deeper than a tenth of a capsule's radius.
Rows crowds(const Setup& setup);

/// A wall that a ball breaks: at least three pieces, which collide; none ends below the floor.
Rows crumbling(const Setup& setup);

}  // namespace sulfur::lab
