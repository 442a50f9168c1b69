#include "utf8.hpp"

#include <cstdint>

namespace atlax {

namespace {

/// Length of the sequence at the start of `text`, 0 when there is none.
std::size_t sequence(std::string_view text) {
    const auto at = [&](std::size_t i) { return static_cast<std::uint32_t>(text[i]) & 0xffu; };
    const std::uint32_t lead = at(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
    std::uint32_t code = lead & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((at(i) & 0xc0u) != 0x80u) return 0;
        code = code << 6 | (at(i) & 0x3fu);
    }
    if (length == 3 && (code < 0x800 || (code >= 0xd800 && code <= 0xdfff))) return 0;
    if (length == 4 && (code < 0x10000 || code > 0x10ffff)) return 0;
    return length;
}

}  // namespace

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = sequence(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

std::string printable(std::string_view text) {
    constexpr std::size_t longest = 100;
    std::string out;
    for (const char c : text.substr(0, longest)) out += c >= 32 && c < 127 ? c : '?';
    if (text.size() > longest) out += "...";
    return out;
}

}  // namespace atlax
