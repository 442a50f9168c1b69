// Which bars of a framework form infinitesimally rigid sets.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur::detail {

/// A rigid connection of two particles of a framework.
struct Bar {
    std::uint32_t a = 0, b = 0;
};

/// For each bar the number (0, 1, ...) of the rigid set that it belongs to, or `none` for a bar
/// that is no part of a rigid set of three or more particles. Two sets may share a particle.
///
/// A set of n particles is infinitesimally rigid when its bars leave it three freedoms (rank
/// 2n - 3). Bars that share a particle belong to the same set if they turn alike in every motion
/// that the framework allows; a random one of these motions tells with probability 1. So an
/// unbraced square, a straight rope or a flat triangle is not rigid, and K(3,3) is.
///
/// Complexity: one sparse factorisation of a matrix of twice the particles' number, and none for
/// a framework without cycles.
std::vector<std::uint32_t> findRigidSets(const std::vector<Point>& positions,
                                         const std::vector<Bar>& bars);

}  // namespace sulfur::detail
