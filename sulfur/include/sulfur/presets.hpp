/// \file
/// The constants of the paper "Unifying Rigid and Soft Bodies Representation: The Sulfur Physics
/// Engine" (2014) by name, with their units, for whoever wants to build what it measured.
///
/// Where the paper gives a number without a unit, the unit here is the one with which its equations
/// are consistent; `sulfur_lab` works with the same.
#pragma once

#include <sulfur/shapes.hpp>
#include <sulfur/world.hpp>

/// The constants of the paper.
namespace sulfur::presets {

/// Hz: the rate at which the paper's game runs.
inline constexpr int tickRate = 500;

/// N s/m: the damping of a joint, b in the paper's equation (1). The paper damps the whole
/// difference of velocities; JointSpec::damping acts along the joint, so that it does not brake
/// rotation.
inline constexpr Real damping = Real(0.2);

/// N s/m: air friction of the paper's rope. There it is a force, -0.02 v, on each particle.
inline constexpr Real airFrictionForce = Real(0.02);

/// Particles of the paper's rope.
inline constexpr int ropeParticles = 40;
/// Metres: length of a link of the paper's rope.
inline constexpr Real ropeLinkLength = Real(0.05);
/// Kilograms: mass of a particle of the paper's rope.
inline constexpr Real ropeParticleMass = Real(0.05);

/// 1/s: the same air friction as World knows it, as acceleration per speed: force per speed over
/// the mass of a particle, 0.02 / 0.05 = 0.4. For particles of another mass it is another number.
inline constexpr Real airFriction = airFrictionForce / ropeParticleMass;

/// A world with the paper's tick rate and the air friction of its rope.
inline WorldSettings world() {
    WorldSettings settings;
    settings.airFriction = airFriction;
    settings.tickRate = tickRate;
    return settings;
}

/// The paper's rope: 40 particles of 0.05 kg in a row, links of 0.05 m, the first particle held.
/// It starts horizontal, from the origin along x. `stiffness` in N/m, 0 to infinity; the paper
/// varies it.
inline shapes::RopeOptions rope(Real stiffness = 100) {
    shapes::RopeOptions options;
    options.links = ropeParticles - 1;
    options.from = Vec2(0, 0);
    options.to = Vec2(static_cast<Real>(ropeParticles - 1) * ropeLinkLength, 0);
    options.mass = static_cast<Real>(ropeParticles) * ropeParticleMass;
    options.stiffness = stiffness;
    options.damping = damping;
    options.bending = 0;
    options.pinFirst = true;
    return options;
}

/// The paper's box of Table 4: four corner masses and six joints, with three times the moment of
/// inertia of a solid. `size` is the outer size in metres, `mass` in kilograms.
inline shapes::BoxOptions plainBox(Vec2 size = {1, 1}, Real mass = 1) {
    shapes::BoxOptions options;
    options.size = size;
    options.mass = mass;
    options.solidInertia = false;
    return options;
}

}  // namespace sulfur::presets
