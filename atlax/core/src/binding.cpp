#include <array>
#include <atlax/binding.hpp>
#include <cmath>

namespace atlax {

namespace {

constexpr std::array<std::string_view, mouseButtonCount> mouseNames{"Left", "Middle", "Right",
                                                                    "Back", "Forward"};
constexpr std::array<std::string_view, 4> wheelNames{"Up", "Down", "Left", "Right"};
constexpr std::array<std::string_view, padButtonCount> padNames{
    "South",         "East",   "West",      "North",      "Back",
    "Guide",         "Start",  "LeftStick", "RightStick", "LeftShoulder",
    "RightShoulder", "DpadUp", "DpadDown",  "DpadLeft",   "DpadRight"};
constexpr std::array<std::string_view, padAxisCount> axisNames{
    "LeftX", "LeftY", "RightX", "RightY", "LeftTrigger", "RightTrigger"};
constexpr float captureReach = 0.6f;

template <std::size_t count>
std::optional<std::uint8_t> indexOf(const std::array<std::string_view, count>& names,
                                    std::string_view name) {
    for (std::size_t i = 0; i < count; ++i)
        if (names[i] == name) return static_cast<std::uint8_t>(i);
    return {};
}

template <std::size_t count>
std::string nameOf(const std::array<std::string_view, count>& names, std::size_t index) {
    return std::string(index < count ? names[index] : "Unknown");
}

bool isTrigger(std::size_t axis) {
    return axis >= static_cast<std::size_t>(PadAxis::LeftTrigger);
}

}  // namespace

std::string Binding::text() const {
    switch (device) {
        case Device::Key:
            return "key:" + std::string(keyName(static_cast<Key>(code)));
        case Device::Mouse:
            return "mouse:" + nameOf(mouseNames, code);
        case Device::Wheel:
            return "wheel:" + nameOf(wheelNames, code);
        case Device::PadButton:
            return "pad:" + nameOf(padNames, code);
        case Device::PadAxis:
            break;
    }
    return "axis:" + nameOf(axisNames, code) + (negative ? "-" : "+");
}

std::optional<Binding> Binding::parse(std::string_view text) {
    const auto colon = text.find(':');
    if (colon == std::string_view::npos) return {};
    const std::string_view device = text.substr(0, colon);
    std::string_view name = text.substr(colon + 1);
    const auto with = [](Device d, std::optional<std::uint8_t> number) -> std::optional<Binding> {
        if (!number) return {};
        return Binding{d, *number};
    };
    if (device == "key") {
        const Key key = keyFromName(name);
        if (key == Key::Unknown) return {};
        return Binding::key(key);
    }
    if (device == "mouse") return with(Device::Mouse, indexOf(mouseNames, name));
    if (device == "wheel") return with(Device::Wheel, indexOf(wheelNames, name));
    if (device == "pad") return with(Device::PadButton, indexOf(padNames, name));
    if (device != "axis" || name.empty()) return {};
    const char sign = name.back();
    name.remove_suffix(1);
    auto axis = with(Device::PadAxis, indexOf(axisNames, name));
    if (!axis || (sign != '+' && sign != '-')) return {};
    if (sign == '-' && isTrigger(axis->code)) return {};
    axis->negative = sign == '-';
    return axis;
}

std::optional<Binding> Binding::captured(const Event& event) {
    if (const auto* e = std::get_if<KeyEvent>(&event))
        if (e->down && !e->repeat && e->key != Key::Unknown) return key(e->key);
    if (const auto* e = std::get_if<MouseButtonEvent>(&event))
        if (e->down) return mouse(e->button);
    if (const auto* e = std::get_if<PadButtonEvent>(&event))
        if (e->down) return pad(e->button);
    if (const auto* e = std::get_if<PadAxisEvent>(&event))
        if (std::abs(e->value) > captureReach) return axis(e->axis, e->value < 0);
    if (const auto* e = std::get_if<WheelEvent>(&event)) {
        if (e->notches.y != 0) return wheel(e->notches.y > 0 ? WheelWay::Up : WheelWay::Down);
        if (e->notches.x != 0) return wheel(e->notches.x > 0 ? WheelWay::Right : WheelWay::Left);
    }
    return {};
}

}  // namespace atlax
