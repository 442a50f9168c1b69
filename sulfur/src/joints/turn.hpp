// The angle between two neighbours of a particle, and its gradient.
#pragma once

#include <cmath>

#include "core/trigonometry.hpp"
#include "model/angles.hpp"

namespace sulfur::detail {

/// An angle without whole turns, -pi to pi, of one between -3 pi and 3 pi.
inline double withoutTurns(double angle) {
    if (angle > fullTurn / 2) return angle - fullTurn;
    return angle < -fullTurn / 2 ? angle + fullTurn : angle;
}

/// The angle of `v` less that of `u`. Neither may be zero.
inline double angleBetween(const Point& u, const Point& v) {
    return angleOf(Point(u.dot(v), cross(u, v)));
}

/// The turn from `u` = b - a to `v` = c - b. The gradient of the angle of a vector is that vector,
/// turned by a right angle, over the square of its length.
inline Turn turnOf(const Point& u, const Point& v) {
    const Point atA = Point(-u[1], u[0]) / u.squaredNorm();
    const Point atC = Point(-v[1], v[0]) / v.squaredNorm();
    return {angleBetween(u, v), {atA, -(atA + atC), atC}};
}

/// Whether a turn has a direction.
inline bool hasTurn(const Point& u, const Point& v) {
    return u.squaredNorm() > 0 && v.squaredNorm() > 0;
}

}  // namespace sulfur::detail
