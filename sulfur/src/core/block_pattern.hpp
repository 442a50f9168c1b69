// Where a sparse symmetric factorisation has entries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sulfur::detail {

/// The entries of L in A = L D L^T, for a symmetric matrix with a row and a column for each node
/// and an entry for each edge; columns stand in an order that fills in little (approximate minimum
/// degree: Amestoy, Davis and Duff 1996). It depends on the edges alone.
class BlockPattern {
public:
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    /// `edges`: pairs of different nodes, each below `nodes`.
    void analyse(std::uint32_t nodes, std::vector<Edge> edges);
    /// Whether it is the pattern of these.
    bool isOf(std::uint32_t nodes, const std::vector<Edge>& edges) const {
        return nodes == size() && edges == edges_;
    }

    std::size_t size() const { return column_.size(); }
    std::size_t entries() const { return row_.size(); }
    /// Products of two entries that a factorisation takes.
    std::uint64_t products() const { return products_; }

    std::uint32_t columnOf(std::uint32_t node) const { return column_[node]; }
    /// Of two nodes with an entry, which those with an edge have. The entry stands in the column of
    /// the one that comes first.
    std::size_t entryOf(std::uint32_t a, std::uint32_t b) const;

    std::uint32_t begin(std::size_t column) const { return start_[column]; }
    std::uint32_t end(std::size_t column) const { return start_[column + 1]; }
    std::uint32_t row(std::size_t entry) const { return row_[entry]; }

    /// An entry of an earlier column that stands in a row.
    struct InRow {
        std::uint32_t column, entry;
    };
    /// Calls f(InRow) for the entries of a row, from the first column on.
    template <class Function>
    void forEachInRow(std::size_t row, Function&& f) const {
        for (auto k = rowStart_[row]; k < rowStart_[row + 1]; ++k) f(inRow_[k]);
    }

    std::size_t bytes() const;

private:
    void order(std::uint32_t nodes);
    void fillIn();
    void listRows();

    std::vector<Edge> edges_;
    std::vector<std::uint32_t> column_;    // of each node
    std::vector<std::uint32_t> start_{0};  // first entry of each column
    std::vector<std::uint32_t> row_;       // of each entry, in order within a column
    std::vector<std::uint32_t> rowStart_{0};
    std::vector<InRow> inRow_;
    std::uint64_t products_ = 0;
};

}  // namespace sulfur::detail
