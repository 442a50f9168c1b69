/// \file
/// How the surface of a body behaves, and what it collides with.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>

namespace sulfur {

/// Surface constants of a body or of one of its joints. Where two surfaces meet, each coefficient
/// of friction is the geometric mean of the two, restitution and rolling resistance are the larger
/// ones, and surface speeds add up. Impacts below WorldSettings::reboundSpeed never rebound.
struct Material {
    Real staticFriction = Real(0.6);   ///< coefficient, kineticFriction to 1e6
    Real kineticFriction = Real(0.5);  ///< coefficient, 0 to 1e6
    Real restitution = 0;              ///< 0 (no rebound) to 1 (full rebound)
    /// m/s, up to 1000 either way, at which the surface runs along itself as a conveyor belt does:
    /// to the right of its outward normal, so that a belt carries what lies on it towards +x.
    Real surfaceSpeed = 0;
    /// Coefficient, 0 to 1000: of a couple against how two rigid bodies that press on each other
    /// turn against each other, at most c R N, with the force N of their contact and 1/R = 1/R1 +
    /// 1/R2, where each R is how far the centre of a body is from the plane of the contact, and
    /// what cannot turn counts as flat (Ai et al. 2011, "Assessment of rolling resistance models in
    /// discrete element simulations", model A). For a disc on flat ground this is engineering's
    /// coefficient of rolling resistance: a force of c N at its axle keeps it rolling, it loses
    /// 2/3 c g by itself, and stays on slopes of less than atan(c). What is soft rolls nobody. Not
    /// with Friction::sliding, under which nothing rolls.
    Real rollingResistance = 0;

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
