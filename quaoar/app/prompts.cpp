#include "prompts.hpp"

#include <array>
#include <cmath>

namespace quaoar {

using atlax::Action;
using atlax::Binding;

namespace {

// The buttons by the letters that most gamepads for computers wear, in the order of PadButton.
constexpr std::array<const char*, atlax::padButtonCount> padNames{
    "pad A",          "pad B",     "pad X",         "pad Y",          "pad Back",
    "pad Guide",      "pad Start", "left stick in", "right stick in", "left shoulder",
    "right shoulder", "pad up",    "pad down",      "pad left",       "pad right"};
constexpr std::array<const char*, 4> mouseNames{"left mouse button", "middle mouse button",
                                                "right mouse button", "mouse button back"};
constexpr std::array<const char*, 4> wheelNames{"wheel up", "wheel down", "wheel left",
                                                "wheel right"};

std::string axisName(const Binding& binding, const Texts& texts) {
    switch (static_cast<atlax::PadAxis>(binding.code)) {
        case atlax::PadAxis::LeftX:
            return texts(binding.negative ? "left stick left" : "left stick right");
        case atlax::PadAxis::LeftY:
            return texts(binding.negative ? "left stick down" : "left stick up");
        case atlax::PadAxis::RightX:
            return texts(binding.negative ? "right stick left" : "right stick right");
        case atlax::PadAxis::RightY:
            return texts(binding.negative ? "right stick down" : "right stick up");
        case atlax::PadAxis::LeftTrigger:
            return texts("left trigger");
        case atlax::PadAxis::RightTrigger:
            break;
    }
    return texts("right trigger");
}

struct Sign {
    atlax::Key key;
    const char* text;
};
/// Keys that are known by what stands on them.
constexpr std::array<Sign, 11> signs{{{atlax::Key::Minus, "-"},
                                      {atlax::Key::Equals, "="},
                                      {atlax::Key::LeftBracket, "["},
                                      {atlax::Key::RightBracket, "]"},
                                      {atlax::Key::Backslash, "\\"},
                                      {atlax::Key::Semicolon, ";"},
                                      {atlax::Key::Apostrophe, "'"},
                                      {atlax::Key::Grave, "`"},
                                      {atlax::Key::Comma, ","},
                                      {atlax::Key::Period, "."},
                                      {atlax::Key::Slash, "/"}}};

/// "LeftShift" as "Left Shift".
std::string spaced(std::string_view name) {
    std::string out;
    for (const char c : name) {
        if (!out.empty() && c >= 'A' && c <= 'Z') out += ' ';
        out += c;
    }
    return out;
}

/// Letters, digits and signs have no translation; the others have, under names that say what they
/// are: the direction "Left" is not the key "Left".
std::string keyText(atlax::Key key, const Texts& texts) {
    for (const Sign& sign : signs)
        if (sign.key == key) return sign.text;
    const std::string name(atlax::keyName(key));
    if (name.size() > 3 && name.starts_with("Pad") && key != atlax::Key::PadEnter)
        return texts("keypad {}", {spaced(name.substr(3))});
    const std::string text = "key " + name;
    const std::string translated = texts(text);
    return translated != text            ? translated
           : key == atlax::Key::PadEnter ? std::string("keypad Enter")
                                         : spaced(name);
}

}  // namespace

std::string bindingName(const Binding& binding, const Texts& texts) {
    switch (binding.device) {
        case Binding::Device::Key:
            return keyText(static_cast<atlax::Key>(binding.code), texts);
        case Binding::Device::Mouse:
            if (binding.code < mouseNames.size()) return texts(mouseNames[binding.code]);
            return texts("mouse button forward");
        case Binding::Device::Wheel:
            return texts(wheelNames[binding.code % wheelNames.size()]);
        case Binding::Device::PadButton:
            return texts(padNames[binding.code % padNames.size()]);
        case Binding::Device::PadAxis:
            break;
    }
    return axisName(binding, texts);
}

std::string bindingNames(const std::vector<Binding>& bindings, const Texts& texts) {
    std::string names;
    for (const Binding& binding : bindings)
        names += (names.empty() ? "" : ", ") + bindingName(binding, texts);
    return names.empty() ? "-" : names;
}

void Prompts::event(const atlax::Event& event) {
    constexpr float moved = 0.5f;
    if (const auto* axis = std::get_if<atlax::PadAxisEvent>(&event)) {
        if (std::abs(axis->value) > moved) pad_ = true;
    } else if (std::holds_alternative<atlax::PadButtonEvent>(event)) {
        pad_ = true;
    } else if (std::holds_alternative<atlax::KeyEvent>(event) ||
               std::holds_alternative<atlax::MouseMoved>(event) ||
               std::holds_alternative<atlax::MouseButtonEvent>(event) ||
               std::holds_alternative<atlax::WheelEvent>(event)) {
        pad_ = false;
    }
}

std::string Prompts::name(Action action) const {
    const std::vector<Binding>& bindings = actions_.all.bindings(action);
    for (const Binding& binding : bindings)
        if (ofPad(binding) == pad_) return bindingName(binding, texts_);
    return bindings.empty() ? "-" : bindingName(bindings.front(), texts_);
}

std::string Prompts::fill(std::string sentence) const {
    for (std::size_t open = sentence.find('{'); open != std::string::npos;
         open = sentence.find('{', open + 1)) {
        const std::size_t close = sentence.find('}', open);
        if (close == std::string::npos) break;
        const std::string key = sentence.substr(open + 1, close - open - 1);
        std::string name;
        if (key == "aim") name = texts_(pad_ ? "right stick" : "mouse");
        for (Action action = 0; action < PlayerActions::changeable; ++action)
            if (actions_.all.name(action) == key) name = this->name(action);
        if (!name.empty()) sentence.replace(open, close - open + 1, name);
    }
    return sentence;
}

std::vector<Action> Prompts::named(const std::string& sentence) const {
    std::vector<Action> out;
    for (Action action = 0; action < PlayerActions::changeable; ++action)
        if (sentence.find("{" + actions_.all.name(action) + "}") != std::string::npos)
            out.push_back(action);
    return out;
}

std::string Prompts::controls() const {
    return fill(
        texts_("{aim}: aim     {fire}: rope     {reel_in}, {reel_out}: reel     "
               "{left}, {right}: swing     {restart}: again     {pause}: pause"));
}

std::string Prompts::menu() const {
    return texts_(pad_ ? "pad A: choose     pad B: back" : "Enter: choose     Esc: back");
}

}  // namespace quaoar
