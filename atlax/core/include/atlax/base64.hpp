#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace atlax {

/// Bytes as letters, digits, '+' and '/' (RFC 4648), without the '=' at the end: what travels
/// through clipboards, chats and mail. Plain values, any thread; throws nothing but std::bad_alloc.
std::string toBase64(std::span<const std::byte> bytes);

/// The opposite, up to the first character that does not belong to it; space and line ends within
/// it count for nothing. Throws nothing but std::bad_alloc.
std::vector<std::byte> fromBase64(std::string_view text);

}  // namespace atlax
