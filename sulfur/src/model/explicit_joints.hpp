// Elastic joints that are forces, in batches that the kernels take as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur::detail {

/// Neighbours in the list that share no particle: of several instances of one blueprint, the same
/// joint of each.
struct ForceBatch {
    std::uint32_t first = 0, last = 0;  // in the list
    std::uint32_t place = 0;            // of the first in the arrays, if `wide`
    bool wide = false;                  // enough of them for a kernel
    bool damped = false;                // some of them have dampers
};

/// The arrays that ForceView points into, derived with the work lists.
struct ExplicitJoints {
    std::vector<ForceBatch> batches;
    bool byBodies = false;  // each in one body, and those of a batch in the order of the bodies
    std::vector<std::uint32_t> joint, a, b;
    std::vector<Real> rest, stiffness, damping;
    // Scratch of batchExplicitJoints().
    std::vector<std::uint32_t> levelOfParticle, levelOfJoint, sorted, levelStart;
};

}  // namespace sulfur::detail
