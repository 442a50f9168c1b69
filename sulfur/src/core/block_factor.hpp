// A sparse symmetric factorisation by small blocks, for what is tied together in loops.
//
// A = L D L^T with blocks of N x N, column by column from the left (Davis, Direct Methods for
// Sparse Linear Systems, 2006, 4.8), without pivots: the matrix is positive definite. For a tree
// this is nearly the elimination from the leaves to the root.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/block_pattern.hpp"

namespace sulfur::detail {

template <int N>
class BlockFactor {
public:
    using Vector = Eigen::Matrix<double, N, 1>;
    using Block = Eigen::Matrix<double, N, N>;

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
                const Block scaled = lower_[earlier.entry] * pivot_[earlier.column];
                pivot_[j].noalias() -= scaled * lower_[earlier.entry].transpose();
                for (auto k = earlier.entry + 1; k < pattern.end(earlier.column); ++k)
                    lower_[place_[pattern.row(k)]].noalias() -= lower_[k] * scaled.transpose();
            });
            inverse_[j] = pivot_[j].inverse();
            for (auto k = pattern.begin(j); k < pattern.end(j); ++k)
                lower_[k] = lower_[k] * inverse_[j];
        }
    }

    /// In place; `x` stands in the order of columns.
    void solve(const BlockPattern& pattern, std::vector<Vector>& x) const {
        for (std::size_t j = 0; j < pattern.size(); ++j) {
            const Vector y = x[j];
            for (auto k = pattern.begin(j); k < pattern.end(j); ++k)
                x[pattern.row(k)].noalias() -= lower_[k] * y;
        }
        for (std::size_t j = pattern.size(); j-- > 0;) {
            Vector y = inverse_[j] * x[j];
            for (auto k = pattern.begin(j); k < pattern.end(j); ++k)
                y.noalias() -= lower_[k].transpose() * x[pattern.row(k)];
            x[j] = y;
        }
    }

    bool empty() const { return pivot_.empty(); }
    void clear() { pivot_.clear(); }
    std::size_t bytes() const {
        return (pivot_.size() + inverse_.size() + lower_.size()) * sizeof(Block) +
               place_.size() * sizeof(std::uint32_t);
    }

private:
    std::vector<Block> pivot_, inverse_;  // D and its inverse
    std::vector<Block> lower_;            // L below its diagonal of ones
    std::vector<std::uint32_t> place_;    // row: its entry in the present column
};

}  // namespace sulfur::detail
