#pragma once

#include <cstdint>
#include <string_view>

namespace atlax {

/// Keys by their place on a US keyboard (so that WASD is the same square on every layout);
/// text comes through TextEvent. The numbers are atlax's own and stable: recordings and
/// settings may store them. Plain values: everything here may be used in any thread, and throws
/// nothing.
// clang-format off
enum class Key : std::uint8_t {
    Unknown = 0,
    A = 1, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z,
    Num0 = 27, Num1, Num2, Num3, Num4, Num5, Num6, Num7, Num8, Num9,
    F1 = 37, F2, F3, F4, F5, F6, F7, F8, F9, F10, F11, F12,
    Escape = 49, Enter, Tab, Backspace, Space, Insert, Delete, Home, End, PageUp, PageDown,
    Left = 60, Right, Up, Down,
    LeftShift = 64, RightShift, LeftControl, RightControl, LeftAlt, RightAlt, LeftSuper, RightSuper,
    Minus = 72, Equals, LeftBracket, RightBracket, Backslash, Semicolon, Apostrophe, Grave, Comma,
    Period, Slash, CapsLock, PrintScreen, Pause, Menu,
    Pad0 = 87, Pad1, Pad2, Pad3, Pad4, Pad5, Pad6, Pad7, Pad8, Pad9, PadDecimal, PadDivide,
    PadMultiply, PadMinus, PadPlus, PadEnter,
};
// clang-format on

/// One more than the largest key number.
inline constexpr int keyCount = 103;

/// A short English name ("W", "Left", "Escape"), "Unknown" for anything else. Static storage.
std::string_view keyName(Key key);

/// The key with that name (exact spelling), Key::Unknown when there is none.
Key keyFromName(std::string_view name);

/// Modifier keys held during an event, as a set of bits.
enum class Modifiers : std::uint8_t { None = 0, Shift = 1, Control = 2, Alt = 4, Super = 8 };

constexpr Modifiers operator|(Modifiers a, Modifiers b) {
    return static_cast<Modifiers>(static_cast<std::uint8_t>(a) | static_cast<std::uint8_t>(b));
}
constexpr bool has(Modifiers set, Modifiers one) {
    return (static_cast<std::uint8_t>(set) & static_cast<std::uint8_t>(one)) != 0;
}

}  // namespace atlax
