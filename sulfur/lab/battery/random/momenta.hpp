// What a world without outer forces keeps, measured through the public interface alone.
#pragma once

#include <Eigen/Core>
#include <sulfur/sulfur.hpp>

namespace sulfur::lab {

/// The sum of m v over what is dynamic and not pinned, N s, and of m |v|, its fair scale.
struct Momentum {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double scale = 0;
};
Momentum momentumOf(const World& world);

/// What the particles of a world do at one moment.
struct Momenta {
    Momentum linear;
    double angular = 0;        ///< N m s about a point
    double angularScale = 0;   ///< sum of m |v| |r|, N m s
    double kinetic = 0;        ///< J
    double energy = 0;         ///< J: kinetic, elastic and gravitational, as World::energy
    double gravitational = 0;  ///< J of it, zero at the origin
};

/// Measures by what World::velocity tells. Where that is the chord of what turns, the spin of what
/// is rigid is mended: of a chord over the angle a, the part across the radius is sin(a) / h and
/// the part along it (1 - cos(a)) / h, so that a = 2 atan(along / across) whatever the step h was,
/// and the spin is a / sin(a) times the part across. Of what turns by half a turn in a step or more
/// nobody can tell.
Momenta momentaOf(const World& world, const Point& about);

/// The mass-weighted mean place of all that is dynamic.
Point centreOf(const World& world);

}  // namespace sulfur::lab
