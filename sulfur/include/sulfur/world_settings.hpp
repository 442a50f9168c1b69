/// \file
/// What a world is made with.
#pragma once

#include <cstdint>
#include <optional>
#include <sulfur/math.hpp>

namespace sulfur {

/// What the damper of an elastic joint brakes.
enum class Damper : std::uint8_t {
    axial,  ///< stretching only: a body turns freely
    full,   ///< all relative motion of its ends, also turning, as equation (1) of the paper has it
};

/// How touching surfaces brake each other.
enum class Friction : std::uint8_t {
    /// Coulomb's: what sticks stays where it is until static friction is exceeded, then slides
    /// against kinetic friction.
    coulomb,
    /// The paper's (section 3.3): a force against the sliding velocity and proportional to it. The
    /// kinetic coefficients are read as N s/m; nothing ever sticks, and discs do not roll.
    sliding,
};

/// What a world is made with.
struct WorldSettings {
    Vec2 gravity{0, Real(-9.81)};  ///< m/s^2
    Real airFriction = 0;  ///< 1/s, 0 to the tick rate: acceleration -airFriction * velocity
    int tickRate = 500;    ///< Hz, 60 to 10000; below 480 a tick takes several equal steps
    bool sleeping = true;  ///< whether islands at rest fall asleep
    Damper damper = Damper::axial;          ///< of all elastic joints
    Friction friction = Friction::coulomb;  ///< of all contacts
    bool tellPersisting = false;            ///< whether Events::contactsPersisted is filled
    int sweeps = 4;  ///< 1 to 100 passes over the constraints in a step: at most over contacts
                     ///< alone, at least beside joints, where contacts may ask for twice as many
    /// m/s, 0 to 2000: what moves slower for half a second falls asleep; 0: nothing does. When not
    /// given 0.005 under a gravity of 1 to 100 m/s^2; under less or more in proportion to that, so
    /// that nothing falls asleep where it turns around in the air. Without any gravity 0.005 where
    /// air friction or damping slows what moves, else 0.00005, because it drifts on for ever. (So
    /// it is also for bodies on which little of gravity acts, see World::setGravityScale.)
    std::optional<Real> sleepSpeed = std::nullopt;
    /// m/s, 0 to 2000: what meets slower does not rebound, so that what lies comes to rest. When
    /// not given 0.1, and under little or much gravity in the same proportion.
    std::optional<Real> reboundSpeed = std::nullopt;
};

}  // namespace sulfur
