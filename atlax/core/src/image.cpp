#include <SDL_image.h>

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
constexpr std::size_t mostSvgBytes = 4u << 20;

struct FreeSurface {
    void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
};
using Surface = std::unique_ptr<SDL_Surface, FreeSurface>;

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
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

Image fromSurface(Surface surface, const std::string& name) {
    if (surface == nullptr) refuse(name, std::string("cannot be decoded: ") + SDL_GetError());
    if (surface->w < 1 || surface->h < 1 || surface->w > Image::maxSide ||
        surface->h > Image::maxSide)
        refuse(name, "its sides must be 1 to " + std::to_string(Image::maxSide) + " pixels");
    if (surface->format->format != SDL_PIXELFORMAT_RGBA32) {
        surface.reset(SDL_ConvertSurfaceFormat(surface.get(), SDL_PIXELFORMAT_RGBA32, 0));
        if (surface == nullptr) refuse(name, std::string("cannot be converted: ") + SDL_GetError());
    }
    Image image({surface->w, surface->h});
    const auto stride = static_cast<std::size_t>(surface->w) * 4;
    const auto* pixels = static_cast<const std::uint8_t*>(surface->pixels);
    for (int y = 0; y < surface->h; ++y)
        std::copy_n(pixels + static_cast<std::ptrdiff_t>(y) * surface->pitch, stride,
                    image.bytes().data() + static_cast<std::size_t>(y) * stride);
    return image;
}

SDL_RWops* reader(std::span<const std::byte> bytes, const std::string& name) {
    auto* source = SDL_RWFromConstMem(bytes.data(), static_cast<int>(bytes.size()));
    if (source == nullptr) refuse(name, "is empty");
    return source;
}

/// A stream of SDL that writes into a vector; PNG is written from front to end.
struct VectorWriter {
    std::vector<std::byte> bytes;

    static std::size_t SDLCALL write(SDL_RWops* stream, const void* data, std::size_t size,
                                     std::size_t count) {
        auto* self = static_cast<VectorWriter*>(stream->hidden.unknown.data1);
        const auto* start = static_cast<const std::byte*>(data);
        self->bytes.insert(self->bytes.end(), start, start + size * count);
        return count;
    }
    static Sint64 SDLCALL seek(SDL_RWops* stream, Sint64, int) {
        auto* self = static_cast<VectorWriter*>(stream->hidden.unknown.data1);
        return static_cast<Sint64>(self->bytes.size());
    }
    static int SDLCALL close(SDL_RWops* stream) {
        SDL_FreeRW(stream);
        return 0;
    }
};

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
    if (bytes.size() > mostImageBytes) refuse(name, "is larger than 64 MiB");
    // The size is read first, so that a small file cannot make the decoder take all memory.
    const auto png = pngSize(bytes);
    const auto size = png ? png : jpegSize(bytes);
    if (!size) refuse(name, "is neither PNG nor JPEG, or is cut off");
    if (!accepted(size->width, size->height))
        refuse(name, "its sides must be 1 to " + std::to_string(Image::maxSide) + " pixels");
    auto* source = reader(bytes, name);
    Surface surface(png ? IMG_LoadPNG_RW(source) : IMG_LoadJPG_RW(source));
    SDL_RWclose(source);
    return fromSurface(std::move(surface), name);
}

Image loadSvg(const std::filesystem::path& file, PixelSize size) {
    return decodeSvg(readBytes(file, mostSvgBytes), size, file.string());
}

Image decodeSvg(std::span<const std::byte> bytes, PixelSize size, const std::string& name) {
    if (bytes.size() > mostSvgBytes) refuse(name, "is larger than 4 MiB");
    if (size.width < 1 || size.height < 1 || size.width > Image::maxSide ||
        size.height > Image::maxSide)
        refuse(name, "was asked for at a size outside of 1 to " + std::to_string(Image::maxSide));
    auto* source = reader(bytes, name);
    if (IMG_isSVG(source) == 0) {
        SDL_RWclose(source);
        refuse(name, "is not an SVG drawing");
    }
    Surface surface(IMG_LoadSizedSVG_RW(source, size.width, size.height));
    SDL_RWclose(source);
    return fromSurface(std::move(surface), name);
}

std::vector<std::byte> encodePng(const Image& image) {
    if (image.empty()) throw Error("an empty picture cannot be written as PNG");
    // SDL does not write through this pointer; it only has no const.
    auto* pixels = const_cast<std::uint8_t*>(image.bytes().data());  // NOLINT
    const Surface surface(SDL_CreateRGBSurfaceWithFormatFrom(
        pixels, image.width(), image.height(), 32, image.width() * 4, SDL_PIXELFORMAT_RGBA32));
    auto* stream = SDL_AllocRW();
    if (surface == nullptr || stream == nullptr) throw Error("out of memory while writing a PNG");
    VectorWriter writer;
    stream->type = SDL_RWOPS_UNKNOWN;
    stream->hidden.unknown.data1 = &writer;
    stream->size = nullptr;
    stream->read = nullptr;
    stream->seek = VectorWriter::seek;
    stream->write = VectorWriter::write;
    stream->close = VectorWriter::close;
    const int result = IMG_SavePNG_RW(surface.get(), stream, 1);
    if (result != 0 || writer.bytes.empty())
        throw Error(std::string("a picture cannot be encoded as PNG: ") + SDL_GetError());
    return std::move(writer.bytes);
}

void savePng(const Image& image, const std::filesystem::path& file) {
    writeFileAtomic(file, encodePng(image));
}

}  // namespace atlax
