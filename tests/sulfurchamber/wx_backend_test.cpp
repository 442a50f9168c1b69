// The backend on wxWidgets, in a real window under xvfb-run. Every case is a process of its own
// (see CMakeLists.txt), as a program starts wxWidgets once.
#include <gtest/gtest.h>
#include <wx/app.h>
#include <wx/frame.h>

#include <atlax/backend.hpp>
#include <atlax/image.hpp>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "../atlax/lost_driver.hpp"
#include "../atlax/scripted_app.hpp"
#include "../atlax/virtual_pad.hpp"

namespace {

using namespace atlax;

WindowOptions small() {
    WindowOptions options;
    options.title = "atlax test";
    options.size = {320, 240};
    options.vsync = false;
    return options;
}

wxWindow* view() {
    return wxTheApp->GetTopWindow()->GetChildren().front();
}

void pushMouse(wxEventType type, int x, int y) {
    wxMouseEvent event(type);
    event.m_x = x;
    event.m_y = y;
    wxQueueEvent(view(), event.Clone());
}

void pushKey(wxEventType type, int code) {
    wxKeyEvent event(type);
    event.m_keyCode = code;
    event.m_uniChar = code;
    wxQueueEvent(view(), event.Clone());
}

TEST(WxBackend, TicksDrawsAndWritesAPicture) {
    const auto file = std::filesystem::path(testing::TempDir()) / "atlax_wx_shot.png";
    std::filesystem::remove(file);
    ScriptedApp app;
    app.onTick = [&] {
        if (app.ticks == 50) app.platform->requestScreenshot(file);
        if (std::filesystem::exists(file) || app.ticks > 20000) app.platform->quit(3);
    };
    EXPECT_EQ(run(app, small()), 3);
    EXPECT_EQ(app.stops, 1);
    EXPECT_TRUE(app.alphaInRange);
    const Image image = loadImage(file);
    EXPECT_EQ(image.size(), (PixelSize{320, 240}));
    EXPECT_EQ(image.pixel(160, 120), (std::array<std::uint8_t, 4>{0xFF, 0xB3, 0x47, 255}));
    EXPECT_EQ(image.pixel(5, 5), (std::array<std::uint8_t, 4>{0x0B, 0x10, 0x26, 255}));
    std::filesystem::remove(file);
}

TEST(WxBackend, MouseKeysAndTextArrive) {
    ScriptedApp app;
    app.onStart = [&] { app.platform->setTextInput(true); };
    app.onTick = [&] {
        if (app.ticks == 10) {
            pushMouse(wxEVT_MOTION, 30, 40);
            pushMouse(wxEVT_RIGHT_DOWN, 31, 41);
            pushMouse(wxEVT_RIGHT_UP, 31, 41);
            pushKey(wxEVT_KEY_DOWN, 'W');
            pushKey(wxEVT_KEY_DOWN, 'W');
            pushKey(wxEVT_CHAR, L'\u00E9');
        }
        if (app.last<TextEvent>() || app.ticks > 5000) app.platform->quit();
    };
    EXPECT_EQ(run(app, small()), 0);
    ASSERT_TRUE(app.last<TextEvent>());
    EXPECT_EQ(app.last<TextEvent>()->utf8, "\xC3\xA9");
    int presses = 0;
    int repeats = 0;
    bool rightWentDown = false;
    for (const Event& event : app.events) {
        if (const auto* key = std::get_if<KeyEvent>(&event); key && key->key == Key::W && key->down)
            ++(key->repeat ? repeats : presses);
        if (const auto* button = std::get_if<MouseButtonEvent>(&event))
            rightWentDown = rightWentDown || (button->button == MouseButton::Right &&
                                              button->down && button->position == Vec2(31, 41));
    }
    EXPECT_EQ(presses, 1);
    EXPECT_EQ(repeats, 1) << "the second press without a release is the keyboard's repeat";
    EXPECT_TRUE(rightWentDown);
}

/// Says that nothing moves in its picture.
class RestingApp : public ScriptedApp {
public:
    bool atRest() const override { return rests; }
    bool rests = true;
};

TEST(WxBackend, WhatIsAtRestDrawsSeldomUntilSomethingHappens) {
    RestingApp app;
    std::int64_t began = 0, pushed = 0, answered = 0;
    int before = 0, resting = 0, soon = 0;
    const auto milliseconds = [](std::int64_t ns) { return ns / 1'000'000; };
    app.onTick = [&] {
        const std::int64_t now = monotonicNs();
        if (began == 0) began = now;
        const auto gone = milliseconds(now - began);
        if (gone < 1500) before = app.draws;
        if (pushed == 0 && gone >= 3500) {
            resting = app.draws - before;
            pushed = now;
            wxTheApp->CallAfter([] { pushMouse(wxEVT_MOTION, 30, 40); });
        }
        if (pushed != 0 && answered == 0 && app.last<MouseMoved>()) answered = app.draws;
        if (pushed != 0 && milliseconds(now - pushed) < 150) soon = app.draws;
        // Half a second of frames follows what has happened.
        if (gone >= 4500) app.platform->quit();
    };
    EXPECT_EQ(run(app, small()), 0);
    EXPECT_GE(resting, 4);
    EXPECT_LE(resting, 12) << "five a second";
    ASSERT_GT(answered, 0);
    EXPECT_GE(soon - answered, 2) << "the first frames after an event follow each other";
    EXPECT_GE(app.draws - answered, 14) << "those after an event, where others are at rest";
}

TEST(WxBackend, WhatMovesDrawsAsOftenAsItCan) {
    RestingApp app;
    app.rests = false;
    app.onTick = [&] {
        if (app.ticks == 1500) app.platform->quit();
    };
    EXPECT_EQ(run(app, small()), 0);
    EXPECT_GE(app.draws, 24);
}

TEST(WxBackend, TheApplicationMayRefuseToClose) {
    ScriptedApp app;
    app.refuseCloses = 1;
    app.onTick = [&] {
        if (app.ticks == 10 || app.ticks == 60)
            wxTheApp->CallAfter([] { wxTheApp->GetTopWindow()->Close(); });
        if (app.ticks > 20000) app.platform->quit(9);
    };
    EXPECT_EQ(run(app, small()), 0);
    EXPECT_EQ(app.closeRequests, 2);
    EXPECT_EQ(app.stops, 1);
}

TEST(WxBackend, SmallAndLargeAgain) {
    ScriptedApp app;
    app.onTick = [&] {
        if (app.ticks == 10) app.platform->setWindowSize({64, 64});
        if (app.ticks == 200) app.platform->setWindowSize({400, 300});
        const bool back = app.platform->size() == PixelSize{400, 300};
        if (back || app.ticks > 20000) app.platform->quit(back ? 0 : 9);
    };
    EXPECT_EQ(run(app, small()), 0);
}

TEST(WxBackend, AnErrorEndsTheProgramWithItsText) {
    ScriptedApp app;
    app.onTick = [&] {
        if (app.ticks == 5) throw std::runtime_error("the tick failed on purpose");
    };
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(app, small()), 1);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("the tick failed on purpose"),
              std::string::npos);
    EXPECT_EQ(app.stops, 1);
}

/// Makes its pictures again: it has none.
class RestorableApp : public ScriptedApp {
public:
    bool restoreGraphics() override {
        ++restored;
        return true;
    }
    int restored = 0;
};

TEST(WxBackend, APadComesAndGoes) {
    expectAPadToComeAndGo([](Application& app) { return run(app, small()); });
}

TEST(WxBackend, ALostContextIsMadeAgain) {
    const auto file = std::filesystem::path(testing::TempDir()) / "atlax_wx_restored.png";
    std::filesystem::remove(file);
    const LostDriver driver;
    RestorableApp app;
    app.onDraw = [&](Canvas&) {
        if (app.draws == 5) LostDriver::lose();
        if (app.draws == 10) app.platform->requestScreenshot(file);
        if (app.draws == 12) app.platform->quit();
    };
    EXPECT_EQ(run(app, small()), 0);
    EXPECT_EQ(app.restored, 1);
    EXPECT_EQ(loadImage(file).pixel(160, 120),
              (std::array<std::uint8_t, 4>{0xFF, 0xB3, 0x47, 255}));
    std::filesystem::remove(file);
}

TEST(WxBackend, OldOpenGlIsRefusedWithARemedy) {
    setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
    ScriptedApp app;
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(app, small()), 1);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("OpenGL 3.3 core"), std::string::npos);
    EXPECT_EQ(app.ticks, 0);
    EXPECT_EQ(app.stops, 0);
}

TEST(WxBackend, NoDisplayIsRefusedWithARemedy) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    ScriptedApp app;
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(app, small()), 1);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("no display"), std::string::npos);
}

TEST(WxBackend, OffscreenNeedsNoDisplay) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    ScriptedApp app;
    WindowOptions options = small();
    options.offscreen = true;
    app.onTick = [&] {
        if (app.ticks == 100) app.platform->quit(4);
    };
    EXPECT_EQ(run(app, options), 4);
}

}  // namespace
