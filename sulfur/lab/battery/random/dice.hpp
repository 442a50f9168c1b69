// Random numbers that are the same everywhere.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace sulfur::lab {

/// SplitMix64 and what is drawn from it. The standard library's distributions differ from one
/// library to the next.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {
        // Neighbouring seeds would draw from one stream, each a step behind the next.
        state_ = bits();
    }

    /// In [low, high).
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    }
    /// In [low, high), each decade as likely.
    double decades(double low, double high) {
        return low * std::exp(uniform(0, std::log(high / low)));
    }
    /// In [0, count).
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
    /// True with this probability.
    bool chance(double probability) { return uniform(0, 1) < probability; }
    /// Radians.
    double angle() { return uniform(-std::numbers::pi, std::numbers::pi); }

private:
    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

}  // namespace sulfur::lab
