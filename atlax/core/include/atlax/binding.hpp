#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <atlax/event.hpp>

namespace atlax {

enum class WheelWay : std::uint8_t { Up = 0, Down, Left, Right };

/// One thing that a user can press, turn or push, and that an action may be bound to: a plain
/// value, free to copy, usable in any thread. Nothing here throws.
struct Binding {
    enum class Device : std::uint8_t { Key, Mouse, Wheel, PadButton, PadAxis };

    Device device = Device::Key;
    std::uint8_t code = 0;  ///< the number of the Key, MouseButton, WheelWay, PadButton or PadAxis
    bool negative = false;  ///< of an axis: the left or lower half

    bool operator==(const Binding&) const = default;

    static Binding key(Key key) { return {Device::Key, static_cast<std::uint8_t>(key)}; }
    static Binding mouse(MouseButton b) { return {Device::Mouse, static_cast<std::uint8_t>(b)}; }
    static Binding wheel(WheelWay way) { return {Device::Wheel, static_cast<std::uint8_t>(way)}; }
    static Binding pad(PadButton b) { return {Device::PadButton, static_cast<std::uint8_t>(b)}; }
    static Binding axis(PadAxis axis, bool negative = false) {
        return {Device::PadAxis, static_cast<std::uint8_t>(axis), negative};
    }

    /// For settings and menus: "key:W", "mouse:Left", "wheel:Up", "pad:South", "axis:LeftX-".
    std::string text() const;
    /// The opposite, exact spelling; nothing for anything else.
    static std::optional<Binding> parse(std::string_view text);

    /// What the user has just pressed, for menus in which an action is bound anew: keys and buttons
    /// going down, the wheel, sticks and triggers beyond 0.6. Nothing for other events.
    static std::optional<Binding> captured(const Event& event);
};

}  // namespace atlax
