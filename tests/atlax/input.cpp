#include <gtest/gtest.h>

#include <atlax/input.hpp>

namespace {

using namespace atlax;

TEST(Input, edgesAreSeenByOneTickAndHoldingByAll) {
    InputSampler sampler;
    sampler.feed(KeyEvent{.key = Key::W, .down = true});
    EXPECT_TRUE(sampler.sample().wasPressed(Key::W));
    EXPECT_TRUE(sampler.current().isDown(Key::W));
    EXPECT_FALSE(sampler.sample().wasPressed(Key::W));
    EXPECT_TRUE(sampler.current().isDown(Key::W));
    sampler.feed(KeyEvent{.key = Key::W, .down = false});
    EXPECT_TRUE(sampler.sample().wasReleased(Key::W));
    EXPECT_FALSE(sampler.current().isDown(Key::W));
}

TEST(Input, aTapBetweenTwoTicksIsNotMissed) {
    InputSampler sampler;
    sampler.feed(MouseButtonEvent{.down = true, .position = {3, 4}});
    sampler.feed(MouseButtonEvent{.down = false, .position = {3, 4}});
    const InputState& state = sampler.sample();
    EXPECT_TRUE(state.wasPressed(MouseButton::Left));
    EXPECT_TRUE(state.wasReleased(MouseButton::Left));
    EXPECT_FALSE(state.isDown(MouseButton::Left));
    EXPECT_EQ(state.mouse, Vec2(3, 4));
}

TEST(Input, autoRepeatIsNotAPress) {
    InputSampler sampler;
    sampler.feed(KeyEvent{.key = Key::A, .down = true});
    sampler.sample();
    sampler.feed(KeyEvent{.key = Key::A, .down = true, .repeat = true});
    EXPECT_FALSE(sampler.sample().wasPressed(Key::A));
}

TEST(Input, wheelAndMovementAddUpPerTick) {
    InputSampler sampler;
    sampler.feed(WheelEvent{.notches = {0, 1}});
    sampler.feed(WheelEvent{.notches = {0, 2}});
    sampler.feed(MouseMoved{{10, 0}});
    sampler.feed(MouseMoved{{15, 5}});
    EXPECT_EQ(sampler.sample().wheel, Vec2(0, 3));
    EXPECT_EQ(sampler.current().mouseDelta, Vec2(15, 5));
    EXPECT_EQ(sampler.sample().wheel, Vec2(0, 0));
    EXPECT_EQ(sampler.current().mouse, Vec2(15, 5));
}

TEST(Input, lostFocusLetsGoOfEverything) {
    InputSampler sampler;
    sampler.feed(PadConnected{1, "pad"});
    sampler.feed(KeyEvent{.key = Key::D, .down = true});
    sampler.feed(PadButtonEvent{1, PadButton::South, true});
    sampler.feed(PadAxisEvent{1, PadAxis::LeftX, 1});
    sampler.sample();
    sampler.feed(FocusChanged{false});
    const InputState& state = sampler.sample();
    EXPECT_TRUE(state.wasReleased(Key::D));
    EXPECT_FALSE(state.isDown(Key::D));
    EXPECT_TRUE(state.pads[1].wasReleased(PadButton::South));
    EXPECT_EQ(state.pads[1].axis(PadAxis::LeftX), 0);
    EXPECT_FALSE(state.focused);
}

/// How often a key is pressed in a frame of so many ticks, and in which tick last.
struct Presses {
    int count = 0;
    int last = -1;
};
Presses framePresses(InputQueue& queue, InputSampler& sampler, int ticks) {
    Presses out;
    for (int tick = 0; tick < ticks; ++tick) {
        queue.feed(sampler, tick, ticks);
        if (!sampler.sample().wasPressed(Key::Down)) continue;
        ++out.count;
        out.last = tick;
    }
    queue.endFrame();
    return out;
}

TEST(InputQueue, everyPressOfASlowFrameCounts) {
    InputSampler sampler;
    InputQueue queue;
    for (int i = 0; i < 3; ++i) {
        queue.add(KeyEvent{.key = Key::Down, .down = true});
        queue.add(KeyEvent{.key = Key::Down, .down = false});
    }
    // A tenth of a second at 500 Hz.
    const Presses presses = framePresses(queue, sampler, 50);
    EXPECT_EQ(presses.count, 3);
    EXPECT_EQ(presses.last, 33) << "spread over the frame";
    EXPECT_FALSE(sampler.current().isDown(Key::Down));
}

TEST(InputQueue, whatFindsNoTickWaitsForTheNextFrame) {
    InputSampler sampler;
    InputQueue queue;
    for (int i = 0; i < 3; ++i) {
        queue.add(KeyEvent{.key = Key::Down, .down = true});
        queue.add(KeyEvent{.key = Key::Down, .down = false});
    }
    int presses = 0;
    for (int frame = 0; frame < 6; ++frame) presses += framePresses(queue, sampler, 1).count;
    EXPECT_EQ(presses, 3);
    EXPECT_EQ(framePresses(queue, sampler, 1).count, 0);
}

TEST(InputQueue, differentKeysComeTogetherAndRepeatsMakeNoPress) {
    InputSampler sampler;
    InputQueue queue;
    queue.add(KeyEvent{.key = Key::W, .down = true});
    queue.add(MouseButtonEvent{.down = true, .position = {3, 4}});
    queue.add(KeyEvent{.key = Key::W, .down = true, .repeat = true});
    queue.add(PadConnected{0, "pad"});
    queue.add(PadAxisEvent{0, PadAxis::RightTrigger, 0.2f});
    queue.add(PadAxisEvent{0, PadAxis::RightTrigger, 0.4f});
    queue.feed(sampler, 0, 8);
    EXPECT_TRUE(sampler.sample().wasPressed(Key::W));
    EXPECT_TRUE(sampler.current().wasPressed(MouseButton::Left));
    EXPECT_EQ(sampler.current().pads[0].axis(PadAxis::RightTrigger), 0.4f);
}

TEST(InputQueue, aTriggerThatIsPulledAndLetGoIsSeenPulled) {
    InputSampler sampler;
    InputQueue queue;
    queue.add(PadConnected{0, "pad"});
    queue.add(PadAxisEvent{0, PadAxis::RightTrigger, 1});
    queue.add(PadAxisEvent{0, PadAxis::RightTrigger, 0});
    queue.feed(sampler, 0, 8);
    EXPECT_EQ(sampler.sample().pads[0].axis(PadAxis::RightTrigger), 1);
    queue.feed(sampler, 4, 8);
    EXPECT_EQ(sampler.sample().pads[0].axis(PadAxis::RightTrigger), 0);
}

TEST(Input, sticksHaveARoundDeadZone) {
    PadState pad;
    pad.axes = {0.1f, 0.1f, 0, 1, 0, 0};
    EXPECT_EQ(pad.leftStick(0.2f), Vec2(0, 0));
    EXPECT_NEAR(pad.rightStick(0.2f).y, 1, 1e-6f);
    pad.axes = {1, 1, 0.6f, 0, 0, 0};
    EXPECT_NEAR(length(pad.leftStick()), 1, 1e-6f);
    EXPECT_NEAR(pad.rightStick(0.2f).x, 0.5f, 1e-6f);
}

TEST(Input, padsOutOfRangeAreIgnored) {
    InputSampler sampler;
    sampler.feed(PadConnected{-1, "x"});
    sampler.feed(PadButtonEvent{maxPads, PadButton::South, true});
    sampler.feed(PadAxisEvent{99, PadAxis::LeftX, 1});
    for (const PadState& pad : sampler.sample().pads) EXPECT_FALSE(pad.connected);
}

TEST(Keys, namesGoThereAndBack) {
    for (int i = 1; i < keyCount; ++i) {
        const auto key = static_cast<Key>(i);
        EXPECT_EQ(keyFromName(keyName(key)), key) << keyName(key);
    }
    EXPECT_EQ(keyName(Key::W), "W");
    EXPECT_EQ(keyName(Key::Left), "Left");
    EXPECT_EQ(keyName(Key::PadEnter), "PadEnter");
    EXPECT_EQ(keyFromName("no such key"), Key::Unknown);
}

}  // namespace
