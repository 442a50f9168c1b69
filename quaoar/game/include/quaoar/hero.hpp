// The hero: a soft body of particles.
#pragma once

#include <sulfur/blueprint.hpp>

namespace quaoar {

/// Numbers of the hero, and of how it may move.
struct HeroRules {
    sulfur::Real radius = sulfur::Real(0.12);      ///< m, outer
    sulfur::Real skinRadius = sulfur::Real(0.02);  ///< m, half the thickness of the outline
    sulfur::Real coreRadius = sulfur::Real(0.05);  ///< m: no blow flattens the hero beyond it
    int segments = 12;                             ///< particles of the outline
    sulfur::Real mass = 2;                         ///< kg in all
    sulfur::Real coreMass = sulfur::Real(0.5);     ///< kg of the particle in the middle
    sulfur::Real stiffness = 2500;                 ///< N/m of the springs along the outline
    sulfur::Real spokeStiffness = 1500;            ///< N/m of those to the middle
    /// N s/m of every spring. Together with the rope's link it stays below the limit at which the
    /// library would have to integrate the hero implicitly and swallow the swing's energy.
    sulfur::Real damping = sulfur::Real(2.5);
    sulfur::Real speedLimit = 11;  ///< m/s of the whole hero
    sulfur::Real push = 5;         ///< N, sideways, while swinging
    /// On the ground and without a rope a couple brakes his rolling: by this share of his weight at
    /// the lever of his radius ...
    sulfur::Real rollingResistance = sulfur::Real(0.3);
    /// ... and 1/s in proportion to how fast he turns.
    sulfur::Real rollingDamping = 5;
    sulfur::Real settling = 20;  ///< 1/s: of his wobbling, on the ground and without a rope
    /// Squeezed flat: two opposite points of the outline are nearer to each other than this share
    /// of their distance at rest, for so many ticks, between things that touch him on both sides.
    sulfur::Real flat = sulfur::Real(0.45);
    int flatTicks = 20;
};

/// Bits of sulfur::Filter that the game uses. Levels leave bodies in `scenery` unless they have a
/// reason.
struct Category {
    static constexpr std::uint32_t scenery = 1u << 0;
    static constexpr std::uint32_t hero = 1u << 1;
    static constexpr std::uint32_t rope = 1u << 2;
};

/// The hero at rest around the origin: particle 0 is the middle, where the rope is tied; the
/// others are the outline, counter-clockwise from the right. Wears the skin "hero.svg".
sulfur::Blueprint heroBlueprint(const HeroRules& rules = {});

}  // namespace quaoar
