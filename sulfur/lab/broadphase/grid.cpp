#include "broadphase/grid.hpp"

#include <algorithm>
#include <bit>

namespace sulfur::detail {

namespace {

CellBox boundsOf(const std::vector<Grid::Entry>& entries) {
    if (entries.empty()) return {};
    CellBox box{entries.front().cell, entries.front().cell};
    for (const auto& [cell, item] : entries) {
        box.low = {std::min(box.low.x, cell.x), std::min(box.low.y, cell.y)};
        box.high = {std::max(box.high.x, cell.x), std::max(box.high.y, cell.y)};
    }
    return box;
}

}  // namespace

void Grid::build() {
    if (sorted_.capacity() < entries_.size()) {
        // Room for five times as many more: what turns and speeds up covers more cells than at
        // first, with a skin that widens by a cell.
        const std::size_t room = 6 * entries_.size();
        entries_.reserve(room);
        sorted_.reserve(room);
        start_.reserve(std::bit_ceil(std::max<std::size_t>(2, room * 2)) + 1);
        latest_.reserve(start_.capacity());
    }
    const auto buckets = std::bit_ceil(std::max<std::size_t>(2, entries_.size() * 2));
    shift_ = 64 - std::countr_zero(buckets);
    start_.assign(buckets + 1, 0);
    for (const Entry& entry : entries_) ++start_[bucketOf(entry.cell) + 1];
    for (std::size_t i = 1; i <= buckets; ++i) start_[i] += start_[i - 1];
    sorted_.resize(entries_.size());
    // Filling from the back leaves start_ at the first entry of each bucket.
    for (std::size_t i = entries_.size(); i-- > 0;) {
        auto& end = start_[bucketOf(entries_[i].cell) + 1];
        sorted_[--end] = entries_[i];
    }
    // Now start_[b + 1] is the first entry of bucket b: shift by one.
    for (std::size_t i = 0; i < buckets; ++i) start_[i] = start_[i + 1];
    start_[buckets] = static_cast<std::uint32_t>(entries_.size());
    bounds_ = boundsOf(entries_);
    added_.clear();
    added_.reserve(entries_.capacity());
    latest_.assign(buckets, nothing);
}

void Grid::add(Cell cell, std::uint32_t item) {
    const Entry entry{cell, item};
    const auto bucket = bucketOf(cell);
    added_.push_back({entry, latest_[bucket]});
    latest_[bucket] = static_cast<std::uint32_t>(added_.size()) - 1;
    bounds_ = entries_.empty()
                  ? CellBox{cell, cell}
                  : CellBox{{std::min(bounds_.low.x, cell.x), std::min(bounds_.low.y, cell.y)},
                            {std::max(bounds_.high.x, cell.x), std::max(bounds_.high.y, cell.y)}};
    entries_.push_back(entry);
}

}  // namespace sulfur::detail
