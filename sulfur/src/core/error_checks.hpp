// The checks that guard the public boundary.
#pragma once

#include <cmath>
#include <string>
#include <sulfur/error.hpp>
#include <sulfur/material.hpp>
#include <sulfur/math.hpp>

namespace sulfur::detail {

/// Throws Error{notFinite} unless every component of `value` is finite.
void requireFinite(double value, const char* what);
template <class Derived>
void requireFinite(const Eigen::MatrixBase<Derived>& value, const char* what) {
    for (Eigen::Index i = 0; i < value.size(); ++i)
        requireFinite(static_cast<double>(value[i]), what);
}

/// Throws unless `value` is finite and in [low, high].
void requireRange(double value, double low, double high, const char* what);
/// Throws unless `value` is finite and above 0.
void requirePositive(double value, const char* what);
/// Throws unless `value` is in [0, infinity], infinity included.
void requireNonNegativeOrInfinite(double value, const char* what);

/// Throws unless friction and restitution are in their documented ranges.
void validate(const Material& material);

}  // namespace sulfur::detail
