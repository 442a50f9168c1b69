// Numbers that are the same everywhere.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sulfur::test {

/// xorshift64*
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits() {
        state_ ^= state_ >> 12;
        state_ ^= state_ << 25;
        state_ ^= state_ >> 27;
        return state_ * 0x2545f4914f6cdd1du;
    }
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) / 9007199254740992.0;
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }

private:
    std::uint64_t state_;
};

}  // namespace sulfur::test
