#include <SDL.h>
#include <gtest/gtest.h>

#include <atlax/action_recording.hpp>
#include <atlax/actions.hpp>
#include <atlax/error.hpp>
#include <atlax/gamepad.hpp>
#include <atlax/settings.hpp>
#include <cmath>

#include "temporary_folder.hpp"

namespace {

using namespace atlax;

/// A game with a menu, and the input that its ticks see.
class ActionsTest : public testing::Test {
protected:
    Actions actions{{"play", "menu"}};
    const Action left =
        actions.add("left", {"play"}, {Binding::key(Key::A), Binding::axis(PadAxis::LeftX, true)});
    const Action right =
        actions.add("right", {"play"}, {Binding::key(Key::D), Binding::axis(PadAxis::LeftX)});
    const Action fire =
        actions.add("fire", {"play"},
                    {Binding::mouse(MouseButton::Left), Binding::axis(PadAxis::RightTrigger),
                     Binding::pad(PadButton::South)});
    const Action reel =
        actions.add("reel", {"play"}, {Binding::wheel(WheelWay::Up), Binding::key(Key::W)});
    const Action accept = actions.add("accept", {"menu"}, {Binding::mouse(MouseButton::Left)});
    const Action picture = actions.add("picture", {}, {Binding::key(Key::F12)});
    InputSampler input;

    const ActionState& tick() { return actions.sample(input.sample()); }
    void key(Key k, bool down) { input.feed(KeyEvent{.key = k, .down = down}); }
    void click(bool down) { input.feed(MouseButtonEvent{.down = down}); }
    void axis(PadAxis a, float value) { input.feed(PadAxisEvent{0, a, value}); }
};

TEST_F(ActionsTest, keysAndButtonsPressHoldAndRelease) {
    key(Key::D, true);
    EXPECT_TRUE(tick().wasPressed(right));
    EXPECT_TRUE(actions.current().isDown(right));
    EXPECT_EQ(actions.current().value(right), 1);
    EXPECT_FALSE(tick().wasPressed(right));
    EXPECT_TRUE(actions.current().isDown(right));
    key(Key::D, false);
    EXPECT_TRUE(tick().wasReleased(right));
    EXPECT_FALSE(actions.current().isDown(right));
    EXPECT_EQ(tick(), ActionState{});
}

TEST_F(ActionsTest, tapsBetweenTicksAreNotMissed) {
    key(Key::D, true);
    key(Key::D, false);
    EXPECT_TRUE(tick().wasPressed(right));
    EXPECT_TRUE(actions.current().wasReleased(right));
    EXPECT_FALSE(actions.current().isDown(right));
    EXPECT_EQ(tick(), ActionState{});
    key(Key::D, true);
    tick();
    key(Key::D, false);
    key(Key::D, true);
    EXPECT_TRUE(tick().wasPressed(right)) << "let go and pressed again";
    EXPECT_TRUE(actions.current().isDown(right));
}

TEST_F(ActionsTest, twoKeysOfOneActionAreOne) {
    actions.rebind(left, {Binding::key(Key::A), Binding::key(Key::Left)});
    tick();
    key(Key::A, true);
    tick();
    key(Key::Left, true);
    EXPECT_FALSE(tick().wasPressed(left));
    key(Key::A, false);
    EXPECT_FALSE(tick().wasReleased(left));
    EXPECT_TRUE(actions.current().isDown(left));
    key(Key::Left, false);
    EXPECT_TRUE(tick().wasReleased(left));
}

TEST_F(ActionsTest, theWheelCountsNotchesAndKeepsFractions) {
    input.feed(WheelEvent{.notches = {0, 3}});
    EXPECT_EQ(tick().pressCount(reel), 3);
    EXPECT_TRUE(actions.current().wasPressed(reel));
    EXPECT_FALSE(actions.current().isDown(reel));
    EXPECT_EQ(tick().pressCount(reel), 0);
    for (int i = 0; i < 3; ++i) {
        input.feed(WheelEvent{.notches = {0, 0.25f}});
        EXPECT_EQ(tick().pressCount(reel), 0);
    }
    input.feed(WheelEvent{.notches = {0, 0.25f}});
    EXPECT_EQ(tick().pressCount(reel), 1);
    input.feed(WheelEvent{.notches = {0, -2}});
    EXPECT_EQ(tick().pressCount(reel), 0) << "the other way";
}

TEST_F(ActionsTest, sticksHaveADeadZoneAndDoNotFlutter) {
    input.feed(PadConnected{0, "pad"});
    axis(PadAxis::LeftX, 0.15f);
    EXPECT_EQ(tick().value(right), 0);
    axis(PadAxis::LeftX, 0.6f);
    EXPECT_NEAR(tick().value(right), 0.5, 0.003);
    EXPECT_TRUE(actions.current().wasPressed(right));
    axis(PadAxis::LeftX, 0.55f);
    EXPECT_TRUE(tick().isDown(right)) << "not before 0.4";
    axis(PadAxis::LeftX, 0.3f);
    EXPECT_TRUE(tick().wasReleased(right));
    axis(PadAxis::LeftX, -1);
    EXPECT_EQ(tick().axis(left, right), -1);
    actions.setDeadZones(0.5f, 0.5f);
    axis(PadAxis::LeftX, 0.45f);
    axis(PadAxis::RightTrigger, 0.5f);
    EXPECT_EQ(tick().value(right), 0);
    EXPECT_EQ(actions.current().value(fire), 0);
    axis(PadAxis::RightTrigger, 1);
    EXPECT_TRUE(tick().isDown(fire));
    actions.setDeadZones(std::nanf(""), 7);
    EXPECT_EQ(actions.triggerDeadZone(), 0.9f);
}

TEST_F(ActionsTest, contextsDecideWhatActs) {
    click(true);
    EXPECT_TRUE(tick().isDown(fire));
    EXPECT_FALSE(actions.current().isDown(accept));
    actions.setContext("menu");
    EXPECT_TRUE(tick().wasReleased(fire));
    EXPECT_FALSE(actions.current().isDown(accept)) << "the button was held before";
    EXPECT_FALSE(tick().isDown(accept));
    click(false);
    tick();
    click(true);
    EXPECT_TRUE(tick().wasPressed(accept));
    actions.setContext("play");
    EXPECT_FALSE(tick().isDown(fire)) << "the click that closes a menu does not shoot";
    click(false);
    tick();
    click(true);
    EXPECT_TRUE(tick().wasPressed(fire));
    EXPECT_THROW(actions.setContext("editor"), Error);
    EXPECT_EQ(actions.context(), "play");
}

TEST_F(ActionsTest, whatActsEverywhereGoesOnThroughAChange) {
    key(Key::F12, true);
    EXPECT_TRUE(tick().wasPressed(picture));
    actions.setContext("menu");
    EXPECT_TRUE(tick().isDown(picture));
    EXPECT_FALSE(actions.current().wasPressed(picture));
}

TEST_F(ActionsTest, anUnpluggedPadLetsGo) {
    input.feed(PadConnected{0, "pad"});
    input.feed(PadButtonEvent{0, PadButton::South, true});
    axis(PadAxis::LeftX, 1);
    EXPECT_TRUE(tick().isDown(fire));
    input.feed(PadDisconnected{0});
    EXPECT_TRUE(tick().wasReleased(fire));
    EXPECT_TRUE(actions.current().wasReleased(right));
    EXPECT_EQ(actions.current().value(right), 0);
    EXPECT_EQ(tick(), ActionState{});
}

TEST_F(ActionsTest, onePadCanBeChosen) {
    actions.setPad(1);
    input.feed(PadConnected{0, "a"});
    input.feed(PadConnected{1, "b"});
    input.feed(PadButtonEvent{0, PadButton::South, true});
    EXPECT_FALSE(tick().isDown(fire));
    input.feed(PadButtonEvent{1, PadButton::South, true});
    EXPECT_TRUE(tick().isDown(fire));
}

TEST_F(ActionsTest, conflictsAreThoseOfACommonContext) {
    EXPECT_TRUE(actions.conflicts(fire, Binding::mouse(MouseButton::Left)).empty())
        << "the menu's click is another context's";
    EXPECT_EQ(actions.conflicts(fire, Binding::key(Key::W)), std::vector<Action>{reel});
    EXPECT_EQ(actions.conflicts(accept, Binding::key(Key::F12)), std::vector<Action>{picture});
    EXPECT_TRUE(actions.conflicts(reel, Binding::key(Key::W)).empty()) << "it is its own";
}

TEST_F(ActionsTest, bindingsGoThroughSettings) {
    const TemporaryFolder folder;
    Settings settings({.file = folder / "s.json"});
    actions.rebind(fire,
                   {Binding::key(Key::J), Binding::pad(PadButton::East), Binding::key(Key::J)});
    actions.rebind(reel, {});
    actions.setDeadZones(0.3f, 0.25f);
    actions.save(settings);
    EXPECT_FALSE(settings.has("input.left")) << "only what differs is written";
    settings.save();

    Settings read({.file = folder / "s.json"});
    read.load();
    actions.resetBindings();
    actions.setDeadZones(0.2f, 0.1f);
    EXPECT_TRUE(actions.load(read).empty());
    EXPECT_EQ(actions.bindings(fire),
              (std::vector<Binding>{Binding::key(Key::J), Binding::pad(PadButton::East)}));
    EXPECT_TRUE(actions.bindings(reel).empty());
    EXPECT_NEAR(actions.stickDeadZone(), 0.3f, 1e-6f);
    tick();
    key(Key::J, true);
    EXPECT_TRUE(tick().isDown(fire));
}

TEST_F(ActionsTest, settingsThatMakeNoSenseChangeNothing) {
    Settings settings({.file = "/nowhere"});
    settings.set("input.fire", std::vector<std::string>{"key:J", "key:Nonsense"});
    settings.set("input.left", 7);
    settings.set("input.right", std::vector<std::string>(9, "key:J"));
    settings.set("input.stick_dead_zone", 40.0);
    const auto before = actions.bindings(fire);
    const auto problems = actions.load(settings);
    ASSERT_EQ(problems.size(), 3u);
    EXPECT_NE(problems[0].find("input.left"), std::string::npos);
    EXPECT_EQ(actions.bindings(fire), before);
    EXPECT_EQ(actions.bindings(left).size(), 2u);
    EXPECT_EQ(actions.stickDeadZone(), 0.2f);
}

TEST_F(ActionsTest, badCallsAreRefused) {
    EXPECT_THROW(Actions({}), Error);
    EXPECT_THROW(Actions({"a", "a"}), Error);
    EXPECT_THROW(actions.add("fire", {}, {}), Error);
    EXPECT_THROW(actions.add("Fire!", {}, {}), Error);
    EXPECT_THROW(actions.add("jump", {"nowhere"}, {}), Error);
    EXPECT_THROW(actions.bindings(99), Error);
    EXPECT_THROW(actions.rebind(99, {}), Error);
    std::vector<Binding> many;
    for (int i = 1; i < 10; ++i) many.push_back(Binding::key(static_cast<Key>(i)));
    EXPECT_THROW(actions.rebind(fire, many), Error);
    EXPECT_EQ(actions.bindings(fire).size(), 3u);
    for (std::size_t i = actions.count(); i < maxActions; ++i)
        actions.add("a" + std::to_string(i), {}, {});
    EXPECT_THROW(actions.add("one_more", {}, {}), Error);
}

/// A pad that exists only inside of SDL.
class VirtualPad {
public:
    VirtualPad() {
        SDL_VirtualJoystickDesc description{};
        description.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
        description.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
        description.naxes = SDL_CONTROLLER_AXIS_MAX;
        description.nbuttons = SDL_CONTROLLER_BUTTON_MAX;
        description.name = "virtual pad";
        device_ = SDL_JoystickAttachVirtualEx(&description);
    }
    ~VirtualPad() { unplug(); }
    VirtualPad(const VirtualPad&) = delete;
    VirtualPad& operator=(const VirtualPad&) = delete;

    bool exists() const { return device_ >= 0; }
    void button(SDL_GameControllerButton b, bool down) {
        SDL_JoystickSetVirtualButton(joystick(), b, down ? 1 : 0);
    }
    void axis(SDL_GameControllerAxis a, float value) {
        SDL_JoystickSetVirtualAxis(joystick(), a, static_cast<Sint16>(value * 32767));
    }
    void unplug() {
        if (device_ >= 0) SDL_JoystickDetachVirtual(device_);
        device_ = -1;
    }

private:
    SDL_Joystick* joystick() const {
        return SDL_JoystickFromInstanceID(SDL_JoystickGetDeviceInstanceID(device_));
    }
    int device_ = -1;
};

TEST_F(ActionsTest, aVirtualPadPlaysIsUnpluggedAndTheRecordingReplaysExactly) {
    Gamepads pads;
    VirtualPad pad;
    if (!pad.exists()) GTEST_SKIP() << "SDL has no virtual joysticks here: " << SDL_GetError();
    ActionRecording recording;
    std::vector<ActionState> seen;
    const auto ticks = [&](int count) {
        pads.poll([&](const Event& e) { input.feed(e); });
        for (int i = 0; i < count; ++i) {
            seen.push_back(tick());
            recording.append(seen.back());
        }
    };
    ticks(10);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1);
    for (int i = 0; i <= 20; ++i) {
        pad.axis(SDL_CONTROLLER_AXIS_LEFTX, static_cast<float>(i) / 20);
        ticks(3);
    }
    EXPECT_EQ(seen.back().value(right), 1);
    pad.button(SDL_CONTROLLER_BUTTON_A, true);
    ticks(100);
    EXPECT_TRUE(seen.back().isDown(fire));
    pad.unplug();
    ticks(5);
    EXPECT_TRUE(seen[seen.size() - 5].wasReleased(fire));
    EXPECT_TRUE(seen[seen.size() - 5].wasReleased(right));
    EXPECT_EQ(seen.back(), ActionState{});
    // Plugged in again it plays on.
    VirtualPad again;
    ticks(2);
    again.button(SDL_CONTROLLER_BUTTON_A, true);
    ticks(2);
    EXPECT_TRUE(seen.back().isDown(fire));

    const auto read = ActionRecording::decode(recording.encode(), 1000);
    ActionPlayback playback(read);
    for (const ActionState& state : seen) ASSERT_EQ(playback.next(), state);
    EXPECT_TRUE(playback.done());
}

TEST(Gamepads, theDatabaseCanBeExtended) {
    Gamepads pads;
    EXPECT_EQ(pads.addMappings(""), 0);
    EXPECT_EQ(pads.addMappings("nonsense\n"), 0);
    EXPECT_EQ(
        pads.addMappings("03000000aaaa0000bbbb000000010000,Test Pad,a:b0,b:b1,leftx:a0,lefty:a1,"
                         "platform:Linux,\n"),
        1);
    EXPECT_EQ(pads.addMappings("03000000aaaa0000cccc000000010000,Other,a:b0,platform:Windows,\n"),
              0);
}

}  // namespace
