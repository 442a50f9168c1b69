// What contacts press, as those see it who ask about them one by one.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>

namespace sulfur::detail {

/// A particle held off a point of a capsule, or of a disc (then a == b).
struct ContactLoad {
    std::uint32_t particle = 0;
    std::uint32_t a = 0, b = 0;  // the capsule's particles
    std::uint32_t bodyA = 0, bodyB = 0;
    Real weightA = 0, weightB = 0;             // of the capsule's particles, adding up to 1
    Vec2 normal{0, 0};                         // unit, from the capsule towards the particle
    Real normalLambda = 0, tangentLambda = 0;  // kg m, in a step
};

}  // namespace sulfur::detail
