/// \file
/// Numbers and vectors of the public interface.
///
/// Units are SI everywhere: metres, kilograms, seconds, newtons; y points up; angles are radians,
/// counter-clockwise.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <sulfur/version.hpp>

namespace sulfur {

/// The number that velocities, forces, masses and material constants are made of: `float`, or
/// `double` when the library was built with SULFUR_REAL_DOUBLE.
#ifdef SULFUR_REAL_DOUBLE
using Real = double;
#else
using Real = float;
#endif

/// A difference: displacement, velocity, force, direction, or a place in a body's own frame.
/// Unaligned, so that it can live in any struct of yours.
using Vec2 = Eigen::Matrix<Real, 2, 1, Eigen::DontAlign>;

/// A place in the world, in metres. Always double: in single precision a body 1 km from the origin
/// cannot move at 1 cm/s at 500 Hz, because its step is smaller than half the spacing of floats.
using Point = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;

/// Stiffness of a rigid joint, strength of an unbreakable one.
inline constexpr Real infinite = std::numeric_limits<Real>::infinity();

/// Where and how a body is placed: its own frame is turned by `angle`, then moved to `position`.
struct Pose {
    Point position{0, 0};  ///< metres
    double angle = 0;      ///< radians, counter-clockwise
};

/// An upright rectangle.
struct Bounds {
    Point low{0, 0};   ///< metres, lower left corner
    Point high{0, 0};  ///< metres, upper right corner
};

/// The z component of the cross product.
template <class A, class B>
auto cross(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
    return a[0] * b[1] - a[1] * b[0];
}

}  // namespace sulfur
