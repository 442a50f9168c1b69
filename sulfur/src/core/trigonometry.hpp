// Sine and cosine with the same bits on every machine.
//
// The C library's differ between versions and vendors; poses enter the simulation through these
// instead. Range reduction to [-pi/4, pi/4] in two steps (Cody and Waite) and the Taylor series,
// whose first dropped term is below 1e-17 there.
#pragma once

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
    const double turns = std::nearbyint(angle * quarters);
    const double r = (angle - turns * quarterHigh) - turns * quarterLow;
    const double r2 = r * r;
    double s = 1, c = 1;
    for (const double factor : sineFactors) s = 1 - r2 * factor * s;
    for (const double factor : cosineFactors) c = 1 - r2 * factor * c;
    s *= r;
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

}  // namespace sulfur::detail
