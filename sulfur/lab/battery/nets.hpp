// Nets and frames: what is tied together in loops, under loads.
#pragma once

#include "battery/row.hpp"

namespace sulfur::lab {

/// A net of 20 x 20 rigid joints, hung by two corners, with a node of 1 to 10^6 times the mass of
/// the others in its middle: the largest strain while it comes to rest (1 %) and then (0.1 %). A
/// net that is let go at one corner: the same, and its energy. A ladder with a weight that swings:
/// strain and energy.
Rows nets(const Setup& setup);

}  // namespace sulfur::lab
