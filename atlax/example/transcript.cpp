#include "transcript.hpp"

#include <cmath>
#include <string_view>

namespace {

using namespace atlax;

std::string rounded(Vec2 v) {
    return std::to_string(std::lround(v.x)) + " " + std::to_string(std::lround(v.y));
}

std::string_view nameOf(MouseButton button) {
    static constexpr std::string_view names[mouseButtonCount] = {"Left", "Middle", "Right", "Back",
                                                                 "Forward"};
    return names[static_cast<std::size_t>(button)];
}

std::string withModifiers(Modifiers set) {
    std::string out;
    if (has(set, Modifiers::Control)) out += " with Control";
    if (has(set, Modifiers::Alt)) out += " with Alt";
    return out;
}

struct Describe {
    std::string operator()(const WindowResized& e) const {
        return "size " + rounded(e.size.toVec()) + " scale " +
               std::to_string(std::lround(e.scaleFactor * 100)) + " %";
    }
    std::string operator()(const FocusChanged& e) const {
        return e.focused ? "focus gained" : "focus lost";
    }
    std::string operator()(const CloseRequested&) const { return "close requested"; }
    std::string operator()(const KeyEvent& e) const {
        if (e.repeat) return {};
        return "key " + std::string(keyName(e.key)) + (e.down ? " down" : " up") +
               (e.down ? withModifiers(e.modifiers) : "");
    }
    std::string operator()(const TextEvent& e) const { return "text " + e.utf8; }
    std::string operator()(const MouseMoved&) const { return {}; }
    std::string operator()(const MouseButtonEvent& e) const {
        return "button " + std::string(nameOf(e.button)) + (e.down ? " down" : " up") +
               (e.clicks > 1 && e.down ? " twice" : "") + " at " + rounded(e.position);
    }
    std::string operator()(const WheelEvent& e) const {
        return "wheel " + rounded(e.notches) + " at " + rounded(e.position);
    }
    std::string operator()(const PadConnected& e) const {
        return "pad " + std::to_string(e.pad) + " connected: " + e.name;
    }
    std::string operator()(const PadDisconnected& e) const {
        return "pad " + std::to_string(e.pad) + " disconnected";
    }
    std::string operator()(const PadButtonEvent& e) const {
        return "pad " + std::to_string(e.pad) + " button " +
               std::to_string(static_cast<int>(e.button)) + (e.down ? " down" : " up");
    }
    std::string operator()(const PadAxisEvent&) const { return {}; }
    std::string operator()(const FileDropped& e) const { return "dropped " + e.file.string(); }
};

}  // namespace

std::string describe(const Event& event) {
    return std::visit(Describe{}, event);
}
