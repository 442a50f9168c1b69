#include "sdl_events.hpp"

#include <array>

namespace atlax::sdl {

namespace {

struct Pair {
    SDL_Scancode code;
    Key key;
};

constexpr std::array pairs{
    Pair{SDL_SCANCODE_ESCAPE, Key::Escape},
    Pair{SDL_SCANCODE_RETURN, Key::Enter},
    Pair{SDL_SCANCODE_TAB, Key::Tab},
    Pair{SDL_SCANCODE_BACKSPACE, Key::Backspace},
    Pair{SDL_SCANCODE_SPACE, Key::Space},
    Pair{SDL_SCANCODE_INSERT, Key::Insert},
    Pair{SDL_SCANCODE_DELETE, Key::Delete},
    Pair{SDL_SCANCODE_HOME, Key::Home},
    Pair{SDL_SCANCODE_END, Key::End},
    Pair{SDL_SCANCODE_PAGEUP, Key::PageUp},
    Pair{SDL_SCANCODE_PAGEDOWN, Key::PageDown},
    Pair{SDL_SCANCODE_LEFT, Key::Left},
    Pair{SDL_SCANCODE_RIGHT, Key::Right},
    Pair{SDL_SCANCODE_UP, Key::Up},
    Pair{SDL_SCANCODE_DOWN, Key::Down},
    Pair{SDL_SCANCODE_LSHIFT, Key::LeftShift},
    Pair{SDL_SCANCODE_RSHIFT, Key::RightShift},
    Pair{SDL_SCANCODE_LCTRL, Key::LeftControl},
    Pair{SDL_SCANCODE_RCTRL, Key::RightControl},
    Pair{SDL_SCANCODE_LALT, Key::LeftAlt},
    Pair{SDL_SCANCODE_RALT, Key::RightAlt},
    Pair{SDL_SCANCODE_LGUI, Key::LeftSuper},
    Pair{SDL_SCANCODE_RGUI, Key::RightSuper},
    Pair{SDL_SCANCODE_MINUS, Key::Minus},
    Pair{SDL_SCANCODE_EQUALS, Key::Equals},
    Pair{SDL_SCANCODE_LEFTBRACKET, Key::LeftBracket},
    Pair{SDL_SCANCODE_RIGHTBRACKET, Key::RightBracket},
    Pair{SDL_SCANCODE_BACKSLASH, Key::Backslash},
    Pair{SDL_SCANCODE_SEMICOLON, Key::Semicolon},
    Pair{SDL_SCANCODE_APOSTROPHE, Key::Apostrophe},
    Pair{SDL_SCANCODE_GRAVE, Key::Grave},
    Pair{SDL_SCANCODE_COMMA, Key::Comma},
    Pair{SDL_SCANCODE_PERIOD, Key::Period},
    Pair{SDL_SCANCODE_SLASH, Key::Slash},
    Pair{SDL_SCANCODE_CAPSLOCK, Key::CapsLock},
    Pair{SDL_SCANCODE_PRINTSCREEN, Key::PrintScreen},
    Pair{SDL_SCANCODE_PAUSE, Key::Pause},
    Pair{SDL_SCANCODE_APPLICATION, Key::Menu},
    Pair{SDL_SCANCODE_0, Key::Num0},
    Pair{SDL_SCANCODE_KP_0, Key::Pad0},
    Pair{SDL_SCANCODE_KP_PERIOD, Key::PadDecimal},
    Pair{SDL_SCANCODE_KP_DIVIDE, Key::PadDivide},
    Pair{SDL_SCANCODE_KP_MULTIPLY, Key::PadMultiply},
    Pair{SDL_SCANCODE_KP_MINUS, Key::PadMinus},
    Pair{SDL_SCANCODE_KP_PLUS, Key::PadPlus},
    Pair{SDL_SCANCODE_KP_ENTER, Key::PadEnter},
};

/// A run of keys that both sides number one after the other.
struct Run {
    SDL_Scancode first;
    SDL_Scancode last;
    Key key;
};

constexpr std::array runs{
    Run{SDL_SCANCODE_A, SDL_SCANCODE_Z, Key::A},
    Run{SDL_SCANCODE_1, SDL_SCANCODE_9, Key::Num1},
    Run{SDL_SCANCODE_F1, SDL_SCANCODE_F12, Key::F1},
    Run{SDL_SCANCODE_KP_1, SDL_SCANCODE_KP_9, Key::Pad1},
};

Modifiers toModifiers(int state) {
    Modifiers out = Modifiers::None;
    if ((state & KMOD_SHIFT) != 0) out = out | Modifiers::Shift;
    if ((state & KMOD_CTRL) != 0) out = out | Modifiers::Control;
    if ((state & KMOD_ALT) != 0) out = out | Modifiers::Alt;
    if ((state & KMOD_GUI) != 0) out = out | Modifiers::Super;
    return out;
}

std::optional<MouseButton> toButton(Uint8 button) {
    switch (button) {
        case SDL_BUTTON_LEFT:
            return MouseButton::Left;
        case SDL_BUTTON_MIDDLE:
            return MouseButton::Middle;
        case SDL_BUTTON_RIGHT:
            return MouseButton::Right;
        case SDL_BUTTON_X1:
            return MouseButton::Back;
        case SDL_BUTTON_X2:
            return MouseButton::Forward;
        default:
            return {};
    }
}

Vec2 place(Sint32 x, Sint32 y, float scale) {
    return Vec2(static_cast<float>(x), static_cast<float>(y)) * scale;
}

std::optional<Event> translateButton(const SDL_MouseButtonEvent& e, float scale) {
    const auto button = toButton(e.button);
    if (!button) return {};
    return MouseButtonEvent{*button, e.state == SDL_PRESSED, place(e.x, e.y, scale), e.clicks,
                            toModifiers(SDL_GetModState())};
}

Event translateWheel(const SDL_MouseWheelEvent& e, float scale) {
    const float sign = e.direction == SDL_MOUSEWHEEL_FLIPPED ? -1.0f : 1.0f;
    Vec2 notches{e.preciseX, e.preciseY};
    // Events made by programs often leave the precise values out.
    if (notches == Vec2{}) notches = {static_cast<float>(e.x), static_cast<float>(e.y)};
    return WheelEvent{notches * sign, place(e.mouseX, e.mouseY, scale),
                      toModifiers(SDL_GetModState())};
}

std::optional<Event> translateWindow(const SDL_WindowEvent& e) {
    if (e.event == SDL_WINDOWEVENT_FOCUS_GAINED) return FocusChanged{true};
    if (e.event == SDL_WINDOWEVENT_FOCUS_LOST) return FocusChanged{false};
    return {};
}

std::optional<Event> translateDrop(const SDL_DropEvent& e) {
    if (e.file == nullptr) return {};
    FileDropped dropped{e.file};
    SDL_free(e.file);
    return dropped;
}

}  // namespace

Key toKey(SDL_Scancode code) {
    for (const Run& run : runs)
        if (code >= run.first && code <= run.last)
            return static_cast<Key>(static_cast<int>(run.key) + (code - run.first));
    for (const Pair& pair : pairs)
        if (pair.code == code) return pair.key;
    return Key::Unknown;
}

std::optional<Event> translate(const SDL_Event& event, float scale) {
    switch (event.type) {
        case SDL_KEYDOWN:
        case SDL_KEYUP:
            return KeyEvent{toKey(event.key.keysym.scancode), event.key.state == SDL_PRESSED,
                            event.key.repeat != 0, toModifiers(event.key.keysym.mod)};
        case SDL_TEXTINPUT:
            return TextEvent{event.text.text};
        case SDL_MOUSEMOTION:
            return MouseMoved{place(event.motion.x, event.motion.y, scale),
                              toModifiers(SDL_GetModState())};
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP:
            return translateButton(event.button, scale);
        case SDL_MOUSEWHEEL:
            return translateWheel(event.wheel, scale);
        case SDL_WINDOWEVENT:
            return translateWindow(event.window);
        case SDL_QUIT:
            return CloseRequested{};
        case SDL_DROPFILE:
            return translateDrop(event.drop);
        default:
            return {};
    }
}

}  // namespace atlax::sdl
