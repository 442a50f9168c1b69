#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include <atlax/vec.hpp>

namespace atlax {

/// A picture in memory: 8 bits a channel, red green blue alpha, straight alpha, rows
/// from the top. A plain value that owns its pixels; needs no window and no OpenGL. Any
/// thread, each picture by one at a time; the functions that read and write files of pictures by
/// one thread at a time.
class Image {
public:
    /// Largest width and height that are accepted anywhere.
    static constexpr int maxSide = 8192;

    Image() = default;
    /// A picture of transparent black. Throws Error when a side is not in 1..maxSide.
    explicit Image(PixelSize size);

    PixelSize size() const { return size_; }
    int width() const { return size_.width; }
    int height() const { return size_.height; }
    bool empty() const { return pixels_.empty(); }

    /// All bytes, row after row without padding.
    std::span<std::uint8_t> bytes() { return pixels_; }
    std::span<const std::uint8_t> bytes() const { return pixels_; }

    /// One pixel, x to the right and y down; both must lie inside.
    std::array<std::uint8_t, 4> pixel(int x, int y) const;
    void setPixel(int x, int y, std::array<std::uint8_t, 4> rgba);

private:
    std::size_t offset(int x, int y) const;

    PixelSize size_;
    std::vector<std::uint8_t> pixels_;
};

/// Reads PNG or JPEG (told apart by content), at most 64 MiB and maxSide pixels a side.
/// Throws Error with the file's name and the reason; nothing is half-loaded.
Image loadImage(const std::filesystem::path& file);

/// The same from bytes in memory; `name` appears in messages.
Image decodeImage(std::span<const std::byte> bytes, const std::string& name);

/// Rasterises an SVG drawing so that it fits into `size` pixels with its aspect ratio kept
/// (the picture may be narrower or lower). At most 4 MiB of text, compressed or not; other files
/// that it refers to are not looked at. Throws Error.
Image loadSvg(const std::filesystem::path& file, PixelSize size);
Image decodeSvg(std::span<const std::byte> bytes, PixelSize size, const std::string& name);

/// The picture as the bytes of a PNG file. Throws Error for an empty picture.
std::vector<std::byte> encodePng(const Image& image);

/// Writes a PNG to a new file beside the target and renames it: there is never a half-written
/// picture. Throws Error.
void savePng(const Image& image, const std::filesystem::path& file);

}  // namespace atlax
