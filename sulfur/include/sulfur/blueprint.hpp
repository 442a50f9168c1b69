/// \file
/// The plan of a body: plain data, the one currency between the ready-made shapes, scene files,
/// the editor, prefabs and the game.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <sulfur/material.hpp>
#include <sulfur/math.hpp>
#include <sulfur/mechanisms.hpp>
#include <vector>

namespace sulfur {

/// A point mass. Without a radius it touches nothing by itself; with one it is a disc.
struct ParticleSpec {
    Vec2 position{0, 0};  ///< metres, in the body's frame; each axis up to 5e8 either way
    Real mass = 1;        ///< kilograms, 1e-9 to 1e12; the ratio of any two at most 1e9
    Real radius = 0;      ///< metres, >= 0
    bool pinned = false;  ///< held where it is; it behaves as if its mass were infinite
};

/// A connection that holds two particles at a distance.
struct JointSpec {
    std::uint32_t a = 0;        ///< index into Blueprint::particles
    std::uint32_t b = 0;        ///< index into Blueprint::particles, not `a`
    Real stiffness = infinite;  ///< k in N/m, 0 to infinity; `infinite` is rigid
    Real damping = 0;           ///< b in N s/m, >= 0, along the joint; ignored when rigid
    std::optional<Real> restLength =
        std::nullopt;          ///< metres, >= 0; the particles' distance when not given
    Real radius = 0;           ///< metres; > 0: a capsule that collides; 0: structural
    Real strength = infinite;  ///< newtons; a larger force breaks the joint
    /// Of its surface, if that differs from its body's. A particle shows the surface of the
    /// thickest capsule that ends in it.
    std::optional<Material> material = std::nullopt;
    /// Radians, -pi to pi (3.1416): the axis of a capsule is an arc that turns by so much from a to
    /// b, anticlockwise where it is positive, and pushes with its curved surfaces, both of them.
    /// Only of a rigid joint with a radius, and only while both ends move as one: as parts of what
    /// rigid joints hold rigid, or of a fixed or kinematic body; else it is straight, as a link of
    /// a chain is. What is nearer to 0 than 0.001 is straight, too. Exact to 1e-7 of the arc's
    /// radius. Casts, overlaps and the debug drawing see it as chords, which leave it by at most a
    /// hundredth of the capsule's radius, or are 256.
    Real bend = 0;
};

/// An elastic angle at a particle between two others of its body. The angle is the turn from the
/// direction a to b to that from b to c, in radians, positive anticlockwise, -pi to pi: 0 where the
/// three go straight on. A torque of -stiffness (angle - restAngle) - damping d(angle)/dt acts on
/// it, where the difference of angles is without whole turns too. What it pushes with follows from
/// the gradient of the angle, so that momentum and angular momentum stay what they are.
///
/// Like elastic joints, soft ones are forces and stiffer ones constraints, without a border. Where
/// joints lead from a to b or from b to c, the angular joint goes when one of them breaks or is
/// removed; else it goes when its particles come to be of different bodies.
///
/// One with limits, a motor or the stiffness `infinite` is driven: it is solved as a hinge between
/// two bodies is, and its angle counts whole turns, from between -pi and pi when it is made. All of
/// it together is a Drive; World::setDrive changes it.
struct AngularJointSpec {
    std::uint32_t a = 0;  ///< index into Blueprint::particles
    std::uint32_t b = 0;  ///< index into Blueprint::particles, the corner, apart from both others
    std::uint32_t c = 0;  ///< index into Blueprint::particles; all three differ
    Real stiffness = 0;   ///< N m/rad, 0 to 1e12 or `infinite`
    Real damping = 0;     ///< N m s/rad, 0 to 1e12
    std::optional<Real> restAngle =
        std::nullopt;        ///< radians, -pi to pi (3.1416); as the particles stand when not given
    Real lower = -infinite;  ///< radians, the least angle
    Real upper = infinite;   ///< radians, the largest one, not less than `lower`
    Real motorSpeed = 0;     ///< rad/s, -1e6 to 1e6: what the motor wants
    Real motorMax = 0;       ///< N m, 0 to `infinite`: the most that it gives; 0: no motor
    /// Radians: a motor that goes there and stays, at most as fast as the size of `motorSpeed`.
    std::optional<Real> motorTarget = std::nullopt;
    /// N m, above 0, or `infinite`: it breaks when spring and motor, or the limits, give more. Of
    /// those of a body that are loaded so the worst one breaks, which relieves the others.
    Real strength = infinite;
};

/// A texture worn by a body: mapped at rest, drawn through the live particles.
struct Skin {
    std::string texture = {};   ///< asset name
    std::vector<Vec2> uv = {};  ///< one per particle; 0..1, v points down
    std::vector<std::array<std::uint32_t, 3>> triangles = {};  ///< indices of particles
};

/// Who moves a body.
enum class BodyKind : std::uint8_t {
    dynamic,    ///< physics
    kinematic,  ///< the caller, through World::moveTo or setVelocity; pushes others
    fixed,      ///< nobody; only collides
};

/// Everything that World::add needs to know to make a body.
struct Blueprint {
    std::string name = {};                      ///< for people and files
    BodyKind kind = BodyKind::dynamic;          ///< who moves it
    std::vector<ParticleSpec> particles = {};   ///< at least one
    std::vector<JointSpec> joints = {};         ///< between them
    std::vector<AngularJointSpec> angles = {};  ///< the same
    Material material = {};                     ///< of its surface
    Filter filter = {};                         ///< what it collides with
    bool selfCollision = false;                 ///< whether its own parts touch each other
    bool sensor = false;                        ///< whether it only feels; see World::setSensor
    std::optional<Skin> skin = std::nullopt;    ///< what it wears

    /// Throws Error, naming the offending particle or joint, unless all of it is usable: at least
    /// one particle, every number finite and in its range, every index in range, no joint from a
    /// particle to itself, no rigid or capsule joint of length zero, no angular joint at a particle
    /// that stands where a neighbour stands, every material in its range.
    void validate() const;

    /// Total mass in kilograms, pinned particles included.
    Real mass() const;
    /// The rest angle of an angular joint between these particles in radians: what is given, or as
    /// they stand.
    Real restAngle(const AngularJointSpec& joint) const;
    /// All that acts on such an angle, as World::setDrive takes it.
    Drive drive(const AngularJointSpec& joint) const;
    /// Mass-weighted mean position in the body's frame.
    Vec2 centreOfMass() const;
};

}  // namespace sulfur
