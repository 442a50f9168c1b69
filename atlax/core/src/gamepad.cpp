#include <SDL.h>

#include <algorithm>
#include <array>
#include <atlax/gamepad.hpp>
#include <atlax/log.hpp>
#include <cstdlib>

namespace atlax {

namespace {

float axisValue(Uint8 axis, Sint16 value) {
    // The range is -32768..32767; both ends become exactly -1 and 1.
    const float unit = std::max(static_cast<float>(value) / 32767.0f, -1.0f);
    const bool vertical = axis == SDL_CONTROLLER_AXIS_LEFTY || axis == SDL_CONTROLLER_AXIS_RIGHTY;
    return vertical ? -unit : unit;
}

}  // namespace

struct Gamepads::Implementation {
    std::array<SDL_GameController*, maxPads> open{};
    bool running = false;

    using Sink = std::function<void(const Event&)>;

    int slotOf(SDL_JoystickID id) const {
        for (std::size_t i = 0; i < open.size(); ++i)
            if (open[i] != nullptr &&
                SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(open[i])) == id)
                return static_cast<int>(i);
        return -1;
    }

    void plugged(int device, const Sink& sink) {
        if (slotOf(SDL_JoystickGetDeviceInstanceID(device)) >= 0) return;
        const auto free = std::find(open.begin(), open.end(), nullptr);
        if (free == open.end()) return;
        *free = SDL_GameControllerOpen(device);
        if (*free == nullptr) {
            log(LogLevel::Warning, std::string("a gamepad cannot be used: ") + SDL_GetError());
            return;
        }
        const char* name = SDL_GameControllerName(*free);
        sink(PadConnected{static_cast<int>(free - open.begin()), name ? name : "gamepad"});
    }

    void unplugged(SDL_JoystickID id, const Sink& sink) {
        const int slot = slotOf(id);
        if (slot < 0) return;
        SDL_GameControllerClose(open[static_cast<std::size_t>(slot)]);
        open[static_cast<std::size_t>(slot)] = nullptr;
        sink(PadDisconnected{slot});
    }

    void handle(const SDL_Event& event, const Sink& sink) {
        switch (event.type) {
            case SDL_CONTROLLERDEVICEADDED:
                plugged(event.cdevice.which, sink);
                break;
            case SDL_CONTROLLERDEVICEREMOVED:
                unplugged(event.cdevice.which, sink);
                break;
            case SDL_CONTROLLERBUTTONDOWN:
            case SDL_CONTROLLERBUTTONUP: {
                const int slot = slotOf(event.cbutton.which);
                // SDL numbers the buttons in the same order; later ones have no name here.
                if (slot >= 0 && event.cbutton.button < padButtonCount)
                    sink(PadButtonEvent{slot, static_cast<PadButton>(event.cbutton.button),
                                        event.cbutton.state == SDL_PRESSED});
                break;
            }
            case SDL_CONTROLLERAXISMOTION: {
                const int slot = slotOf(event.caxis.which);
                if (slot >= 0 && event.caxis.axis < padAxisCount)
                    sink(PadAxisEvent{slot, static_cast<PadAxis>(event.caxis.axis),
                                      axisValue(event.caxis.axis, event.caxis.value)});
                break;
            }
            default:
                break;
        }
    }
};

Gamepads::Gamepads() : implementation_(std::make_unique<Implementation>()) {
    // The window may belong to another library, so SDL cannot know whether it has the focus; what
    // lost focus means is decided by InputSampler.
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    implementation_->running = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
    if (!implementation_->running)
        log(LogLevel::Warning, std::string("no gamepads: ") + SDL_GetError());
}

Gamepads::~Gamepads() {
    if (!implementation_->running) return;
    for (auto* pad : implementation_->open)
        if (pad != nullptr) SDL_GameControllerClose(pad);
    SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

int Gamepads::addMappings(std::string_view database) {
    constexpr std::size_t longest = 8u << 20;
    if (!implementation_->running || database.empty() || database.size() > longest) return 0;
    SDL_RWops* text = SDL_RWFromConstMem(database.data(), static_cast<int>(database.size()));
    return std::max(SDL_GameControllerAddMappingsFromRW(text, 1), 0);
}

void Gamepads::poll(const std::function<void(const Event&)>& sink) {
    if (!implementation_->running) return;
    SDL_PumpEvents();
    // Joystick events come doubled, once raw and once as controller; the raw ones are dropped.
    SDL_FlushEvents(SDL_JOYAXISMOTION, SDL_CONTROLLERAXISMOTION - 1);
    SDL_Event event;
    while (SDL_PeepEvents(&event, 1, SDL_GETEVENT, SDL_CONTROLLERAXISMOTION,
                          SDL_CONTROLLERSENSORUPDATE) > 0)
        implementation_->handle(event, sink);
}

}  // namespace atlax
