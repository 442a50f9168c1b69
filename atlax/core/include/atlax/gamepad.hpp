#pragma once

#include <functional>
#include <memory>

#include <atlax/event.hpp>

namespace atlax {

/// Gamepads through SDL2's controller subsystem, without its video, so that every backend has them.
/// Hot plug is reported as events. No pads, or no permission to read them, is not an error. Main
/// thread.
class Gamepads {
public:
    Gamepads();
    ~Gamepads();
    Gamepads(const Gamepads&) = delete;
    Gamepads& operator=(const Gamepads&) = delete;

    /// Hands everything that happened since the last call to `sink`, in order. Takes only events of
    /// controllers from SDL's queue.
    void poll(const std::function<void(const Event&)>& sink);

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace atlax
