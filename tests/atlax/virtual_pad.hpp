#pragma once

#include <SDL.h>
#include <gtest/gtest.h>

#include <atlax/actions.hpp>

#include "scripted_app.hpp"

/// A gamepad of SDL's that exists only in this process.
class VirtualPad {
public:
    /// False where SDL has none.
    bool plugIn() {
        device_ = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER,
                                            SDL_CONTROLLER_AXIS_MAX, SDL_CONTROLLER_BUTTON_MAX, 0);
        return device_ >= 0;
    }
    /// Holds South; somebody must have opened the pad.
    void hold() const {
        SDL_Joystick* pad = SDL_JoystickFromInstanceID(SDL_JoystickGetDeviceInstanceID(device_));
        if (pad != nullptr) SDL_JoystickSetVirtualButton(pad, SDL_CONTROLLER_BUTTON_A, 1);
    }
    void unplug() {
        if (device_ >= 0) SDL_JoystickDetachVirtual(device_);
        device_ = -1;
    }

private:
    int device_ = -1;
};

/// Runs an application by `run(application)`, plugs a pad in meanwhile, holds its button, and pulls
/// it out: the action that is bound to the button must be let go.
template <class Run>
void expectAPadToComeAndGo(Run run) {
    using namespace atlax;
    ScriptedApp app;
    Actions actions(std::vector<std::string>{"play"});
    const Action fire = actions.add("fire", {"play"}, {Binding::pad(PadButton::South)});
    VirtualPad pad;
    bool none = false, acted = false, letGo = false;
    app.onTick = [&] {
        const ActionState& state = actions.sample(app.platform->input());
        if (app.ticks == 10) none = !pad.plugIn();
        if (app.last<PadConnected>() && !acted) pad.hold();
        letGo = letGo || (acted && state.wasReleased(fire));
        if (state.isDown(fire) && !acted) {
            acted = true;
            pad.unplug();
        }
        if (none || letGo || app.ticks > 20'000) app.platform->quit();
    };
    EXPECT_EQ(run(app), 0);
    if (none) GTEST_SKIP() << "SDL has no virtual joysticks here";
    EXPECT_TRUE(acted);
    EXPECT_TRUE(letGo);
    EXPECT_TRUE(app.template last<PadDisconnected>().has_value());
}
