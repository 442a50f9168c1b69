#include <algorithm>
#include <array>
#include <atlax/animated_png.hpp>
#include <atlax/error.hpp>
#include <span>
#include <string_view>

namespace atlax {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::array<std::uint8_t, 8> apngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

void putNumber(Bytes& out, std::uint32_t value, int count = 4) {
    for (int i = count - 1; i >= 0; --i) out.push_back(static_cast<std::byte>(value >> (8 * i)));
}

/// CRC-32 of ISO 3309, as PNG wants it.
std::uint32_t checksum(std::span<const std::byte> bytes) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const std::byte byte : bytes) {
        crc ^= std::to_integer<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xEDB88320u : 0);
    }
    return crc ^ 0xFFFFFFFFu;
}

void putChunk(Bytes& out, std::string_view kind, std::span<const std::byte> data) {
    putNumber(out, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = out.size();
    for (const char c : kind) out.push_back(static_cast<std::byte>(c));
    out.insert(out.end(), data.begin(), data.end());
    putNumber(out, checksum(std::span(out).subspan(start)));
}

/// The data of all chunks of a kind in a PNG file, one after the other.
Bytes chunksOf(std::span<const std::byte> file, std::string_view kind) {
    Bytes out;
    std::size_t at = apngSignature.size();
    while (at + 12 <= file.size()) {
        std::size_t length = 0;
        for (int i = 0; i < 4; ++i)
            length =
                length << 8 | std::to_integer<std::size_t>(file[at + static_cast<std::size_t>(i)]);
        const auto name = file.subspan(at + 4, 4);
        const bool same =
            std::equal(kind.begin(), kind.end(), name.begin(),
                       [](char a, std::byte b) { return static_cast<std::byte>(a) == b; });
        const auto data = file.subspan(at + 8, length);
        if (same) out.insert(out.end(), data.begin(), data.end());
        at += 12 + length;
    }
    return out;
}

}  // namespace

void AnimatedPng::add(const Image& frame) {
    if (frames_ > 0 && !(frame.size() == size_))
        throw Error("the frames of an animated picture must have one size");
    size_ = frame.size();
    const Bytes png = encodePng(frame);
    if (frames_ == 0) putChunk(header_, "IHDR", chunksOf(png, "IHDR"));
    Bytes control;
    putNumber(control, sequence_++);
    putNumber(control, static_cast<std::uint32_t>(size_.width));
    putNumber(control, static_cast<std::uint32_t>(size_.height));
    putNumber(control, 0);
    putNumber(control, 0);
    putNumber(control, static_cast<std::uint32_t>(delay_), 2);
    putNumber(control, 1000, 2);
    putNumber(control, 0, 2);  // replaces what was there before
    putChunk(body_, "fcTL", control);
    const Bytes pixels = chunksOf(png, "IDAT");
    if (frames_++ == 0) return putChunk(body_, "IDAT", pixels);
    Bytes numbered;
    putNumber(numbered, sequence_++);
    numbered.insert(numbered.end(), pixels.begin(), pixels.end());
    putChunk(body_, "fdAT", numbered);
}

Bytes AnimatedPng::bytes() const {
    Bytes out;
    for (const std::uint8_t byte : apngSignature) out.push_back(static_cast<std::byte>(byte));
    out.insert(out.end(), header_.begin(), header_.end());
    Bytes animation;
    putNumber(animation, static_cast<std::uint32_t>(frames_));
    putNumber(animation, 0);  // for ever
    putChunk(out, "acTL", animation);
    out.insert(out.end(), body_.begin(), body_.end());
    putChunk(out, "IEND", {});
    return out;
}

}  // namespace atlax
