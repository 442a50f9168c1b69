#include "wx_keys.hpp"

#include <array>
#include <utility>

namespace atlax::wx {
namespace {

using K = Key;

// Keycodes of X11 (and of GDK on Wayland) from 9, Escape, to 96, F12: the kernel's codes plus 8.
// Beyond these, the kernel's table and the older one of X servers differ, so that such keys are
// told by their symbol.
constexpr int firstKeycode = 9;
constexpr std::array<Key, 88> keysByPlace{
    K::Escape,      K::Num1,        K::Num2,
    K::Num3,        K::Num4,        K::Num5,
    K::Num6,        K::Num7,        K::Num8,
    K::Num9,        K::Num0,        K::Minus,
    K::Equals,      K::Backspace,   K::Tab,
    K::Q,           K::W,           K::E,
    K::R,           K::T,           K::Y,
    K::U,           K::I,           K::O,
    K::P,           K::LeftBracket, K::RightBracket,
    K::Enter,       K::LeftControl, K::A,
    K::S,           K::D,           K::F,
    K::G,           K::H,           K::J,
    K::K,           K::L,           K::Semicolon,
    K::Apostrophe,  K::Grave,       K::LeftShift,
    K::Backslash,   K::Z,           K::X,
    K::C,           K::V,           K::B,
    K::N,           K::M,           K::Comma,
    K::Period,      K::Slash,       K::RightShift,
    K::PadMultiply, K::LeftAlt,     K::Space,
    K::CapsLock,    K::F1,          K::F2,
    K::F3,          K::F4,          K::F5,
    K::F6,          K::F7,          K::F8,
    K::F9,          K::F10,         K::Unknown,
    K::Unknown,     K::Pad7,        K::Pad8,
    K::Pad9,        K::PadMinus,    K::Pad4,
    K::Pad5,        K::Pad6,        K::PadPlus,
    K::Pad1,        K::Pad2,        K::Pad3,
    K::Pad0,        K::PadDecimal,  K::Unknown,
    K::Unknown,     K::Backslash,   K::F11,
    K::F12,
};

constexpr std::array<std::pair<int, Key>, 41> keysByCode{{
    {WXK_BACK, K::Backspace},
    {WXK_TAB, K::Tab},
    {WXK_RETURN, K::Enter},
    {WXK_ESCAPE, K::Escape},
    {WXK_SPACE, K::Space},
    {WXK_DELETE, K::Delete},
    {WXK_INSERT, K::Insert},
    {WXK_HOME, K::Home},
    {WXK_END, K::End},
    {WXK_PAGEUP, K::PageUp},
    {WXK_PAGEDOWN, K::PageDown},
    {WXK_LEFT, K::Left},
    {WXK_RIGHT, K::Right},
    {WXK_UP, K::Up},
    {WXK_DOWN, K::Down},
    {WXK_SHIFT, K::LeftShift},
    {WXK_RAW_CONTROL, K::LeftControl},
    {WXK_ALT, K::LeftAlt},
    {WXK_WINDOWS_LEFT, K::LeftSuper},
    {WXK_WINDOWS_RIGHT, K::RightSuper},
    {WXK_WINDOWS_MENU, K::Menu},
    {WXK_MENU, K::Menu},
    {WXK_PAUSE, K::Pause},
    {WXK_PRINT, K::PrintScreen},
    {WXK_SNAPSHOT, K::PrintScreen},
    {WXK_CAPITAL, K::CapsLock},
    {WXK_NUMPAD_ENTER, K::PadEnter},
    {WXK_NUMPAD_DIVIDE, K::PadDivide},
    {WXK_NUMPAD_MULTIPLY, K::PadMultiply},
    {WXK_NUMPAD_ADD, K::PadPlus},
    {WXK_NUMPAD_SUBTRACT, K::PadMinus},
    {'-', K::Minus},
    {'=', K::Equals},
    {'[', K::LeftBracket},
    {']', K::RightBracket},
    {'\\', K::Backslash},
    {';', K::Semicolon},
    {'\'', K::Apostrophe},
    {',', K::Comma},
    {'.', K::Period},
    {'/', K::Slash},
}};

constexpr Key offset(Key first, int by) {
    return static_cast<Key>(static_cast<int>(first) + by);
}

// Keysyms of the modifier keys, by which left and right are told apart.
Key modifierKey(unsigned keysym) {
    switch (keysym) {
        case 0xffe1:
            return K::LeftShift;
        case 0xffe2:
            return K::RightShift;
        case 0xffe3:
            return K::LeftControl;
        case 0xffe4:
            return K::RightControl;
        case 0xffe9:
            return K::LeftAlt;
        case 0xffea:
        case 0xfe03:
            return K::RightAlt;
        case 0xffeb:
            return K::LeftSuper;
        case 0xffec:
            return K::RightSuper;
        default:
            return K::Unknown;
    }
}

Key keyByCode(int code) {
    if (code >= 'A' && code <= 'Z') return offset(K::A, code - 'A');
    if (code >= 'a' && code <= 'z') return offset(K::A, code - 'a');
    if (code >= '0' && code <= '9') return offset(K::Num0, code - '0');
    if (code >= WXK_F1 && code <= WXK_F12) return offset(K::F1, code - WXK_F1);
    if (code >= WXK_NUMPAD0 && code <= WXK_NUMPAD9) return offset(K::Pad0, code - WXK_NUMPAD0);
    if (code == '`') return K::Grave;
    for (const auto& [wxCode, key] : keysByCode)
        if (wxCode == code) return key;
    return K::Unknown;
}

}  // namespace

Key keyOf(const wxKeyEvent& event) {
    if (const Key key = modifierKey(event.GetRawKeyCode()); key != K::Unknown) return key;
    const int place = static_cast<int>(event.GetRawKeyFlags()) - firstKeycode;
    if (place >= 0 && place < static_cast<int>(keysByPlace.size()))
        return keysByPlace[static_cast<std::size_t>(place)];
    return keyByCode(event.GetKeyCode());
}

Modifiers modifiersOf(const wxKeyboardState& state) {
    Modifiers set = Modifiers::None;
    if (state.ShiftDown()) set = set | Modifiers::Shift;
    if (state.RawControlDown()) set = set | Modifiers::Control;
    if (state.AltDown()) set = set | Modifiers::Alt;
    if (state.MetaDown()) set = set | Modifiers::Super;
    return set;
}

}  // namespace atlax::wx
