// What several tests need.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <sulfur/sulfur.hpp>

namespace sulfur::test {

inline void run(World& world, double seconds) {
    const auto ticks = std::lround(seconds * world.settings().tickRate);
    for (long i = 0; i < ticks; ++i) world.step();
}

/// Expects that `call` throws Error with `code` and leaves the world's state as it was.
template <class Function>
void expectRefused(World& world, ErrorCode code, Function&& call) {
    const auto before = world.hash();
    try {
        call();
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code)) << error.what();
        EXPECT_GT(std::string(error.what()).size(), 20u);
    }
    EXPECT_EQ(world.hash(), before);
    EXPECT_EQ(world.validate(), "");
}

/// Numbers that are the same everywhere (xorshift64*).
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
