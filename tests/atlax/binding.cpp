#include <gtest/gtest.h>

#include <atlax/binding.hpp>

namespace {

using namespace atlax;

TEST(Binding, everyOneGoesThereAndBackAsText) {
    std::vector<Binding> all;
    for (int i = 1; i < keyCount; ++i) all.push_back(Binding::key(static_cast<Key>(i)));
    for (int i = 0; i < mouseButtonCount; ++i)
        all.push_back(Binding::mouse(static_cast<MouseButton>(i)));
    for (int i = 0; i < 4; ++i) all.push_back(Binding::wheel(static_cast<WheelWay>(i)));
    for (int i = 0; i < padButtonCount; ++i) all.push_back(Binding::pad(static_cast<PadButton>(i)));
    for (int i = 0; i < padAxisCount; ++i) {
        all.push_back(Binding::axis(static_cast<PadAxis>(i)));
        if (i < 4) all.push_back(Binding::axis(static_cast<PadAxis>(i), true));
    }
    for (const Binding& b : all) EXPECT_EQ(Binding::parse(b.text()), b) << b.text();
    EXPECT_EQ(Binding::axis(PadAxis::LeftX, true).text(), "axis:LeftX-");
}

TEST(Binding, otherTextsAreNone) {
    for (const char* text :
         {"", "W", "key:", "key:w", "key:Unknown", "mouse:Nose", "wheel:", "pad:A",
          "axis:", "axis:LeftX", "axis:LeftTrigger-", "axis:Up+", ":", "tail:W"})
        EXPECT_FALSE(Binding::parse(text)) << text;
}

TEST(Binding, whatTheUserPressesIsCaptured) {
    EXPECT_EQ(Binding::captured(KeyEvent{.key = Key::J, .down = true}), Binding::key(Key::J));
    EXPECT_FALSE(Binding::captured(KeyEvent{.key = Key::J, .down = false}));
    EXPECT_FALSE(Binding::captured(KeyEvent{.key = Key::J, .down = true, .repeat = true}));
    EXPECT_EQ(Binding::captured(MouseButtonEvent{.button = MouseButton::Right, .down = true}),
              Binding::mouse(MouseButton::Right));
    EXPECT_EQ(Binding::captured(WheelEvent{.notches = {0, -1}}), Binding::wheel(WheelWay::Down));
    EXPECT_EQ(Binding::captured(PadButtonEvent{0, PadButton::East, true}),
              Binding::pad(PadButton::East));
    EXPECT_EQ(Binding::captured(PadAxisEvent{0, PadAxis::LeftY, -0.9f}),
              Binding::axis(PadAxis::LeftY, true));
    EXPECT_FALSE(Binding::captured(PadAxisEvent{0, PadAxis::LeftY, -0.3f})) << "a stick at rest";
    EXPECT_FALSE(Binding::captured(MouseMoved{}));
}

}  // namespace
