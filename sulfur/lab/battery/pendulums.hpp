// Swinging on a rigid joint, and solid bodies on a hinge.
#pragma once

#include <sulfur/math.hpp>

#include "battery/row.hpp"

namespace sulfur::lab {

/// A particle on a rigid joint of 1 m, released at rest at 90 degrees. Relative error of its mean
/// period against the elliptic integral, at most 0.1 %; energy lost, and gained, at the end as a
/// share of what the fall sets free, at most 0.5 %.
Rows pendulum(double seconds, const Setup& setup);

/// How a solid rectangle hangs.
enum class Hinge {
    corner,  ///< one of its corner particles is pinned
    top,     ///< the middle of its upper edge is attached to a fixed particle
};

/// A solid rectangle of `size` metres (outer), released at rest 30 degrees aside. Relative error of
/// its mean period against that of the solid body, elliptic integral included: at most 0.5 %.
Row solidPendulum(Vec2 size, Hinge hinge, const Setup& setup);

}  // namespace sulfur::lab
