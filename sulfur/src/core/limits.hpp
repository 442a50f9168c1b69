// Bounds that keep every number finite.
#pragma once

#include <sulfur/math.hpp>

#include "core/settings.hpp"

namespace sulfur::detail {

inline constexpr double maxSpeed = 2000;  // m/s, per axis

/// A velocity, cut to what a particle may have.
inline Point limited(const Point& velocity) {
    return velocity.cwiseMax(-maxSpeed).cwiseMin(maxSpeed);
}

using tuned::attachingSpeed;
using tuned::closingSpeed;

/// The part of a constraint's error that a step of `duration` seconds leaves at a speed, m/s.
inline double errorLeft(double error, double duration, double speed = closingSpeed) {
    const double most = speed * duration;
    return error > most ? error - most : error < -most ? error + most : 0;
}

inline constexpr int minTickRate = 60, maxTickRate = 10000;         // Hz
inline constexpr double maxCoordinate = 1e9;                        // m
inline constexpr double maxForce = 1e12;                            // N
inline constexpr double minMass = static_cast<double>(Real(1e-9));  // kg
inline constexpr double maxMass = 1e12;                             // kg
/// Between the masses of what joints or attachments tie together: a tree eliminates one node after
/// the other in double precision, and a rope whose nodes differ by 1e10 may fly away.
inline constexpr double maxMassRatio = 1e9;
/// N m/rad, and rad: pi, also as Real rounds it.
inline constexpr double maxAngularStiffness = 1e12, maxAngle = 3.1415928;
inline constexpr double maxAcceleration = 1e6;  // m/s^2, gravity

/// Of an attached or grabbed point, in distances of its supports: a point much farther away would
/// magnify their rounding.
inline constexpr double farthestSupport = 50;

}  // namespace sulfur::detail
