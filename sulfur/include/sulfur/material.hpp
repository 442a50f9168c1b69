/// \file
/// How the surface of a body behaves, and what it collides with.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>

namespace sulfur {

/// Surface constants of a body. Where two bodies meet, friction is the geometric mean of the two
/// and restitution the larger one.
struct Material {
    Real staticFriction = Real(0.6);   ///< coefficient, >= kineticFriction
    Real kineticFriction = Real(0.5);  ///< coefficient, >= 0
    Real restitution = 0;              ///< 0 (no rebound) to 1 (full rebound)

    /// Member by member.
    friend bool operator==(const Material&, const Material&) = default;
};

/// Which bodies collide: both must have a category in the other's mask. Bodies that share a
/// group other than 0 always collide when it is positive and never when it is negative.
struct Filter {
    std::uint32_t category = 1;        ///< bits: what the body is
    std::uint32_t mask = 0xffffffffu;  ///< bits: what it collides with
    std::int32_t group = 0;            ///< 0: no group

    /// Member by member.
    friend bool operator==(const Filter&, const Filter&) = default;
};

/// Whether `a` and `b` may collide.
inline bool mayCollide(const Filter& a, const Filter& b) {
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

}  // namespace sulfur
