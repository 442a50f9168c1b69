// Small repeatable random numbers for decoration.
#pragma once

#include <cstdint>

namespace quaoar {

/// xorshift32; the same seed gives the same scenery.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : state_(seed * 2654435761u + 0x9E3779B9u) {
        if (state_ == 0) state_ = 1;
        for (int i = 0; i < 4; ++i) next();
    }
    std::uint32_t next() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 17;
        state_ ^= state_ << 5;
        return state_;
    }
    /// 0 <= value < 1
    float unit() { return static_cast<float>(next() >> 8) * (1.0f / 16777216.0f); }
    float between(float low, float high) { return low + (high - low) * unit(); }

private:
    std::uint32_t state_;
};

}  // namespace quaoar
