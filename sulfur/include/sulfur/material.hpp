/// \file
/// How the surface of a body behaves, and what it collides with.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>

namespace sulfur {

/// Surface constants of a body or of one of its joints. Where two surfaces meet, each coefficient
/// of friction is the geometric mean of the two, restitution the larger one, and surface speeds
/// add up. Impacts below WorldSettings::reboundSpeed never rebound.
struct Material {
    Real staticFriction = Real(0.6);   ///< coefficient, kineticFriction to 1e6
    Real kineticFriction = Real(0.5);  ///< coefficient, 0 to 1e6
    Real restitution = 0;              ///< 0 (no rebound) to 1 (full rebound)
    /// m/s, up to 1000 either way, at which the surface runs along itself as a conveyor belt does:
    /// to the right of its outward normal, so that a belt carries what lies on it towards +x.
    Real surfaceSpeed = 0;

    /// Member by member.
    friend bool operator==(const Material&, const Material&) = default;
};

/// Which bodies collide, unless World::setCollision() lets the two pass: both must have a category
/// in the other's mask. Bodies that share a group other than 0 always collide when it is positive
/// and never when it is negative.
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
