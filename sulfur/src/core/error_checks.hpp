// The checks that guard the public boundary.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <sulfur/error.hpp>
#include <sulfur/material.hpp>
#include <sulfur/math.hpp>

namespace sulfur::detail {

/// What a message is about: a property, perhaps of one of many items. Its words are put together
/// only where there is a message.
struct Subject {
    Subject(const char* what) : property(what) {}
    Subject(const char* items, std::size_t i, const char* what)
        : kind(items), index(i), property(what) {}
    std::string text() const;

    const char* kind = nullptr;  // of the item, or null
    std::size_t index = 0;
    const char* property;
};

/// Throws Error{notFinite} unless every component of `value` is finite.
void requireFinite(double value, const Subject& what);
template <class Derived>
void requireFinite(const Eigen::MatrixBase<Derived>& value, const Subject& what) {
    for (Eigen::Index i = 0; i < value.size(); ++i)
        requireFinite(static_cast<double>(value[i]), what);
}

/// Throws unless `value` is finite and in [low, high].
void requireRange(double value, double low, double high, const Subject& what);
/// Throws unless every component is finite and at most `most` either way.
template <class Derived>
void requireWithin(const Eigen::MatrixBase<Derived>& value, double most, const Subject& what) {
    for (Eigen::Index i = 0; i < value.size(); ++i)
        requireRange(static_cast<double>(value[i]), -most, most, what);
}
/// Throws unless `value` is finite and above 0.
void requirePositive(double value, const Subject& what);
/// Throws unless `value` is in [0, infinity], infinity included.
void requireNonNegativeOrInfinite(double value, const Subject& what);

/// Throws unless both masses (kg) are so near to each other that the arithmetic carries both.
void requireMassRatio(double one, double other, const Subject& what);

/// Throws unless friction and restitution are in their documented ranges.
void validate(const Material& material);

}  // namespace sulfur::detail
