#include <array>
#include <atlax/key.hpp>

namespace atlax {

namespace {

constexpr std::array<std::string_view, keyCount> names{
    "Unknown",     "A",          "B",           "C",
    "D",           "E",          "F",           "G",
    "H",           "I",          "J",           "K",
    "L",           "M",          "N",           "O",
    "P",           "Q",          "R",           "S",
    "T",           "U",          "V",           "W",
    "X",           "Y",          "Z",           "0",
    "1",           "2",          "3",           "4",
    "5",           "6",          "7",           "8",
    "9",           "F1",         "F2",          "F3",
    "F4",          "F5",         "F6",          "F7",
    "F8",          "F9",         "F10",         "F11",
    "F12",         "Escape",     "Enter",       "Tab",
    "Backspace",   "Space",      "Insert",      "Delete",
    "Home",        "End",        "PageUp",      "PageDown",
    "Left",        "Right",      "Up",          "Down",
    "LeftShift",   "RightShift", "LeftControl", "RightControl",
    "LeftAlt",     "RightAlt",   "LeftSuper",   "RightSuper",
    "Minus",       "Equals",     "LeftBracket", "RightBracket",
    "Backslash",   "Semicolon",  "Apostrophe",  "Grave",
    "Comma",       "Period",     "Slash",       "CapsLock",
    "PrintScreen", "Pause",      "Menu",        "Pad0",
    "Pad1",        "Pad2",       "Pad3",        "Pad4",
    "Pad5",        "Pad6",       "Pad7",        "Pad8",
    "Pad9",        "PadDecimal", "PadDivide",   "PadMultiply",
    "PadMinus",    "PadPlus",    "PadEnter"};
static_assert(!names.back().empty(), "every key has a name");
static_assert(static_cast<int>(Key::PadEnter) + 1 == keyCount);

}  // namespace

std::string_view keyName(Key key) {
    const auto index = static_cast<std::size_t>(key);
    return index < names.size() ? names[index] : names[0];
}

Key keyFromName(std::string_view name) {
    for (std::size_t i = 1; i < names.size(); ++i)
        if (names[i] == name) return static_cast<Key>(i);
    return Key::Unknown;
}

}  // namespace atlax
