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
    double angular = 0;        ///< N m s about `about`
    double angularScale = 0;   ///< sum of m |v| |x - about|, N m s
    double energy = 0;         ///< J: kinetic, elastic and gravitational
    double kinetic = 0;        ///< J
    double elastic = 0;        ///< J
    double gravitational = 0;  ///< J, zero at the origin
};

/// Measures the particles as they are, each with the velocity that the world tells. That is the
/// truth where velocities were just set; after a tick it holds for what turns by a small angle in a
/// tick.
Momenta momentaAsTold(const World& world, const Point& about);

/// Measures a copy of the world after one tick of 0.1 ms. A velocity is the mean over a tick, the
/// chord of what turns, so that a crate of 1,000 rad/s seems to stand still at 160 Hz; over 0.1 ms
/// the chord tells the angle, and the spin of rigid bodies is taken from that. Holds up to
/// 10,000 rad/s. The tick itself changes nothing of what a closed world keeps.
Momenta momentaOf(const World& world, const Point& about);

/// Whether the particles of a body turn as one, as its joints tell.
bool isRigid(const World& world, BodyId body);

/// The mass-weighted mean place of all that is dynamic.
Point centreOf(const World& world);

}  // namespace sulfur::lab
