// Ranges of entries in arrays that never move: what is freed is handed out again by its length.
#pragma once

#include <cstdint>
#include <vector>

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
    }
    /// How long the arrays have to be.
    std::uint32_t size() const { return size_; }

    template <class Archive>
    void archive(Archive& a) {
        a(size_);
        std::uint64_t lengths = free_.size();
        a(lengths);
        free_.resize(lengths);
        for (auto& list : free_) a(list);
    }

private:
    std::uint32_t size_ = 0;
    std::vector<std::vector<std::uint32_t>> free_;  // by length
};

}  // namespace sulfur::detail
