/// \file
/// What a world tells of particles, joints, attachments and contacts.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/ids.hpp>
#include <sulfur/math.hpp>
#include <sulfur/mechanisms.hpp>

namespace sulfur {

/// What a particle is at the moment.
struct ParticleInfo {
    BodyId body = {};      ///< whose it is
    Point position{0, 0};  ///< metres
    Vec2 velocity{0, 0};   ///< m/s; see World::velocity
    Real mass = 0;         ///< kg
    Real radius = 0;       ///< m
    bool pinned = false;   ///< whether it is held where it is
    double angle = 0;      ///< rad, -pi to pi: how far a disc that rolls has turned, else 0
    double spin = 0;       ///< rad/s, of a disc that rolls, else 0
};

/// What a joint is at the moment.
struct JointInfo {
    BodyId body = {};     ///< null for a joint between bodies
    ParticleId a = {};    ///< one end
    ParticleId b = {};    ///< the other end
    Real restLength = 0;  ///< m
    Real stiffness = 0;   ///< N/m
    Real damping = 0;     ///< N s/m
    Real radius = 0;      ///< m
    Real strength = 0;    ///< N
    Real force = 0;       ///< N in the last tick, positive when it pulls
    Real bend = 0;        ///< radians, by which its capsule turns from a to b
};

/// What an angular joint is at the moment; see AngularJointSpec.
struct AngleInfo {
    AngleId id = {};    ///< its handle
    BodyId body = {};   ///< whose it is
    ParticleId a = {};  ///< one neighbour
    ParticleId b = {};  ///< the corner
    ParticleId c = {};  ///< the other neighbour
    Drive drive = {};   ///< spring, limits, motor and strength, in rad and N m
    /// Radians: the turn from a to b to that from b to c. -pi to pi, with whole turns if it is
    /// driven.
    double angle = 0;
    Real torque = 0;       ///< N m in the last tick, positive where it makes the angle larger
    bool atLower = false;  ///< whether the lower limit pushed in the last tick
    bool atUpper = false;  ///< the same of the upper one
};

/// What an attachment is: its particle is held at the sum of weight_i times the place of support_i.
struct AttachmentInfo {
    ParticleId particle = {};                 ///< what is held
    std::uint32_t count = 0;                  ///< of supports, 1 to 3
    std::array<ParticleId, 3> supports = {};  ///< the first `count` are valid, the others null
    std::array<Real, 3> weights{0, 0, 0};     ///< their sum is 1; 0 beyond `count`
};

/// What a contact of the last tick was, or of a sleeper's last tick awake, with what impacts gave.
struct ContactInfo {
    BodyId a = {};      ///< the body whose particle touches
    BodyId b = {};      ///< the body whose capsule or disc is touched
    Point point{0, 0};  ///< metres
    Vec2 normal{0, 0};  ///< unit, from b towards a
    Real impulse = 0;   ///< N s along the normal in that tick
    Real friction = 0;  ///< N s along the normal turned by a right angle counter-clockwise
};

}  // namespace sulfur
