// Closest points and crossings of segments.
#pragma once

#include <algorithm>
#include <sulfur/math.hpp>

namespace sulfur::detail {

/// Place along the segment from a to b (0..1) that is nearest to p; 0 for a segment of length 0.
/// All three relative to a common origin near them.
template <class Vector>
typename Vector::Scalar nearestAlong(const Vector& p, const Vector& a, const Vector& b) {
    using Scalar = typename Vector::Scalar;
    const Vector along = b - a;
    const Scalar length2 = along.squaredNorm();
    if (length2 == 0) return 0;
    return std::clamp<Scalar>((p - a).dot(along) / length2, 0, 1);
}

/// Whether the segments from a to b and from c to d cross in a point inside both.
template <class Vector>
bool segmentsCross(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
    const auto side = [](const Vector& from, const Vector& to, const Vector& p) {
        return cross(to - from, p - from);
    };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

}  // namespace sulfur::detail
