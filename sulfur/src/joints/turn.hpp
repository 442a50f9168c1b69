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

/// How much of its bend an arm of this length gives, and how that grows with the arm (1/m).
struct ArmShare {
    double value = 1;
    Point slope{0, 0};
};

/// An arm that is pressed to nothing turns round. What its angle holds vanishes before, or that
/// would make energy.
inline ArmShare shareOfArm(const Point& arm, Real whole) {
    const double half = static_cast<double>(whole) / 2, square = arm.squaredNorm();
    if (square >= half * half) return {};
    const double length = std::sqrt(square);
    return {length / half, arm / (half * length)};
}

/// How far the turn from `u` = b - a to `v` = c - b is from its rest angle, where the arms are as
/// long as they were meant to be, or at least half of that. The gradient of the angle of a vector
/// is that vector, turned by a right angle, over the square of its length.
inline Turn turnOf(const Angles& angles, std::uint32_t i, const Point& u, const Point& v) {
    const double bent = withoutTurns(angleBetween(u, v) - static_cast<double>(angles.restAngle[i]));
    const ArmShare before = shareOfArm(u, angles.armBefore[i]);
    const ArmShare after = shareOfArm(v, angles.armAfter[i]);
    const double both = before.value * after.value;
    const Point byU =
        both / u.squaredNorm() * Point(u[1], -u[0]) + bent * after.value * before.slope;
    const Point byV =
        both / v.squaredNorm() * Point(-v[1], v[0]) + bent * before.value * after.slope;
    return {both * bent, {-byU, byU - byV, byV}};
}

/// Whether a turn has a direction.
inline bool hasTurn(const Point& u, const Point& v) {
    return u.squaredNorm() > 0 && v.squaredNorm() > 0;
}

}  // namespace sulfur::detail
