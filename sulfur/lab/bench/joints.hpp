// Joints between bodies that every engine with mechanisms has, as scenes describe them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <sulfur/math.hpp>

namespace sulfur::lab::bench {

/// Joins two bodies where they are; the value is 0 then, but that of a distance.
struct JointPlan {
    enum class Kind : std::uint8_t {
        hinge,     ///< its value is the angle of b against a, rad
        slider,    ///< its value is the way of b along the axis, m; b keeps its angle
        wheel,     ///< its value is the same, but b turns, and the motor turns it
        distance,  ///< its value is the distance of `at` on a and `atB` on b, m
    };
    Kind kind = Kind::hinge;
    std::size_t a = 0, b = 0;                                          ///< bodies, by their numbers
    Point at{0, 0};                                                    ///< m
    Point atB{0, 0};                                                   ///< m, of a distance
    Point axis{1, 0};                                                  ///< of length 1
    std::optional<double> lower = std::nullopt, upper = std::nullopt;  ///< rad or m
    double motorSpeed = 0;                                             ///< rad/s or m/s
    double motorMax = 0;                                               ///< N m or N; 0: no motor
    double hertz = 0;         ///< of the spring, with both bodies free; 0: none
    double dampingRatio = 0;  ///< of the spring
    double rest = 0;          ///< rad or m, of the spring of a hinge or slider
    /// For Box2D, whose joints are soft: how it holds both bodies in its own scene. 0 Hz: by
    /// default.
    double heldHertz = 0, heldDampingRatio = 0;
};

/// The mass or moment of inertia with which two bodies swing against each other, kg or kg m^2.
inline double reduced(double a, double b) {
    if (!(a > 0) || !(b > 0)) return a > 0 ? a : b;
    return a * b / (a + b);
}

}  // namespace sulfur::lab::bench
