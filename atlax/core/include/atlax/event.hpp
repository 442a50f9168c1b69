#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>

#include <atlax/key.hpp>
#include <atlax/vec.hpp>

namespace atlax {

enum class MouseButton : std::uint8_t { Left = 0, Middle, Right, Back, Forward };
inline constexpr int mouseButtonCount = 5;

/// Buttons of a gamepad, named after their place, not after one maker's letters.
enum class PadButton : std::uint8_t {
    South = 0,
    East,
    West,
    North,
    Back,
    Guide,
    Start,
    LeftStick,
    RightStick,
    LeftShoulder,
    RightShoulder,
    DpadUp,
    DpadDown,
    DpadLeft,
    DpadRight,
};
inline constexpr int padButtonCount = 15;

/// Axes of a gamepad: sticks from -1 to 1 with right and UP positive, triggers from 0 to 1.
enum class PadAxis : std::uint8_t { LeftX = 0, LeftY, RightX, RightY, LeftTrigger, RightTrigger };
inline constexpr int padAxisCount = 6;

/// Gamepads are numbered 0..maxPads-1; a number is reused after its pad was unplugged.
inline constexpr int maxPads = 4;

/// The drawable area changed: its size in pixels and pixels per logical unit (HiDPI).
struct WindowResized {
    PixelSize size{};
    float scaleFactor = 1;
};

struct FocusChanged {
    bool focused = false;
};

/// The user wants to close the window; see Application::mayClose.
struct CloseRequested {};

struct KeyEvent {
    Key key = Key::Unknown;
    bool down = false;
    bool repeat = false;  ///< made by the keyboard's auto-repeat
    Modifiers modifiers = Modifiers::None;
};

/// Text that was typed, UTF-8, after layout, dead keys and input method.
struct TextEvent {
    std::string utf8{};
};

/// Position in pixels of the drawable area, y down.
struct MouseMoved {
    Vec2 position{};
    Modifiers modifiers = Modifiers::None;
};

struct MouseButtonEvent {
    MouseButton button = MouseButton::Left;
    bool down = false;
    Vec2 position{};
    int clicks = 1;  ///< 2 for the second press of a double click
    Modifiers modifiers = Modifiers::None;
};

/// Notches of the wheel: y positive away from the user (up), x positive to the right.
struct WheelEvent {
    Vec2 notches{};
    Vec2 position{};
    Modifiers modifiers = Modifiers::None;
};

struct PadConnected {
    int pad = 0;
    std::string name{};
};
struct PadDisconnected {
    int pad = 0;
};
struct PadButtonEvent {
    int pad = 0;
    PadButton button = PadButton::South;
    bool down = false;
};
struct PadAxisEvent {
    int pad = 0;
    PadAxis axis = PadAxis::LeftX;
    float value = 0;
};

/// A file was dropped on the window.
struct FileDropped {
    std::filesystem::path file{};
};

/// Everything that a backend may tell an application. Plain values that own what they hold, free to
/// copy and store in any thread; nothing here throws.
using Event = std::variant<WindowResized, FocusChanged, CloseRequested, KeyEvent, TextEvent,
                           MouseMoved, MouseButtonEvent, WheelEvent, PadConnected, PadDisconnected,
                           PadButtonEvent, PadAxisEvent, FileDropped>;

}  // namespace atlax
