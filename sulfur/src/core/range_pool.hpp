// Ranges of entries in arrays that never move: what is freed is handed out again by its length.
#pragma once

#include <cstdint>
#include <vector>

#include "core/room.hpp"

namespace sulfur::detail {

/// Hands out [first, first + count) of arrays that grow at their end. Freed ranges of the same
/// length are reused, last in, first out.
class RangePool {
public:
    std::uint32_t allocate(std::uint32_t count) {
        if (count < free_.size() && !free_[count].empty()) {
            const auto first = free_[count].back();
            free_[count].pop_back();
            return first;
        }
        const auto first = size_;
        size_ += count;
        return first;
    }
    void release(std::uint32_t first, std::uint32_t count) {
        if (count == 0) return;
        if (free_.size() <= count) free_.resize(count + 1);
        free_[count].push_back(first);
        lengths_ = std::max<std::uint64_t>(lengths_, count + 1);
    }
    /// So many ranges of one length can be released without taking memory.
    void makeRoomToRelease(std::uint32_t count, std::size_t ranges) {
        if (count == 0) return;
        if (free_.size() <= count) free_.resize(count + 1);
        makeRoom(free_[count], ranges);
    }
    /// How long the arrays have to be.
    std::uint32_t size() const { return size_; }

    template <class Archive>
    void archive(Archive& a) {
        a(size_);
        a(lengths_);
        // One by one, so that a reader that finds too few bytes ends.
        for (std::uint64_t i = 0; i < lengths_; ++i) {
            if (i == free_.size()) free_.emplace_back();
            a(free_[i]);
        }
    }

private:
    std::uint32_t size_ = 0;
    std::vector<std::vector<std::uint32_t>> free_;  // by length
    std::uint64_t lengths_ = 0;                     // that have been released are less than that
};

}  // namespace sulfur::detail
