// The uniform grid of the broad phase.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>
#include <utility>
#include <vector>

namespace sulfur::detail {

/// A cell by its numbers, of which the last 32 bits are kept: cells that are a multiple of 2^32
/// apart (33,000 km with the smallest) are one. That can only make candidates that are none,
/// and so the plane needs no bounds.
struct Cell {
    std::int32_t x = 0, y = 0;
    friend auto operator<=>(const Cell&, const Cell&) = default;
};

/// All cells from `low` to `high`, both included; none when they are the wrong way round.
struct CellBox {
    Cell low{0, 0}, high{-1, -1};

    bool empty() const { return low.x > high.x || low.y > high.y; }
};
inline Cell cellAt(std::int64_t x, std::int64_t y) {
    return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
}

/// An unbounded grid that stores only the cells that something covers. Cells are hashed into
/// buckets and the buckets filled by a counting sort, so building is linear and the order within
/// a bucket is the order of insertion.
class Grid {
public:
    struct Entry {
        Cell cell;
        std::uint32_t item = 0;
    };

    void clear() {
        entries_.clear();
        sorted_.clear();
        start_.clear();
        added_.clear();
        latest_.clear();
        bounds_ = {};
    }
    void insert(Cell cell, std::uint32_t item) { entries_.push_back({cell, item}); }
    /// Sorts what was inserted since clear() into buckets. Queries come after it.
    void build();
    /// Enters something more into what was built. It is found by forEachIn() and entries(), after
    /// what was built, the latest first; not by forEachPair().
    void add(Cell cell, std::uint32_t item);
    /// How many were added since build().
    std::size_t added() const { return added_.size(); }

    /// Calls f(item), which may change it, for every entry and each copy of it.
    template <class Function>
    void renumber(Function&& f) {
        for (Entry& entry : entries_) f(entry.item);
        for (Entry& entry : sorted_) f(entry.item);
        for (Added& one : added_) f(one.entry.item);
    }

    /// Calls f(item) for everything in a cell, in order of insertion, then for what was added.
    template <class Function>
    void forEachIn(Cell cell, Function&& f) const {
        if (start_.empty()) return;
        const std::uint32_t bucket = bucketOf(cell);
        for (std::uint32_t i = start_[bucket]; i < start_[bucket + 1]; ++i)
            if (sorted_[i].cell == cell) f(sorted_[i].item);
        if (added_.empty()) return;
        for (auto i = latest_[bucket]; i != nothing; i = added_[i].before)
            if (added_[i].entry.cell == cell) f(added_[i].entry.item);
    }

    /// Calls f(item) for everything in a cell that is greater than `item`, where items were
    /// inserted in ascending order, and nothing was added.
    template <class Function>
    void forEachAfter(Cell cell, std::uint32_t item, Function&& f) const {
        const std::uint32_t bucket = bucketOf(cell);
        for (auto i = start_[bucket + 1]; i-- > start_[bucket] && sorted_[i].item > item;)
            if (sorted_[i].cell == cell) f(sorted_[i].item);
    }

    /// Calls f(first, second) for every two entries of one cell; first was inserted before.
    template <class Function>
    void forEachPair(Function&& f) const {
        for (std::size_t bucket = 0; bucket + 1 < start_.size(); ++bucket)
            for (std::uint32_t i = start_[bucket]; i < start_[bucket + 1]; ++i)
                for (std::uint32_t j = i + 1; j < start_[bucket + 1]; ++j)
                    if (sorted_[i].cell == sorted_[j].cell) f(sorted_[i].item, sorted_[j].item);
    }

    const std::vector<Entry>& entries() const { return entries_; }
    /// Outside of it there is nothing.
    const CellBox& bounds() const { return bounds_; }

private:
    static constexpr std::uint32_t nothing = 0xffffffffu;

    /// One of what was added to a bucket, and the one before it.
    struct Added {
        Entry entry;
        std::uint32_t before = nothing;
    };

    std::uint32_t bucketOf(Cell cell) const {
        const std::uint64_t key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.x)) |
                                  static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.y))
                                      << 32;
        return static_cast<std::uint32_t>((key * 0x9e3779b97f4a7c15u) >> shift_);
    }

    std::vector<Entry> entries_;
    std::vector<Entry> sorted_;
    std::vector<std::uint32_t> start_;  // first entry of each bucket, and one past the last
    std::vector<Added> added_;
    std::vector<std::uint32_t> latest_;  // of added_, per bucket
    CellBox bounds_;
    int shift_ = 63;
};

}  // namespace sulfur::detail
