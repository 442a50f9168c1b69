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

/// (cos angle, sin angle); `angle` finite, accurate to about 1e-15 for |angle| < 1e6.
inline Point unitVector(double angle) {
    constexpr double quarter = fullTurn / 4;
    constexpr double quarterHigh = 1.5707963267341256;    // the first 33 bits of pi/2
    constexpr double quarterLow = 6.077100506506192e-11;  // the rest
    const double turns = std::nearbyint(angle / quarter);
    const double r = (angle - turns * quarterHigh) - turns * quarterLow;
    const double r2 = r * r;
    const double s =
        r *
        (1 -
         r2 / 6 *
             (1 - r2 / 20 *
                      (1 - r2 / 42 *
                               (1 - r2 / 72 * (1 - r2 / 110 * (1 - r2 / 156 * (1 - r2 / 210)))))));
    const double c =
        1 -
        r2 / 2 *
            (1 -
             r2 / 12 *
                 (1 -
                  r2 / 30 *
                      (1 - r2 / 56 *
                               (1 - r2 / 90 * (1 - r2 / 132 * (1 - r2 / 182 * (1 - r2 / 240)))))));
    switch (static_cast<int>(std::fmod(turns, 4.0) + 4) % 4) {
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
