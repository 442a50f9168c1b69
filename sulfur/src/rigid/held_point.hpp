// A weighted mean of places, as attachments and grabs hold it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "rigid/grip.hpp"

namespace sulfur::detail {

using Matrix2 = Eigen::Matrix<Real, 2, 2>;

/// Sum of weight_i times place_i. Places of one rigid component are one grip, so that the mean
/// moves as easily as the component really does there.
class HeldPoint {
public:
    void add(const Grip& grip, Real weight) {
        for (std::size_t k = 0; k < count_; ++k) {
            if (grip.cluster == none || grips_[k].cluster != grip.cluster) continue;
            const Real sum = weights_[k] + weight;
            if (std::abs(sum) < Real(1e-3)) continue;
            grips_[k].arm = (weights_[k] * grips_[k].arm + weight * grip.arm) / sum;
            weights_[k] = sum;
            return;
        }
        grips_[count_] = grip;
        weights_[count_++] = weight;
    }

    Vec2 displacement(const State& state) const {
        Vec2 sum(0, 0);
        for (std::size_t k = 0; k < count_; ++k)
            sum += weights_[k] * displacementOf(state, grips_[k]);
        return sum;
    }

    /// Displacement per impulse (1/kg).
    Matrix2 mobility(const State& state) const {
        Matrix2 sum = Matrix2::Zero();
        for (std::size_t k = 0; k < count_; ++k)
            sum += weights_[k] * weights_[k] * mobilityOf(state, grips_[k]);
        return sum;
    }

    void push(State& state, const Vec2& impulse) const {
        for (std::size_t k = 0; k < count_; ++k)
            detail::push(state, grips_[k], weights_[k] * impulse);
    }

private:
    std::array<Grip, 4> grips_;
    std::array<Real, 4> weights_{0, 0, 0, 0};
    std::size_t count_ = 0;
};

/// m^-1 v; where a direction is blocked, or so easy that Real does not hold it, as if both were as
/// easy as the easier one.
inline Vec2 solve2(const Matrix2& m, const Vec2& v) {
    const Real determinant = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
    const Real scale = m(0, 0) + m(1, 1);
    if (!(determinant > Real(1e-6) * scale * scale) || !std::isfinite(determinant))
        return scale > 0 ? Vec2(v / scale) : Vec2(0, 0);
    return Vec2(m(1, 1) * v[0] - m(0, 1) * v[1], m(0, 0) * v[1] - m(1, 0) * v[0]) / determinant;
}

}  // namespace sulfur::detail
