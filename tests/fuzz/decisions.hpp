// How targets mutate bytes that are decisions: all bytes mean something, but few decide little, and
// libFuzzer begins with none.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

/// What is shorter than `usual` is lengthened now and then, by chance up to that.
inline std::size_t mutateDecisions(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                   unsigned seed, std::size_t usual) {
    std::minstd_rand random(seed);
    if (size >= usual || random() % 4 != 0) return LLVMFuzzerMutate(data, size, maxSize);
    const std::size_t longer = std::min(maxSize, size + 1 + random() % (usual - size));
    for (; size < longer; ++size) data[size] = static_cast<std::uint8_t>(random() >> 16);
    return size;
}
