// Where a caller takes its decisions from: a seed, or the bytes that a fuzzer makes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "random_numbers.hpp"

namespace sulfur::test {

class Numbers {
public:
    virtual ~Numbers() = default;
    /// 0 up to `count` - 1.
    virtual std::size_t below(std::size_t count) = 0;
    virtual double uniform(double low, double high) = 0;
    virtual std::uint64_t bits() = 0;
    /// Whether there are no more, so that all to come are 0.
    virtual bool done() const = 0;
    /// Goes on with the same numbers by itself.
    virtual std::unique_ptr<Numbers> clone() const = 0;
};

/// Without an end.
class SeededNumbers final : public Numbers {
public:
    explicit SeededNumbers(std::uint64_t seed) : random_(seed) {}
    std::size_t below(std::size_t count) override { return random_.below(count); }
    double uniform(double low, double high) override { return random_.uniform(low, high); }
    std::uint64_t bits() override { return random_.bits(); }
    bool done() const override { return false; }
    std::unique_ptr<Numbers> clone() const override {
        return std::make_unique<SeededNumbers>(*this);
    }

private:
    Random random_;
};

/// As few bytes for each number as will do, so that changing one byte changes one decision. The
/// bytes must outlive it.
class ByteNumbers final : public Numbers {
public:
    explicit ByteNumbers(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
    std::size_t below(std::size_t count) override {
        return count < 2 ? 0 : take(count <= 256 ? 1 : 4) % count;
    }
    double uniform(double low, double high) override {
        return low + (high - low) * static_cast<double>(take(2)) / 65536.0;
    }
    std::uint64_t bits() override { return take(8); }
    bool done() const override { return at_ == bytes_.size(); }
    std::unique_ptr<Numbers> clone() const override { return std::make_unique<ByteNumbers>(*this); }

private:
    std::uint64_t take(int count) {
        std::uint64_t value = 0;
        for (int i = 0; i < count; ++i)
            value = value << 8 | (at_ < bytes_.size() ? bytes_[at_++] : 0u);
        return value;
    }

    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

}  // namespace sulfur::test
