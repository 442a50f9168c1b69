#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string>
#include <vector>

#include <atlax/event.hpp>

namespace atlax {

/// One gamepad as seen by one tick.
struct PadState {
    bool connected = false;
    std::bitset<padButtonCount> down;
    std::bitset<padButtonCount> pressed;   ///< went down since the previous tick
    std::bitset<padButtonCount> released;  ///< went up since the previous tick
    std::array<float, padAxisCount> axes{};

    bool isDown(PadButton b) const { return down[static_cast<std::size_t>(b)]; }
    bool wasPressed(PadButton b) const { return pressed[static_cast<std::size_t>(b)]; }
    bool wasReleased(PadButton b) const { return released[static_cast<std::size_t>(b)]; }
    float axis(PadAxis a) const { return axes[static_cast<std::size_t>(a)]; }

    /// The stick as a vector of length 0..1, y up, with a round dead zone in the middle
    /// outside of which the length starts from 0 again.
    Vec2 leftStick(float deadZone = 0.2f) const;
    Vec2 rightStick(float deadZone = 0.2f) const;
};

/// Everything that one tick may know of keyboard, mouse and pads: a plain value, so that a
/// recording of these replays exactly.
///
/// Presses and releases since the previous tick are kept apart from what is held now: a key that
/// went down and up between two ticks is seen as pressed and released. When several ticks run
/// in one frame, the first one sees the edges, the wheel and the text, the others only what is
/// held.
struct InputState {
    std::bitset<keyCount> keysDown;
    std::bitset<keyCount> keysPressed;
    std::bitset<keyCount> keysReleased;
    std::bitset<mouseButtonCount> buttonsDown;
    std::bitset<mouseButtonCount> buttonsPressed;
    std::bitset<mouseButtonCount> buttonsReleased;
    Vec2 mouse;        ///< pixels of the drawable area, y down
    Vec2 mouseDelta;   ///< movement since the previous tick, pixels
    Vec2 wheel;        ///< notches since the previous tick
    std::string text;  ///< typed since the previous tick, UTF-8
    bool focused = true;
    std::array<PadState, maxPads> pads;

    bool isDown(Key k) const { return keysDown[static_cast<std::size_t>(k)]; }
    bool wasPressed(Key k) const { return keysPressed[static_cast<std::size_t>(k)]; }
    bool wasReleased(Key k) const { return keysReleased[static_cast<std::size_t>(k)]; }
    bool isDown(MouseButton b) const { return buttonsDown[static_cast<std::size_t>(b)]; }
    bool wasPressed(MouseButton b) const { return buttonsPressed[static_cast<std::size_t>(b)]; }
    bool wasReleased(MouseButton b) const { return buttonsReleased[static_cast<std::size_t>(b)]; }
};

/// Gathers events and gives each tick its InputState. Used by the backends; a test or a replay
/// may use one of its own. Everything held is let go when the focus is lost. One thread; nothing
/// throws, and events that name no key, button or pad are ignored.
class InputSampler {
public:
    void feed(const Event& event);

    /// Closes the collection since the last call and returns it. The reference is valid until
    /// the next call.
    const InputState& sample();

    /// The result of the last sample().
    const InputState& current() const { return current_; }

private:
    void setKey(Key key, bool down);
    void setButton(MouseButton button, bool down);
    void setPadButton(PadState& pad, PadButton button, bool down);
    void releaseAll();

    InputState pending_;
    InputState current_;
};

/// Hands the events of one frame to its ticks, in their order. An InputSampler knows of a key only
/// that it went down since the last tick, not how often: of a key that goes down and up, or down
/// again, within one slow frame, each change therefore comes in a later tick, spread evenly over
/// those of the frame; where a frame has fewer ticks than changes, the rest waits for the next one.
/// So every press counts, at any number of frames. Used by the backends. One thread; nothing
/// throws.
class InputQueue {
public:
    void add(const Event& event);
    /// Gives the sampler what is due up to tick number `tick` (from 0) of a frame of `ticks`.
    void feed(InputSampler& sampler, std::int64_t tick, std::int64_t ticks);
    /// After the frame's last tick.
    void endFrame();

private:
    struct Waiting {
        Event event;
        std::int64_t group = 0;  ///< events of one group go to the same tick
    };
    bool needsOwnTick(const Event& event) const;

    std::vector<Waiting> events_;
    std::size_t fed_ = 0;  ///< so many of them the sampler has in this frame
};

}  // namespace atlax
