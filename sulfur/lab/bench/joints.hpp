// Joints between bodies that every engine with mechanisms has, as scenes describe them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <sulfur/math.hpp>

namespace sulfur::lab::bench {

/// Joins two bodies where they are; the value is 0 then.
struct JointPlan {
    enum class Kind : std::uint8_t {
        hinge,   ///< its value is the angle of b against a, rad
        slider,  ///< its value is the way of b along the axis, m; b keeps its angle
        wheel,   ///< its value is the same, but b turns, and the motor turns it
    };
    Kind kind = Kind::hinge;
    std::size_t a = 0, b = 0;                                          ///< bodies, by their numbers
    Point at{0, 0};                                                    ///< m
    Point axis{1, 0};                                                  ///< of length 1
    std::optional<double> lower = std::nullopt, upper = std::nullopt;  ///< rad or m
    double motorSpeed = 0;                                             ///< rad/s or m/s
    double motorMax = 0;                                               ///< N m or N; 0: no motor
    double hertz = 0;         ///< of the spring, with both bodies free; 0: none
    double dampingRatio = 0;  ///< of the spring
};

/// The mass or moment of inertia with which two bodies swing against each other, kg or kg m^2.
inline double reduced(double a, double b) {
    if (!(a > 0) || !(b > 0)) return a > 0 ? a : b;
    return a * b / (a + b);
}

}  // namespace sulfur::lab::bench
