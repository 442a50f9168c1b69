#include "core/block_pattern.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <utility>

namespace sulfur::detail {

void BlockPattern::analyse(std::uint32_t nodes, std::vector<Edge> edges) {
    edges_ = std::move(edges);
    order(nodes);
    fillIn();
    listRows();
}

std::size_t BlockPattern::entryOf(std::uint32_t a, std::uint32_t b) const {
    const auto first = std::min(column_[a], column_[b]), last = std::max(column_[a], column_[b]);
    const auto from = row_.begin() + start_[first], to = row_.begin() + start_[first + 1];
    return static_cast<std::size_t>(std::lower_bound(from, to, last) - row_.begin());
}

std::size_t BlockPattern::bytes() const {
    return (column_.size() + start_.size() + row_.size() + rowStart_.size()) *
               sizeof(std::uint32_t) +
           inRow_.size() * sizeof(InRow) + edges_.size() * sizeof(Edge);
}

void BlockPattern::order(std::uint32_t nodes) {
    std::vector<Eigen::Triplet<double>> places;
    places.reserve(nodes + 2 * edges_.size());
    for (std::uint32_t i = 0; i < nodes; ++i) places.emplace_back(i, i, 1.0);
    for (const auto& [a, b] : edges_) {
        places.emplace_back(a, b, 1.0);
        places.emplace_back(b, a, 1.0);
    }
    Eigen::SparseMatrix<double> matrix(nodes, nodes);
    matrix.setFromTriplets(places.begin(), places.end());
    Eigen::AMDOrdering<int>::PermutationType permutation;
    Eigen::AMDOrdering<int>()(matrix, permutation);
    column_.resize(nodes);
    for (std::uint32_t k = 0; k < nodes; ++k)
        column_[static_cast<std::size_t>(permutation.indices()[k])] = k;
}

/// A column has the rows of its own edges and those of the columns whose first row it is (its
/// children in the elimination tree; Davis, Direct Methods for Sparse Linear Systems, 2006, 4.1).
void BlockPattern::fillIn() {
    const std::size_t count = size();
    std::vector<std::vector<std::uint32_t>> rows(count), children(count);
    for (const auto& [a, b] : edges_)
        rows[std::min(column_[a], column_[b])].push_back(std::max(column_[a], column_[b]));
    start_.assign(1, 0);
    row_.clear();
    products_ = 0;
    for (std::size_t j = 0; j < count; ++j) {
        auto& own = rows[j];
        for (const auto child : children[j])
            own.insert(own.end(), rows[child].begin() + 1, rows[child].end());
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        if (!own.empty()) children[own.front()].push_back(static_cast<std::uint32_t>(j));
        row_.insert(row_.end(), own.begin(), own.end());
        start_.push_back(static_cast<std::uint32_t>(row_.size()));
        products_ += own.size() * (own.size() + 1) / 2;
    }
}

void BlockPattern::listRows() {
    rowStart_.assign(size() + 1, 0);
    for (const auto r : row_) ++rowStart_[r + 1];
    for (std::size_t r = 0; r < size(); ++r) rowStart_[r + 1] += rowStart_[r];
    inRow_.resize(row_.size());
    auto next = rowStart_;
    for (std::uint32_t j = 0; j < size(); ++j)
        for (auto k = start_[j]; k < start_[j + 1]; ++k) inRow_[next[row_[k]]++] = {j, k};
}

}  // namespace sulfur::detail
