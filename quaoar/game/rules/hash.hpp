// FNV-1a over values, for state hashes. Private to the game's rules.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>
#include <sulfur/math.hpp>

namespace quaoar {

class Hash {
public:
    Hash& bytes(std::string_view text) {
        for (const char c : text) mix(static_cast<unsigned char>(c));
        return *this;
    }
    Hash& add(std::uint64_t value) {
        for (int shift = 0; shift < 64; shift += 8) {
            mix(static_cast<unsigned char>((value >> shift) & 0xffu));
        }
        return *this;
    }
    /// By its bits, widened to double so that the same number hashes alike in both builds.
    Hash& add(double value) { return add(std::bit_cast<std::uint64_t>(value)); }
    Hash& add(float value) { return add(static_cast<double>(value)); }
    /// A Vec2 or a Point, which are one type where Real is double.
    template <class Number>
    Hash& add(const Eigen::Matrix<Number, 2, 1, Eigen::DontAlign>& v) {
        return add(v.x()).add(v.y());
    }
    std::uint64_t value() const { return value_; }

private:
    void mix(unsigned char byte) {
        value_ ^= byte;
        value_ *= 0x100000001b3ull;
    }
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

}  // namespace quaoar
