#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <atlax/image.hpp>

namespace atlax {

/// Animated PNG: puts frames of one size together. Browsers show the file as they show any picture.
/// Owns what it was given, compressed; one thread at a time.
class AnimatedPng {
public:
    /// `delay` of each frame in milliseconds, 1 to 65535.
    explicit AnimatedPng(int delay) : delay_(delay) {}
    /// Throws Error for a picture of another size than the first.
    void add(const Image& frame);
    int frames() const { return frames_; }
    /// The bytes of the file, with at least one frame.
    std::vector<std::byte> bytes() const;

private:
    int delay_;
    int frames_ = 0;
    std::uint32_t sequence_ = 0;
    PixelSize size_;
    std::vector<std::byte> header_;  ///< the chunk IHDR
    std::vector<std::byte> body_;    ///< what stands between acTL and IEND
};

}  // namespace atlax
