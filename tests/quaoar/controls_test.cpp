// From keys, mouse and gamepad through the player's actions to the inputs of a tick.
#include <gtest/gtest.h>

#include <algorithm>
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
    TickInput tick(bool roped = false) {
        const atlax::ActionState& state = actions.all.sample(sampler.sample());
        return controls.read(state, sampler.current(), {{{0, 0}, 10}, {200, 100}, {}, roped});
    }
    /// As the game does while a menu is open.
    void rest(bool countIn = false) {
        actions.all.sample(sampler.sample());
        controls.rest(sampler.current(), countIn);
    }
    void pause() {
        controls.pause();
        actions.all.setContext("menu");
        rest();
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
    EXPECT_LT(input.aimX, 0);
    EXPECT_EQ(input.aimY, 0);
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

TEST_F(ControlsTest, theRopeHoldsThroughAPauseUntilTheButtonIsLetGo) {
    mouse(true, {50, 50});
    EXPECT_TRUE(tick().fire);
    pause();
    rest();
    rest(true);
    actions.all.setContext("play");
    EXPECT_TRUE(tick().fire);
    EXPECT_TRUE(tick().fire);
    mouse(false, {50, 50});
    EXPECT_FALSE(tick().fire);
    mouse(true, {50, 50});
    EXPECT_TRUE(tick().fire) << "and fires anew";
}

TEST_F(ControlsTest, aRopeWhoseButtonWasLetGoInThePauseHangsOn) {
    mouse(true, {50, 50});
    tick();
    pause();
    mouse(false, {50, 50});
    rest();
    mouse(true, {60, 60});  // the click on "Go on"
    rest();
    actions.all.setContext("play");
    EXPECT_TRUE(tick().fire);
    mouse(false, {60, 60});
    EXPECT_TRUE(tick().fire) << "the end of that click lets nothing go";
    mouse(true, {60, 60});
    EXPECT_TRUE(tick().fire) << "taken in hand again";
    mouse(false, {60, 60});
    EXPECT_FALSE(tick().fire);
}

TEST_F(ControlsTest, theButtonMayBeTakenInHandDuringTheCountIn) {
    mouse(true, {50, 50});
    tick();
    pause();
    sampler.feed(atlax::FocusChanged{false});
    rest();
    sampler.feed(atlax::FocusChanged{true});
    rest(true);
    mouse(true, {50, 50});
    rest(true);
    actions.all.setContext("play");
    EXPECT_TRUE(tick().fire);
    mouse(false, {50, 50});
    EXPECT_FALSE(tick().fire);
}

TEST_F(ControlsTest, aNewAttemptHoldsNothing) {
    mouse(true, {50, 50});
    tick();
    pause();
    mouse(false, {50, 50});
    rest();
    controls.reset();
    actions.all.setContext("play");
    EXPECT_FALSE(tick().fire);
}

TEST_F(ControlsTest, onePressFiresAndTheNextLetsGoWhereThePlayerWantsSo) {
    controls.setToggle(true);
    const auto press = [&](bool roped) {
        mouse(true, {50, 50});
        const bool fire = tick(roped).fire;
        mouse(false, {50, 50});
        EXPECT_EQ(tick(roped).fire, fire);
        return fire;
    };
    EXPECT_TRUE(press(true));
    EXPECT_FALSE(press(true));
    EXPECT_TRUE(press(true));
    EXPECT_FALSE(tick(false).fire) << "the rope has missed";
    EXPECT_TRUE(press(false)) << "so the next press fires";
}

TEST_F(ControlsTest, keysAreSwappedAndNothingEssentialIsLost) {
    using atlax::Binding;
    const Binding space = Binding::key(Key::Space), w = Binding::key(Key::W);
    const Binding left = Binding::mouse(atlax::MouseButton::Left);
    EXPECT_FALSE(actions.owner(actions.fire, space)) << "menus do not count";
    actions.bind(actions.fire, space, left);
    EXPECT_EQ(actions.all.bindings(actions.fire).front(), space);
    // What the issue tells: Space to fire, then Space to reel in.
    EXPECT_EQ(actions.owner(actions.reelIn, space), actions.fire);
    EXPECT_TRUE(actions.canBind(actions.reelIn, space, w));
    EXPECT_FALSE(actions.canBind(actions.reelIn, space)) << "fire would have no key";
    actions.bind(actions.reelIn, space);
    EXPECT_EQ(actions.all.bindings(actions.fire).front(), space) << "refused";
    actions.bind(actions.reelIn, space, w);
    EXPECT_EQ(actions.all.bindings(actions.reelIn).front(), space);
    EXPECT_EQ(actions.all.bindings(actions.fire).front(), w) << "swapped";
    EXPECT_FALSE(actions.unbind(actions.fire, w)) << "its last key";
    EXPECT_TRUE(actions.unbind(actions.reelIn, space)) << "it has others";
    actions.bind(actions.fire, Binding::key(Key::J));
    EXPECT_EQ(actions.all.bindings(actions.fire).size(), 3u) << "several keys";
}

TEST_F(ControlsTest, whateverIsBoundEssentialActionsKeepAKeyAndAButton) {
    using atlax::Binding;
    std::vector<Binding> all;
    for (int key = 1; key < 30; ++key) all.push_back(Binding::key(static_cast<Key>(key)));
    for (int i = 0; i < atlax::padButtonCount; ++i)
        all.push_back(Binding::pad(static_cast<atlax::PadButton>(i)));
    std::uint32_t dice = 1;
    const auto roll = [&](std::size_t sides) {
        dice = dice * 1664525u + 1013904223u;
        return (dice >> 8) % sides;
    };
    for (int n = 0; n < 3000; ++n) {
        const auto action = static_cast<atlax::Action>(roll(PlayerActions::changeable));
        const auto& mine = actions.all.bindings(action);
        const bool instead = roll(2) == 0 && !mine.empty();
        const auto old = instead ? std::optional(mine[roll(mine.size())]) : std::nullopt;
        if (roll(4) == 0 && old)
            actions.unbind(action, *old);
        else
            actions.bind(action, all[roll(all.size())], old);
        for (const atlax::Action must : {actions.fire, actions.reelIn, actions.pause}) {
            const auto& left = actions.all.bindings(must);
            const auto pads = std::count_if(left.begin(), left.end(), ofPad);
            ASSERT_GT(pads, 0);
            ASSERT_LT(static_cast<std::size_t>(pads), left.size());
        }
    }
}

TEST_F(ControlsTest, settingsWithoutAKeyForFireAreMended) {
    actions.all.rebind(actions.fire, {});
    actions.mend();
    EXPECT_EQ(actions.all.bindings(actions.fire).size(), 2u);
    actions.all.rebind(actions.fire, {atlax::Binding::key(Key::F)});
    actions.mend();
    EXPECT_EQ(actions.all.bindings(actions.fire).front(), atlax::Binding::key(Key::F));
    EXPECT_TRUE(ofPad(actions.all.bindings(actions.fire).back()));
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
