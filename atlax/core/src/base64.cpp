#include <algorithm>
#include <atlax/base64.hpp>
#include <cstdint>

namespace atlax {
namespace {

constexpr std::string_view base64Digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string toBase64(std::span<const std::byte> bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k <= count; ++k) text += base64Digits[group >> (18 - 6 * k) & 63];
    }
    return text;
}

std::vector<std::byte> fromBase64(std::string_view text) {
    std::vector<std::byte> bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        const std::size_t digit = base64Digits.find(c);
        if (digit == std::string_view::npos) break;
        group = (group << 6 | static_cast<std::uint32_t>(digit)) & 0xFFFFFFu;
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes.push_back(static_cast<std::byte>(group >> bits & 255));
    }
    return bytes;
}

}  // namespace atlax
