// By how much the axis of a capsule is bent.
#pragma once

#include <sulfur/math.hpp>

namespace sulfur::detail {

/// rad: less than that is taken for straight, more than that is refused: half a circle.
inline constexpr double leastBend = 1e-3, mostBend = 3.1416;

/// rad, by which a capsule turns from its end a to its b; 0: it is straight.
struct Bend {
    Real angle = 0;
};

}  // namespace sulfur::detail
