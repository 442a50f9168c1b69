// The bits of a word that are set, as a range.
#pragma once

#include <bit>
#include <cstdint>

namespace sulfur::detail {

/// The numbers of the bits that are set, from the lowest.
class SetBits {
public:
    explicit SetBits(std::uint64_t bits) : bits_(bits) {}

    class Iterator {
    public:
        explicit Iterator(std::uint64_t left) : left_(left) {}
        std::uint32_t operator*() const {
            return static_cast<std::uint32_t>(std::countr_zero(left_));
        }
        Iterator& operator++() {
            left_ &= left_ - 1;
            return *this;
        }
        bool operator==(const Iterator&) const = default;

    private:
        std::uint64_t left_;
    };

    std::uint64_t bits() const { return bits_; }
    Iterator begin() const { return Iterator(bits_); }
    Iterator end() const { return Iterator(0); }

private:
    std::uint64_t bits_;
};

}  // namespace sulfur::detail
