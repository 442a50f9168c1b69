/// \file
/// Force fields: what acts on every particle in a region.
///
/// A field is given as an acceleration, which is force per mass, so that light and heavy things
/// answer alike, as they do to gravity; the force on a particle is its mass times that. Fields act
/// on the particles of dynamic bodies that are awake, at the place where the tick begins, and add
/// up. A body at rest in a field may fall asleep; adding, changing or removing a field wakes what
/// the field acts upon, and nothing else does.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>
#include <variant>

namespace sulfur {

/// The whole world.
struct Everywhere {};

/// A rectangle, edges included.
struct BoxZone {
    Point low{0, 0};   ///< metres, lower left corner
    Point high{0, 0};  ///< metres, upper right corner; more than `low` on both axes
};

/// A disc, edge included.
struct CircleZone {
    Point centre{0, 0};  ///< metres
    Real radius = 1;     ///< metres, > 0
};

/// Where a field acts.
using Zone = std::variant<Everywhere, BoxZone, CircleZone>;

/// The same acceleration everywhere in a zone: a second gravity, a river.
struct UniformField {
    Zone zone = Everywhere{};          ///< where it acts
    Vec2 acceleration{0, 0};           ///< m/s^2, each axis up to 1e6 either way
    std::uint32_t mask = 0xffffffffu;  ///< acts on bodies with one of these Filter::category
};

/// An acceleration towards a point or away from it, `strength / distance^falloff`.
///
/// Nearer than `core` it goes down to 0 at the centre in proportion to the distance; farther than
/// `reach` there is none. It is never more than 1e6 m/s^2.
struct RadialField {
    Point centre{0, 0};                ///< metres
    Real strength = 10;                ///< m/s^2 at a distance of 1 m; positive attracts
    int falloff = 2;                   ///< 0 to 4; 0 constant, 2 as gravity does
    Real core = Real(0.1);             ///< metres, 1e-3 to 1e6
    Real reach = infinite;             ///< metres, > 0
    std::uint32_t mask = 0xffffffffu;  ///< acts on bodies with one of these Filter::category
};

/// Moving air: it drags everything towards its own velocity, `drag * (velocity - v)`.
///
/// The drag is taken implicitly, so that no value makes anything unstable and nothing is ever
/// blown faster than the wind; that of several winds adds up. With zero velocity it is a zone of
/// thick air or water.
struct WindField {
    Zone zone = Everywhere{};          ///< where it blows
    Vec2 velocity{0, 0};               ///< m/s, each axis up to 2000 either way
    Real drag = 1;                     ///< 1/s, 0 to the tick rate
    std::uint32_t mask = 0xffffffffu;  ///< acts on bodies with one of these Filter::category
};

/// Any of the fields.
using Field = std::variant<UniformField, RadialField, WindField>;

}  // namespace sulfur
