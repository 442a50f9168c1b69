// From keys, mouse and gamepad through the player's actions to the inputs of a tick.
#include <gtest/gtest.h>

#include <quaoar/view/controls.hpp>

namespace quaoar::test {
namespace {

using atlax::Key;

class ControlsTest : public testing::Test {
protected:
    /// In the first tick of a context nothing acts yet.
    void SetUp() override {
        actions.all.setContext("play");
        tick();
    }

    void key(Key key, bool down) { sampler.feed(atlax::KeyEvent{.key = key, .down = down}); }
    void mouse(bool down, atlax::Vec2 at) {
        sampler.feed(atlax::MouseButtonEvent{atlax::MouseButton::Left, down, at});
    }
    void axis(atlax::PadAxis axis, float value) {
        sampler.feed(atlax::PadConnected{0, "pad"});
        sampler.feed(atlax::PadAxisEvent{0, axis, value});
    }
    /// The hero stands in the middle of a screen of 200 x 100 pixels.
    TickInput tick() {
        return controls.read(actions.all.sample(sampler.sample()), {{0, 0}, 10}, {200, 100}, {});
    }

    atlax::InputSampler sampler;
    PlayerActions actions;
    Controls controls{actions};
};

TEST_F(ControlsTest, keysReelPushAndRestart) {
    key(Key::W, true);
    key(Key::LeftShift, true);
    key(Key::D, true);
    key(Key::R, true);
    TickInput input = tick();
    EXPECT_TRUE(input.reelIn && input.boost && input.restart && !input.reelOut && !input.fire);
    EXPECT_EQ(input.push, 127);
    input = tick();
    EXPECT_FALSE(input.restart) << "once a press";
    EXPECT_TRUE(input.reelIn);
    key(Key::A, true);
    EXPECT_EQ(tick().push, 0) << "both ways at once";
}

TEST_F(ControlsTest, theMouseAimsAndFires) {
    mouse(true, {150, 20});
    const TickInput input = tick();
    EXPECT_TRUE(input.fire);
    EXPECT_GT(input.aimX, 0);
    EXPECT_GT(input.aimY, 0) << "up, though pixels count down";
    EXPECT_TRUE(controls.mouseAims());
    mouse(false, {150, 20});
    EXPECT_FALSE(tick().fire);
}

TEST_F(ControlsTest, aStickAimsUntilTheMouseMoves) {
    tick();
    axis(atlax::PadAxis::RightX, -1);
    axis(atlax::PadAxis::RightTrigger, 1);
    const TickInput input = tick();
    EXPECT_TRUE(input.fire);
    EXPECT_EQ(input.aimX, -32767);
    EXPECT_FALSE(controls.mouseAims());
    axis(atlax::PadAxis::RightX, 0);
    tick();
    EXPECT_FALSE(controls.mouseAims());
    sampler.feed(atlax::MouseMoved{{10, 10}});
    tick();
    EXPECT_TRUE(controls.mouseAims());
}

TEST_F(ControlsTest, aNotchOfTheWheelReelsForAWhile) {
    sampler.feed(atlax::WheelEvent{{0, 1}});
    int reeled = 0;
    for (int i = 0; i < 200; ++i) reeled += tick().reelIn ? 1 : 0;
    EXPECT_EQ(reeled, 40);
}

TEST_F(ControlsTest, theClickThatClosesAMenuDoesNotFire) {
    actions.all.setContext("menu");
    tick();
    mouse(true, {50, 50});
    tick();
    actions.all.setContext("play");
    EXPECT_FALSE(tick().fire);
    mouse(false, {50, 50});
    EXPECT_FALSE(tick().fire);
    mouse(true, {50, 50});
    EXPECT_TRUE(tick().fire);
}

TEST_F(ControlsTest, anActionThatIsBoundAnewLeavesItsOldKey) {
    actions.all.rebind(actions.reelIn, {atlax::Binding::key(Key::I)});
    key(Key::W, true);
    EXPECT_FALSE(tick().reelIn);
    key(Key::I, true);
    EXPECT_TRUE(tick().reelIn);
}

}  // namespace
}  // namespace quaoar::test
