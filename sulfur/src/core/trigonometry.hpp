// Sine, cosine and angles with the same bits on every machine.
//
// The C library's differ between versions and vendors; poses enter the simulation through these
// instead, and leave it, because callers give back what they were told. Range reduction to [-pi/4,
// pi/4] in two steps (Cody and Waite) and the Taylor series, whose first dropped term is below
// 1e-17 there.
#pragma once

#include <algorithm>
#include <cmath>
#include <sulfur/math.hpp>

namespace sulfur::detail {

inline constexpr double fullTurn = 6.283185307179586;

/// The series' factors: each term is the one before it times -r^2 times one of these.
inline constexpr double sineFactors[] = {1.0 / 210, 1.0 / 156, 1.0 / 110, 1.0 / 72,
                                         1.0 / 42,  1.0 / 20,  1.0 / 6};
inline constexpr double cosineFactors[] = {1.0 / 240, 1.0 / 182, 1.0 / 132, 1.0 / 90,
                                           1.0 / 56,  1.0 / 30,  1.0 / 12,  1.0 / 2};

/// (cos angle, sin angle); `angle` finite, accurate to about 1e-15 for |angle| < 1e6.
inline Point unitVector(double angle) {
    constexpr double quarters = 4 / fullTurn;
    constexpr double quarterHigh = 1.5707963267341256;    // the first 33 bits of pi/2
    constexpr double quarterLow = 6.077100506506192e-11;  // the rest
    // Small angles, as steps turn things by, need no call of the C library to find that it is none.
    // (Less a negative zero, none keeps the sign of a zero.)
    const double turns = std::abs(angle * quarters) < 0.5 ? -0.0 : std::nearbyint(angle * quarters);
    const double r = (angle - turns * quarterHigh) - turns * quarterLow;
    const double r2 = r * r;
    double s = 1, c = 1;
    for (const double factor : sineFactors) s = 1 - r2 * factor * s;
    for (const double factor : cosineFactors) c = 1 - r2 * factor * c;
    s *= r;
    if (turns == 0) return {c, s};
    switch (static_cast<int>(turns - 4 * std::floor(turns / 4))) {
        case 0:
            return {c, s};
        case 1:
            return {-s, c};
        case 2:
            return {-c, -s};
        default:
            return {s, -c};
    }
}

/// The angle of a vector that is not zero, -pi to pi, accurate to about 1e-15. A guess that is
/// wrong by at most 0.004 is mended by the series of what is left, whose first dropped term is
/// below 1e-17.
inline double angleOf(const Point& v) {
    const double x = std::abs(v[0]), y = std::abs(v[1]);
    const double most = std::max(x, y), least = std::min(x, y), slope = least / most;
    const double guess = slope * (fullTurn / 8 + 0.273 * (1 - slope));
    const Point u = unitVector(guess);
    const double left = (u[0] * least - u[1] * most) / (u[0] * most + u[1] * least);
    const double left2 = left * left;
    double angle = guess + left * (1 - left2 * (1.0 / 3 - left2 / 5));
    if (y > x) angle = fullTurn / 4 - angle;
    if (v[0] < 0) angle = fullTurn / 2 - angle;
    return v[1] < 0 ? -angle : angle;
}

/// `v`, turned by the angle whose (cos, sin) is `heading`, and turned back by it.
inline Point turned(const Point& heading, const Point& v) {
    return {heading[0] * v[0] - heading[1] * v[1], heading[1] * v[0] + heading[0] * v[1]};
}
inline Point turnedBack(const Point& heading, const Point& v) {
    return {heading[0] * v[0] + heading[1] * v[1], heading[0] * v[1] - heading[1] * v[0]};
}

}  // namespace sulfur::detail
