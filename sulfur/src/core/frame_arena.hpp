// Memory for what lives no longer than a step.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <vector>

namespace sulfur::detail {

/// Hands out one piece after the other and takes all back at once. What does not fit is allocated
/// by itself; the next step has room for it, so that steps of one kind allocate nothing.
class FrameArena final : public std::pmr::memory_resource {
public:
    /// Whatever was handed out is void.
    void reset() {
        if (!beside_.empty()) {
            beside_.clear();
            // More, so that what grows slowly is not moved in every step.
            size_ = std::max(4 * wanted_, least);
            room_ = std::make_unique<std::byte[]>(size_);
        }
        used_ = wanted_ = 0;
    }
    std::size_t bytes() const { return size_; }

private:
    static constexpr std::size_t least = 1 << 14;  // bytes

    void* do_allocate(std::size_t bytes, std::size_t alignment) override {
        wanted_ += bytes + alignment;
        void* at = room_.get() + used_;
        std::size_t left = size_ - used_;
        if (std::align(alignment, bytes, at, left)) {
            used_ = size_ - left + bytes;
            return at;
        }
        beside_.push_back(std::make_unique<std::byte[]>(bytes + alignment));
        at = beside_.back().get();
        left = bytes + alignment;
        return std::align(alignment, bytes, at, left);
    }
    void do_deallocate(void*, std::size_t, std::size_t) override {}
    bool do_is_equal(const memory_resource& other) const noexcept override {
        return this == &other;
    }

    std::unique_ptr<std::byte[]> room_;
    std::size_t size_ = 0, used_ = 0;
    std::size_t wanted_ = 0;  // bytes that were asked for since the last reset
    std::vector<std::unique_ptr<std::byte[]>> beside_;
};

}  // namespace sulfur::detail
