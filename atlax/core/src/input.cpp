#include <algorithm>
#include <atlax/input.hpp>

namespace atlax {

namespace {

template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

Vec2 withDeadZone(Vec2 stick, float deadZone) {
    const float reach = length(stick);
    const float dead = std::clamp(deadZone, 0.0f, 0.99f);
    if (!(reach > dead)) return {};
    return stick / reach * std::min((reach - dead) / (1 - dead), 1.0f);
}

PadState* padOf(InputState& state, int pad) {
    if (pad < 0 || pad >= maxPads) return nullptr;
    return &state.pads[static_cast<std::size_t>(pad)];
}

}  // namespace

Vec2 PadState::leftStick(float deadZone) const {
    return withDeadZone({axis(PadAxis::LeftX), axis(PadAxis::LeftY)}, deadZone);
}

Vec2 PadState::rightStick(float deadZone) const {
    return withDeadZone({axis(PadAxis::RightX), axis(PadAxis::RightY)}, deadZone);
}

void InputSampler::setKey(Key key, bool down) {
    const auto i = static_cast<std::size_t>(key);
    if (key == Key::Unknown || i >= keyCount || pending_.keysDown[i] == down) return;
    pending_.keysDown[i] = down;
    (down ? pending_.keysPressed : pending_.keysReleased)[i] = true;
}

void InputSampler::setButton(MouseButton button, bool down) {
    const auto i = static_cast<std::size_t>(button);
    if (i >= mouseButtonCount || pending_.buttonsDown[i] == down) return;
    pending_.buttonsDown[i] = down;
    (down ? pending_.buttonsPressed : pending_.buttonsReleased)[i] = true;
}

void InputSampler::setPadButton(PadState& pad, PadButton button, bool down) {
    const auto i = static_cast<std::size_t>(button);
    if (i >= padButtonCount || pad.down[i] == down) return;
    pad.down[i] = down;
    (down ? pad.pressed : pad.released)[i] = true;
}

void InputSampler::releaseAll() {
    pending_.keysReleased |= pending_.keysDown;
    pending_.keysDown.reset();
    pending_.buttonsReleased |= pending_.buttonsDown;
    pending_.buttonsDown.reset();
    for (PadState& pad : pending_.pads) {
        pad.released |= pad.down;
        pad.down.reset();
        pad.axes.fill(0);
    }
}

void InputSampler::feed(const Event& event) {
    const auto moveTo = [this](Vec2 position) {
        pending_.mouseDelta += position - pending_.mouse;
        pending_.mouse = position;
    };
    std::visit(Overloaded{
                   [&](const KeyEvent& e) {
                       if (!e.repeat) setKey(e.key, e.down);
                   },
                   [&](const MouseMoved& e) { moveTo(e.position); },
                   [&](const MouseButtonEvent& e) {
                       moveTo(e.position);
                       setButton(e.button, e.down);
                   },
                   [&](const WheelEvent& e) { pending_.wheel += e.notches; },
                   [&](const TextEvent& e) { pending_.text += e.utf8; },
                   [&](const FocusChanged& e) {
                       pending_.focused = e.focused;
                       if (!e.focused) releaseAll();
                   },
                   [&](const PadConnected& e) {
                       if (auto* pad = padOf(pending_, e.pad)) pad->connected = true;
                   },
                   [&](const PadDisconnected& e) {
                       if (auto* pad = padOf(pending_, e.pad)) {
                           const auto held = pad->down;
                           *pad = {};
                           pad->released = held;
                       }
                   },
                   [&](const PadButtonEvent& e) {
                       if (auto* pad = padOf(pending_, e.pad)) setPadButton(*pad, e.button, e.down);
                   },
                   [&](const PadAxisEvent& e) {
                       const auto i = static_cast<std::size_t>(e.axis);
                       auto* pad = padOf(pending_, e.pad);
                       if (pad != nullptr && i < padAxisCount) pad->axes[i] = e.value;
                   },
                   [](const auto&) {},
               },
               event);
}

namespace {

/// From half of its way a stick or trigger counts as pressed (see Actions).
bool isPushed(float value) {
    return value >= 0.5f || value <= -0.5f;
}

/// Whether both change the same key, button or trigger, so that one tick cannot show both.
bool changeTheSame(const Event& a, const Event& b) {
    if (a.index() != b.index()) return false;
    if (const auto* key = std::get_if<KeyEvent>(&a)) return key->key == std::get<KeyEvent>(b).key;
    if (const auto* button = std::get_if<MouseButtonEvent>(&a))
        return button->button == std::get<MouseButtonEvent>(b).button;
    if (const auto* button = std::get_if<PadButtonEvent>(&a)) {
        const auto& other = std::get<PadButtonEvent>(b);
        return button->pad == other.pad && button->button == other.button;
    }
    if (const auto* axis = std::get_if<PadAxisEvent>(&a)) {
        const auto& other = std::get<PadAxisEvent>(b);
        return axis->pad == other.pad && axis->axis == other.axis &&
               isPushed(axis->value) != isPushed(other.value);
    }
    return false;
}

bool isRepeat(const Event& event) {
    const auto* key = std::get_if<KeyEvent>(&event);
    return key != nullptr && key->repeat;
}

}  // namespace

bool InputQueue::needsOwnTick(const Event& event) const {
    if (isRepeat(event)) return false;
    const std::int64_t last = events_.back().group;
    return std::any_of(events_.rbegin(), events_.rend(), [&](const Waiting& waiting) {
        return waiting.group == last && !isRepeat(waiting.event) &&
               changeTheSame(waiting.event, event);
    });
}

void InputQueue::add(const Event& event) {
    if (events_.empty())
        events_.push_back({event, 0});
    else
        events_.push_back({event, events_.back().group + (needsOwnTick(event) ? 1 : 0)});
}

void InputQueue::feed(InputSampler& sampler, std::int64_t tick, std::int64_t ticks) {
    if (events_.empty()) return;
    const std::int64_t groups = events_.back().group + 1;
    for (; fed_ < events_.size(); ++fed_) {
        const std::int64_t group = events_[fed_].group;
        if ((groups <= ticks ? group * ticks / groups : group) > tick) return;
        sampler.feed(events_[fed_].event);
    }
}

void InputQueue::endFrame() {
    events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(fed_));
    fed_ = 0;
    if (events_.empty()) return;
    const std::int64_t first = events_.front().group;
    for (Waiting& waiting : events_) waiting.group -= first;
}

const InputState& InputSampler::sample() {
    current_ = pending_;
    pending_.keysPressed.reset();
    pending_.keysReleased.reset();
    pending_.buttonsPressed.reset();
    pending_.buttonsReleased.reset();
    pending_.mouseDelta = {};
    pending_.wheel = {};
    pending_.text.clear();
    for (PadState& pad : pending_.pads) {
        pad.pressed.reset();
        pad.released.reset();
    }
    return current_;
}

}  // namespace atlax
