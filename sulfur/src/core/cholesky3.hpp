// The factors of a symmetric positive definite 3 x 3 matrix.
#pragma once

#include <Eigen/Core>

namespace sulfur::detail {

/// A = L D L^T with ones on the diagonal of L, written out: for matrices of this size the general
/// solvers of Eigen spend most of their time on preparing blocks. Only the lower half of A is read.
class Cholesky3 {
public:
    using Vector = Eigen::Matrix<double, 3, 1>;
    using Matrix = Eigen::Matrix<double, 3, 3>;

    explicit Cholesky3(const Matrix& a) {
        inverse0_ = 1 / a(0, 0);
        l10_ = a(1, 0) * inverse0_;
        l20_ = a(2, 0) * inverse0_;
        const double d1 = a(1, 1) - l10_ * a(1, 0);
        inverse1_ = 1 / d1;
        const double below = a(2, 1) - l20_ * a(1, 0);
        l21_ = below * inverse1_;
        inverse2_ = 1 / (a(2, 2) - l20_ * a(2, 0) - l21_ * below);
    }

    Vector solve(const Vector& b) const {
        const double y1 = b[1] - l10_ * b[0];
        const double y2 = b[2] - l20_ * b[0] - l21_ * y1;
        const double x2 = y2 * inverse2_;
        const double x1 = y1 * inverse1_ - l21_ * x2;
        return {b[0] * inverse0_ - l10_ * x1 - l20_ * x2, x1, x2};
    }

    Matrix solve(const Matrix& b) const {
        Matrix x;
        for (int column = 0; column < 3; ++column) x.col(column) = solve(Vector(b.col(column)));
        return x;
    }

private:
    double l10_ = 0, l20_ = 0, l21_ = 0, inverse0_ = 0, inverse1_ = 0, inverse2_ = 0;
};

}  // namespace sulfur::detail
