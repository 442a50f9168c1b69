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
    std::string name = {};                     ///< for people and files
    BodyKind kind = BodyKind::dynamic;         ///< who moves it
    std::vector<ParticleSpec> particles = {};  ///< at least one
    std::vector<JointSpec> joints = {};        ///< between them
    Material material = {};                    ///< of its surface
    Filter filter = {};                        ///< what it collides with
    bool selfCollision = false;                ///< whether its own parts touch each other
    bool sensor = false;                       ///< whether it only feels; see World::setSensor
    std::optional<Skin> skin = std::nullopt;   ///< what it wears

    /// Throws Error, naming the offending particle or joint, unless all of it is usable: at least
    /// one particle, every number finite and in its range, every index in range, no joint from a
    /// particle to itself, no rigid or capsule joint of length zero, every material in its range.
    void validate() const;

    /// Total mass in kilograms, pinned particles included.
    Real mass() const;
    /// Mass-weighted mean position in the body's frame.
    Vec2 centreOfMass() const;
};

}  // namespace sulfur
