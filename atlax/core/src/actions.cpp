#include <algorithm>
#include <atlax/actions.hpp>
#include <atlax/error.hpp>
#include <atlax/settings.hpp>
#include <cmath>

#include "utf8.hpp"

namespace atlax {

namespace {

constexpr std::size_t maxContexts = 16;
constexpr std::size_t maxBindings = 8;
constexpr float pressPoint = 0.5f;
constexpr float releasePoint = 0.4f;
constexpr double largestDeadZone = 0.9;

bool isName(std::string_view name) {
    return !name.empty() && name.size() <= 40 && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
}

std::vector<Binding> withoutRepeats(std::vector<Binding> bindings) {
    std::vector<Binding> out;
    for (const Binding& b : bindings)
        if (std::find(out.begin(), out.end(), b) == out.end()) out.push_back(b);
    if (out.size() > maxBindings)
        throw Error("an action can be bound to " + std::to_string(maxBindings) + " things at most");
    return out;
}

float safeDeadZone(float value) {
    return std::isfinite(value) ? std::clamp(value, 0.0f, static_cast<float>(largestDeadZone))
                                : 0.2f;
}

std::int16_t pixel(float value) {
    return std::isfinite(value) ? static_cast<std::int16_t>(std::clamp(value, -32768.0f, 32767.0f))
                                : std::int16_t{0};
}

float wheelNotches(Vec2 wheel, WheelWay way) {
    switch (way) {
        case WheelWay::Up:
            return std::max(wheel.y, 0.0f);
        case WheelWay::Down:
            return std::max(-wheel.y, 0.0f);
        case WheelWay::Right:
            return std::max(wheel.x, 0.0f);
        case WheelWay::Left:
            break;
    }
    return std::max(-wheel.x, 0.0f);
}

}  // namespace

Vec2 ActionState::stick(Action left, Action right, Action down_, Action up) const {
    const Vec2 out{axis(left, right), axis(down_, up)};
    const float reach = length(out);
    return reach > 1 ? out / reach : out;
}

/// What the things that an action is bound to say together.
struct Actions::Reading {
    float value = 0;
    bool held = false;    ///< by a key or button, whatever the value
    bool tapped = false;  ///< went down since the last tick
    bool let = false;     ///< went up since the last tick
    int notches = 0;

    void button(bool down, bool pressed, bool released) {
        if (down) value = 1;
        held = held || down;
        tapped = tapped || pressed;
        let = let || released;
    }
};

Actions::Actions(std::vector<std::string> contexts) : contexts_(std::move(contexts)) {
    auto sorted = contexts_;
    std::sort(sorted.begin(), sorted.end());
    if (contexts_.empty() || contexts_.size() > maxContexts ||
        std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        throw Error("actions need 1 to " + std::to_string(maxContexts) +
                    " contexts with different names");
}

Action Actions::add(std::string name, std::span<const std::string_view> contexts,
                    std::vector<Binding> bindings) {
    if (!isName(name)) throw Error("\"" + printable(name) + "\" is no name of an action");
    if (actions_.size() >= maxActions)
        throw Error("there can be " + std::to_string(maxActions) + " actions at most");
    Entry made;
    for (const Entry& other : actions_)
        if (other.name == name) throw Error("there are two actions of the name \"" + name + "\"");
    for (const std::string_view context : contexts) {
        const auto found = std::find(contexts_.begin(), contexts_.end(), context);
        if (found == contexts_.end())
            throw Error("there is no context \"" + printable(context) + "\" for actions");
        made.contexts.set(static_cast<std::size_t>(found - contexts_.begin()));
    }
    if (contexts.empty()) made.contexts.set();
    made.name = std::move(name);
    made.defaults = withoutRepeats(std::move(bindings));
    made.bindings = made.defaults;
    actions_.push_back(std::move(made));
    return static_cast<Action>(actions_.size() - 1);
}

Action Actions::add(std::string name, std::initializer_list<std::string_view> contexts,
                    std::vector<Binding> bindings) {
    return add(std::move(name), std::span(contexts.begin(), contexts.size()), std::move(bindings));
}

const Actions::Entry& Actions::entry(Action action) const {
    if (action >= actions_.size())
        throw Error("there is no action number " + std::to_string(action));
    return actions_[action];
}

const std::string& Actions::name(Action action) const {
    return entry(action).name;
}

const std::vector<Binding>& Actions::bindings(Action action) const {
    return entry(action).bindings;
}

void Actions::rebind(Action action, std::vector<Binding> bindings) {
    entry(action);
    actions_[action].bindings = withoutRepeats(std::move(bindings));
    actions_[action].blocked = true;
}

void Actions::resetBindings() {
    for (Entry& e : actions_) {
        e.bindings = e.defaults;
        e.blocked = true;
    }
}

std::vector<Action> Actions::conflicts(Action action, const Binding& binding) const {
    const Entry& mine = entry(action);
    std::vector<Action> out;
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        const Entry& other = actions_[i];
        if (i == action || (other.contexts & mine.contexts).none()) continue;
        if (std::find(other.bindings.begin(), other.bindings.end(), binding) !=
            other.bindings.end())
            out.push_back(static_cast<Action>(i));
    }
    return out;
}

void Actions::setContext(std::string_view name) {
    const auto found = std::find(contexts_.begin(), contexts_.end(), name);
    if (found == contexts_.end())
        throw Error("there is no context \"" + printable(name) + "\" for actions");
    const auto next = static_cast<std::size_t>(found - contexts_.begin());
    if (next == context_) return;
    for (Entry& e : actions_) {
        const bool stays = e.contexts[next] && e.contexts[context_];
        if (!stays) e.blocked = true;
    }
    context_ = next;
}

void Actions::setDeadZones(float stick, float trigger) {
    stickDeadZone_ = safeDeadZone(stick);
    triggerDeadZone_ = safeDeadZone(trigger);
}

void Actions::readPad(const Binding& binding, const PadState& pad, Reading& reading) const {
    if (binding.device == Binding::Device::PadButton) {
        const auto b = static_cast<PadButton>(binding.code);
        reading.button(pad.isDown(b), pad.wasPressed(b), pad.wasReleased(b));
        return;
    }
    if (binding.device != Binding::Device::PadAxis) return;
    float value = 0;
    switch (static_cast<PadAxis>(binding.code)) {
        case PadAxis::LeftX:
            value = pad.leftStick(stickDeadZone_).x;
            break;
        case PadAxis::LeftY:
            value = pad.leftStick(stickDeadZone_).y;
            break;
        case PadAxis::RightX:
            value = pad.rightStick(stickDeadZone_).x;
            break;
        case PadAxis::RightY:
            value = pad.rightStick(stickDeadZone_).y;
            break;
        case PadAxis::LeftTrigger:
        case PadAxis::RightTrigger:
            value = (pad.axis(static_cast<PadAxis>(binding.code)) - triggerDeadZone_) /
                    (1 - triggerDeadZone_);
            break;
    }
    reading.value =
        std::max(reading.value, std::clamp(binding.negative ? -value : value, 0.0f, 1.0f));
}

Actions::Reading Actions::read(Entry& e, const InputState& input) const {
    Reading out;
    float turned = 0;
    for (const Binding& b : e.bindings) {
        if (b.device == Binding::Device::Key) {
            const auto key = static_cast<Key>(b.code);
            out.button(input.isDown(key), input.wasPressed(key), input.wasReleased(key));
        } else if (b.device == Binding::Device::Mouse) {
            const auto button = static_cast<MouseButton>(b.code);
            out.button(input.isDown(button), input.wasPressed(button), input.wasReleased(button));
        } else if (b.device == Binding::Device::Wheel) {
            turned += wheelNotches(input.wheel, static_cast<WheelWay>(b.code));
        } else {
            // Also one that is gone: what it held is let go in its last tick.
            for (std::size_t i = 0; i < input.pads.size(); ++i)
                if (pad_ < 0 || static_cast<std::size_t>(pad_) == i) readPad(b, input.pads[i], out);
        }
    }
    constexpr float mostNotches = 255;
    e.wheelRest = std::min(e.wheelRest + (std::isfinite(turned) ? turned : 0.0f), mostNotches);
    out.notches = static_cast<int>(e.wheelRest);
    e.wheelRest -= static_cast<float>(out.notches);
    return out;
}

void Actions::apply(std::size_t index, const Reading& reading) {
    Entry& e = actions_[index];
    const bool wasDown = current_.down[index];
    const bool reached = reading.value >= (wasDown ? releasePoint : pressPoint);
    bool down = reading.held || reached;
    if (e.blocked && !down) {
        e.blocked = false;
        current_.values[index] = 0;
        current_.down[index] = false;
        current_.released[index] = wasDown;
        current_.pressed[index] = false;
        current_.presses[index] = 0;
        return;
    }
    const bool acts = !e.blocked && e.contexts[context_];
    down = down && acts;
    // A key that came up and down again between two ticks, or down and up, was pressed all the
    // same.
    const bool again =
        acts && reading.tapped && (reading.let || !reading.held) && (wasDown == down || !down);
    const int notches = acts ? reading.notches : 0;
    current_.pressed[index] = (down && !wasDown) || again || notches > 0;
    current_.released[index] = (wasDown && !down) || again || notches > 0;
    current_.down[index] = down;
    current_.presses[index] = static_cast<std::uint8_t>(
        std::min((current_.pressed[index] && notches == 0 ? 1 : 0) + notches, 255));
    const float value = acts ? std::clamp(reading.value, 0.0f, 1.0f) : 0.0f;
    current_.values[index] = static_cast<std::uint8_t>(std::lround(value * 255.0f));
}

const ActionState& Actions::sample(const InputState& input) {
    for (std::size_t i = 0; i < actions_.size(); ++i) apply(i, read(actions_[i], input));
    current_.pointerX = pixel(input.mouse.x);
    current_.pointerY = pixel(input.mouse.y);
    return current_;
}

void Actions::save(Settings& settings) const {
    for (const Entry& e : actions_) {
        std::vector<std::string> texts;
        for (const Binding& b : e.bindings) texts.push_back(b.text());
        if (e.bindings == e.defaults)
            settings.erase("input." + e.name);
        else
            settings.set("input." + e.name, texts);
    }
    settings.set("input.stick_dead_zone", static_cast<double>(stickDeadZone_));
    settings.set("input.trigger_dead_zone", static_cast<double>(triggerDeadZone_));
}

std::vector<std::string> Actions::load(const Settings& settings) {
    std::vector<std::string> problems;
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        Entry& e = actions_[i];
        const std::string key = "input." + e.name;
        if (!settings.has(key)) continue;
        // A value of another kind must not look like an empty list, which unbinds the action.
        const auto texts = settings.get(key, std::vector<std::string>{"?"});
        std::vector<Binding> bindings;
        bool good = texts.size() <= maxBindings;
        for (const std::string& text : texts) {
            const auto binding = Binding::parse(text);
            if (binding) bindings.push_back(*binding);
            good = good && binding.has_value();
        }
        if (good)
            rebind(static_cast<Action>(i), std::move(bindings));
        else
            problems.push_back("the setting \"" + key +
                               "\" is no list of up to 8 keys, buttons and axes; it is not used");
    }
    const auto zone = [&](const char* key, float now) {
        return static_cast<float>(
            settings.get(key, static_cast<double>(now), 0.0, largestDeadZone));
    };
    setDeadZones(zone("input.stick_dead_zone", stickDeadZone_),
                 zone("input.trigger_dead_zone", triggerDeadZone_));
    return problems;
}

}  // namespace atlax
