// How targets mutate texts of JSON: as bytes, or value by value so that they mostly stay JSON.
#pragma once

#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>

#include "mutator.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

/// `sample` is what mutations begin with.
inline std::size_t mutateText(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                              unsigned seed, std::string_view sample) {
    std::minstd_rand random(seed);
    if (size >= 8 && random() % 4 == 0) return LLVMFuzzerMutate(data, size, maxSize);
    const bool anew = size < 8 || random() % 64 == 0;
    std::string text(anew ? sample : std::string_view(reinterpret_cast<const char*>(data), size));
    text = sulfur::scene::testing::Mutator(seed).mutate(text);
    if (text.size() > maxSize) text.resize(maxSize);
    std::memcpy(data, text.data(), text.size());
    return text.size();
}
