#include <SDL.h>
#include <gtest/gtest.h>

#include <atlax/gamepad.hpp>
#include <optional>
#include <vector>

namespace {

using namespace atlax;

std::vector<Event> pollAll(Gamepads& pads) {
    std::vector<Event> events;
    pads.poll([&](const Event& e) { events.push_back(e); });
    return events;
}

template <class T>
std::optional<T> firstOf(const std::vector<Event>& events) {
    for (const Event& e : events)
        if (const T* found = std::get_if<T>(&e)) return *found;
    return {};
}

TEST(Gamepads, aVirtualPadIsPluggedPlayedAndUnplugged) {
    Gamepads pads;
    pollAll(pads);
    const int device = SDL_JoystickAttachVirtual(
        SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX, SDL_CONTROLLER_BUTTON_MAX, 0);
    if (device < 0) GTEST_SKIP() << "SDL has no virtual joysticks here: " << SDL_GetError();
    auto events = pollAll(pads);
    const auto connected = firstOf<PadConnected>(events);
    ASSERT_TRUE(connected.has_value());
    const int pad = connected->pad;
    EXPECT_FALSE(connected->name.empty());

    SDL_Joystick* joystick = SDL_JoystickFromInstanceID(SDL_JoystickGetDeviceInstanceID(device));
    ASSERT_NE(joystick, nullptr);
    SDL_JoystickSetVirtualButton(joystick, SDL_CONTROLLER_BUTTON_A, 1);
    SDL_JoystickSetVirtualAxis(joystick, SDL_CONTROLLER_AXIS_LEFTY, -32768);
    events = pollAll(pads);
    const auto button = firstOf<PadButtonEvent>(events);
    ASSERT_TRUE(button.has_value());
    EXPECT_EQ(button->button, PadButton::South);
    EXPECT_TRUE(button->down);
    const auto axis = firstOf<PadAxisEvent>(events);
    ASSERT_TRUE(axis.has_value());
    EXPECT_EQ(axis->axis, PadAxis::LeftY);
    EXPECT_FLOAT_EQ(axis->value, 1) << "up is positive";

    SDL_JoystickDetachVirtual(device);
    events = pollAll(pads);
    const auto gone = firstOf<PadDisconnected>(events);
    ASSERT_TRUE(gone.has_value());
    EXPECT_EQ(gone->pad, pad);
}

TEST(Gamepads, noneIsFine) {
    Gamepads pads;
    EXPECT_TRUE(pollAll(pads).empty());
}

}  // namespace
