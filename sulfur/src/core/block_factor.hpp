// A sparse symmetric factorisation by small blocks, for what is tied together in loops.
//
// A = L D L^T with ones on the diagonal of L, column by column from the left (Davis, Direct Methods
// for Sparse Linear Systems, 2006, 4.8), without pivots: the matrix is positive definite. Only the
// pattern is one of blocks. Nothing is inverted, because stiff rows beside small masses would lose
// the square of their ratio. For a tree this is nearly the elimination from the leaves to the root.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/block_pattern.hpp"

namespace sulfur::detail {

template <int N>
class BlockFactor {
public:
    using Vector = Eigen::Matrix<double, N, 1>;
    using Block = Eigen::Matrix<double, N, N>;
    /// As many right sides as are solved side by side.
    static constexpr int lanes = 8;
    using Lanes = Eigen::Matrix<double, N, lanes, Eigen::RowMajor>;

    /// Begins a matrix of zeros.
    void begin(const BlockPattern& pattern) {
        pivot_.assign(pattern.size(), Block::Zero());
        inverse_.resize(pattern.size());
        lower_.assign(pattern.entries(), Block::Zero());
        place_.resize(pattern.size());
    }
    void add(const BlockPattern& pattern, std::uint32_t node, const Block& block) {
        pivot_[pattern.columnOf(node)] += block;
    }
    /// `block`: rows of node a, columns of node b; its transpose is added as well.
    void add(const BlockPattern& pattern, std::uint32_t a, std::uint32_t b, const Block& block) {
        Block& entry = lower_[pattern.entryOf(a, b)];
        if (pattern.columnOf(a) > pattern.columnOf(b))
            entry += block;
        else
            entry += block.transpose();
    }

    void factorise(const BlockPattern& pattern) {
        for (std::size_t j = 0; j < pattern.size(); ++j) {
            for (auto k = pattern.begin(j); k < pattern.end(j); ++k) place_[pattern.row(k)] = k;
            pattern.forEachInRow(j, [&](const BlockPattern::InRow& earlier) {
                const Block& entry = lower_[earlier.entry];
                const Block scaled = entry * pivot_[earlier.column].diagonal().asDiagonal();
                pivot_[j].noalias() -= scaled * entry.transpose();
                for (auto k = earlier.entry + 1; k < pattern.end(earlier.column); ++k)
                    subtractProduct(lower_[place_[pattern.row(k)]], lower_[k], scaled);
            });
            factoriseBlock(pivot_[j], inverse_[j]);
            for (auto k = pattern.begin(j); k < pattern.end(j); ++k) {
                Block& entry = lower_[k];
                for (int c = 0; c < N; ++c)
                    for (int b = 0; b < c; ++b) entry.col(c) -= pivot_[j](c, b) * entry.col(b);
                entry = entry * inverse_[j].asDiagonal();
            }
        }
    }

    /// In place; `x`, of Vector or Lanes, stands in the order of columns.
    template <class Right>
    void solve(const BlockPattern& pattern, std::span<Right> x) const {
        for (std::size_t j = 0; j < pattern.size(); ++j) {
            for (int r = 1; r < N; ++r)
                for (int c = 0; c < r; ++c) x[j].row(r) -= pivot_[j](r, c) * x[j].row(c);
            const Right y = x[j];
            for (auto k = pattern.begin(j); k < pattern.end(j); ++k)
                x[pattern.row(k)].noalias() -= lower_[k] * y;
        }
        for (std::size_t j = pattern.size(); j-- > 0;) {
            Right y = inverse_[j].asDiagonal() * x[j];
            for (auto k = pattern.begin(j); k < pattern.end(j); ++k)
                y.noalias() -= lower_[k].transpose() * x[pattern.row(k)];
            for (int r = N - 1; r > 0; --r)
                for (int c = 0; c < r; ++c) y.row(c) -= pivot_[j](r, c) * y.row(r);
            x[j] = y;
        }
    }

    bool empty() const { return pivot_.empty(); }
    std::size_t bytes() const {
        return (pivot_.size() + lower_.size()) * sizeof(Block) + inverse_.size() * sizeof(Vector) +
               place_.size() * sizeof(std::uint32_t);
    }

private:
    /// to -= a b^T. Nearly all of the time goes here; a block of two fills one register, or two.
    static void subtractProduct(Block& to, const Block& a, const Block& b) {
        if constexpr (N == 2) {
            using Four = Eigen::Array4d;
            const Four first(a(0, 0), a(1, 0), a(0, 0), a(1, 0));
            const Four second(a(0, 1), a(1, 1), a(0, 1), a(1, 1));
            Eigen::Map<Four> sum(to.data());
            sum -= first * Four(b(0, 0), b(0, 0), b(1, 0), b(1, 0)) +
                   second * Four(b(0, 1), b(0, 1), b(1, 1), b(1, 1));
        } else {
            to.noalias() -= a * b.transpose();
        }
    }
    /// Leaves D in the diagonal of the block and L below it.
    static void factoriseBlock(Block& block, Vector& inverse) {
        for (int j = 0; j < N; ++j) {
            inverse[j] = 1 / block(j, j);
            for (int r = j + 1; r < N; ++r)
                for (int c = j + 1; c <= r; ++c)
                    block(r, c) -= block(r, j) * inverse[j] * block(c, j);
            for (int r = j + 1; r < N; ++r) block(r, j) *= inverse[j];
        }
    }

    std::vector<Block> pivot_;          // on the diagonal of blocks
    std::vector<Vector> inverse_;       // of D
    std::vector<Block> lower_;          // L below them
    std::vector<std::uint32_t> place_;  // row: its entry in the present column
};

}  // namespace sulfur::detail
