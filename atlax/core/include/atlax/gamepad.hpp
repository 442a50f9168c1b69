#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include <atlax/event.hpp>

namespace atlax {

/// Gamepads through SDL2's controller subsystem, without its video, so that every backend has them.
///
/// Pads that are plugged in or out are reported as events, and so are pads that were there before.
/// What SDL knows of pads (its controller database, and what the environment variable
/// SDL_GAMECONTROLLERCONFIG says) gives their buttons one meaning; a pad that it does not know acts
/// as soon as addMappings() has told of it. No pads, or no permission to read them, is not an
/// error: the log says so, and there are none. Owns the open pads. Main thread.
class Gamepads {
public:
    Gamepads();
    ~Gamepads();
    Gamepads(const Gamepads&) = delete;
    Gamepads& operator=(const Gamepads&) = delete;

    /// Hands everything that happened since the last call to `sink`, in order. Takes only events of
    /// controllers from SDL's queue.
    void poll(const std::function<void(const Event&)>& sink);

    /// Adds to the controller database the lines of a text in its format, as a file
    /// gamecontrollerdb.txt has them: GUID, name and mapping, separated by commas. Lines that SDL
    /// does not understand or that are for other systems are left out. Also for pads that are
    /// plugged in already. Returns how many pads the text told of.
    int addMappings(std::string_view database);

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace atlax
