#include "integrators/implicit_matrix.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace sulfur::lab {

namespace {

Mat entry(const Jacobian::Block& block, double h) {
    return -h * block.velocity - h * h * block.position;
}

}  // namespace

void ImplicitMatrix::solve(const Jacobian& jacobian, double h, const Vecs& right, Vecs& out) {
    out = right;
    const bool chain =
        std::all_of(jacobian.blocks.begin(), jacobian.blocks.end(), [](const auto& block) {
            return block.row <= block.column + 1 && block.column <= block.row + 1;
        });
    if (chain)
        solveChain(jacobian, h, out);
    else
        solveSparse(jacobian, h, out);
}

void ImplicitMatrix::solveChain(const Jacobian& jacobian, double h, Vecs& out) {
    const auto count = out.size();
    before_.assign(count, Mat::Zero());
    self_.assign(count, Mat::Identity());
    behind_.assign(count, Mat::Zero());
    for (const auto& block : jacobian.blocks) {
        auto& place = block.column < block.row   ? before_
                      : block.column > block.row ? behind_
                                                 : self_;
        place[block.row] += entry(block, h);
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) {
            const Mat factor = before_[i] * self_[i - 1];  // which holds its inverse by now
            self_[i] -= factor * behind_[i - 1];
            out[i] -= factor * out[i - 1];
        }
        self_[i] = self_[i].inverse().eval();
    }
    for (std::size_t i = count; i-- > 0;) {
        if (i + 1 < count) out[i] -= behind_[i] * out[i + 1];
        out[i] = self_[i] * out[i];
    }
}

void ImplicitMatrix::solveSparse(const Jacobian& jacobian, double h, Vecs& out) {
    const auto size = static_cast<Eigen::Index>(2 * out.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < size; ++i) entries.emplace_back(i, i, 1);
    for (const auto& block : jacobian.blocks) {
        const Mat values = entry(block, h);
        for (int row = 0; row < 2; ++row)
            for (int column = 0; column < 2; ++column)
                entries.emplace_back(static_cast<Eigen::Index>(2 * block.row) + row,
                                     static_cast<Eigen::Index>(2 * block.column) + column,
                                     values(row, column));
    }
    matrix_.resize(size, size);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    lu_.compute(matrix_);
    if (lu_.info() != Eigen::Success) return;  // A matrix that is not finite gives no direction.
    Eigen::VectorXd right(size);
    for (std::size_t i = 0; i < out.size(); ++i)
        right.segment<2>(static_cast<Eigen::Index>(2 * i)) = out[i];
    const Eigen::VectorXd solution = lu_.solve(right);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = solution.segment<2>(static_cast<Eigen::Index>(2 * i));
}

}  // namespace sulfur::lab
