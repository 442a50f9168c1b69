#include <png.h>
#include <turbojpeg.h>

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/image.hpp>
#include <cstring>
#include <memory>
#include <optional>
#include <string>

namespace atlax {

namespace {

constexpr std::size_t mostImageBytes = 64u << 20;

[[noreturn]] void refuseImage(const std::string& name, const std::string& reason) {
    throw Error(name + ": " + reason);
}

unsigned byteAt(std::span<const std::byte> bytes, std::size_t i) {
    return std::to_integer<unsigned>(bytes[i]);
}

unsigned bigEndian(std::span<const std::byte> bytes, std::size_t at, std::size_t count) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + count; ++i) value = value << 8 | byteAt(bytes, i);
    return value;
}

struct Announced {
    unsigned width;
    unsigned height;
};

std::optional<Announced> pngSize(std::span<const std::byte> bytes) {
    static constexpr unsigned char signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    constexpr std::size_t headerEnd = 24;
    if (bytes.size() < headerEnd || std::memcmp(bytes.data(), signature, 8) != 0) return {};
    return Announced{bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
}

std::optional<Announced> jpegSize(std::span<const std::byte> bytes) {
    if (bytes.size() < 4 || byteAt(bytes, 0) != 0xFF || byteAt(bytes, 1) != 0xD8) return {};
    std::size_t at = 2;
    while (at + 9 < bytes.size() && byteAt(bytes, at) == 0xFF) {
        const unsigned marker = byteAt(bytes, at + 1);
        const bool tables = marker == 0xC4 || marker == 0xC8 || marker == 0xCC;
        if (marker >= 0xC0 && marker <= 0xCF && !tables)
            return Announced{bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2)};
        at += marker == 0xFF ? 1 : 2 + bigEndian(bytes, at + 2, 2);
    }
    return {};
}

bool accepted(unsigned width, unsigned height) {
    constexpr unsigned most = Image::maxSide;
    return width >= 1 && height >= 1 && width <= most && height <= most;
}

Image decodePng(std::span<const std::byte> bytes, const std::string& name) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    const auto problem = [&] { return std::string("cannot be decoded: ") + png.message; };
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0)
        refuseImage(name, problem());
    png.format = PNG_FORMAT_RGBA;
    Image image({static_cast<int>(png.width), static_cast<int>(png.height)});
    if (png_image_finish_read(&png, nullptr, image.bytes().data(), 0, nullptr) == 0)
        refuseImage(name, problem());
    return image;
}

/// What is cut off is refused, and so is a file that makes the decoder go over the picture hundreds
/// of times.
Image decodeJpeg(std::span<const std::byte> bytes, Announced size, const std::string& name) {
    const std::unique_ptr<void, decltype([](void* decoder) { tjDestroy(decoder); })> decoder(
        tjInitDecompress());
    if (decoder == nullptr) refuseImage(name, "cannot be decoded: out of memory");
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    const auto length = static_cast<unsigned long>(bytes.size());
    const auto problem = [&] {
        return std::string("cannot be decoded: ") + tjGetErrorStr2(decoder.get());
    };
    int width = 0, height = 0, sampling = 0, colors = 0;
    if (tjDecompressHeader3(decoder.get(), data, length, &width, &height, &sampling, &colors) != 0)
        refuseImage(name, problem());
    if (width != static_cast<int>(size.width) || height != static_cast<int>(size.height))
        refuseImage(name, "names two sizes");
    Image image({width, height});
    if (tjDecompress2(decoder.get(), data, length, image.bytes().data(), width, 0, height,
                      TJPF_RGBA, TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT) != 0)
        refuseImage(name, problem());
    return image;
}

}  // namespace

Image::Image(PixelSize size) : size_(size) {
    if (size.width < 1 || size.height < 1 || size.width > maxSide || size.height > maxSide)
        throw Error("a picture of " + std::to_string(size.width) + " x " +
                    std::to_string(size.height) + " pixels is outside of 1 to " +
                    std::to_string(maxSide));
    pixels_.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
                   4);
}

std::size_t Image::offset(int x, int y) const {
    if (x < 0 || y < 0 || x >= size_.width || y >= size_.height)
        throw Error("a pixel outside of the picture was asked for");
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
            static_cast<std::size_t>(x)) *
           4;
}

std::array<std::uint8_t, 4> Image::pixel(int x, int y) const {
    const std::size_t i = offset(x, y);
    return {pixels_[i], pixels_[i + 1], pixels_[i + 2], pixels_[i + 3]};
}

void Image::setPixel(int x, int y, std::array<std::uint8_t, 4> rgba) {
    std::copy(rgba.begin(), rgba.end(),
              pixels_.begin() + static_cast<std::ptrdiff_t>(offset(x, y)));
}

Image loadImage(const std::filesystem::path& file) {
    return decodeImage(readBytes(file, mostImageBytes), file.string());
}

Image decodeImage(std::span<const std::byte> bytes, const std::string& name) {
    if (bytes.size() > mostImageBytes) refuseImage(name, "is larger than 64 MiB");
    // The size is read first, so that a small file cannot make the decoder take all memory.
    const auto png = pngSize(bytes);
    const auto size = png ? png : jpegSize(bytes);
    if (!size) refuseImage(name, "is neither PNG nor JPEG, or is cut off");
    if (!accepted(size->width, size->height))
        refuseImage(name, "its sides must be 1 to " + std::to_string(Image::maxSide) + " pixels");
    return png ? decodePng(bytes, name) : decodeJpeg(bytes, *size, name);
}

std::vector<std::byte> encodePng(const Image& image) {
    if (image.empty()) throw Error("an empty picture cannot be written as PNG");
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width());
    png.height = static_cast<png_uint_32>(image.height());
    png.format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::vector<std::byte> bytes(size);
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.bytes().data(), 0, nullptr) ==
        0)
        throw Error(std::string("a picture cannot be encoded as PNG: ") + png.message);
    bytes.resize(size);
    return bytes;
}

void savePng(const Image& image, const std::filesystem::path& file) {
    writeFileAtomic(file, encodePng(image));
}

}  // namespace atlax
