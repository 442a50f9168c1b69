// The SDL backend, driven by synthetic events of SDL. Runs on SDL's offscreen driver and, under
// xvfb-run, in a real X window; CMakeLists.txt chooses by SDL_VIDEODRIVER.
#include <SDL.h>
#include <gtest/gtest.h>

#include <atlax/image.hpp>
#include <chrono>
#include <thread>

#include "lost_driver.hpp"
#include "scripted_app.hpp"
#include "temporary_folder.hpp"
#include "virtual_pad.hpp"

namespace {

using namespace atlax;

WindowOptions small() {
    WindowOptions options;
    options.title = "atlax test";
    options.size = {320, 240};
    options.vsync = false;
    return options;
}

void pushKey(SDL_Scancode code, bool down) {
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.state = down ? SDL_PRESSED : SDL_RELEASED;
    event.key.keysym.scancode = code;
    SDL_PushEvent(&event);
}

void pushButton(int x, int y, bool down) {
    SDL_Event event{};
    event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
    event.button.button = SDL_BUTTON_LEFT;
    event.button.state = down ? SDL_PRESSED : SDL_RELEASED;
    event.button.clicks = 1;
    event.button.x = x;
    event.button.y = y;
    SDL_PushEvent(&event);
}

void pushWheel(int notches) {
    SDL_Event event{};
    event.type = SDL_MOUSEWHEEL;
    event.wheel.y = notches;
    SDL_PushEvent(&event);
}

TEST(SdlApp, runsTicksAndDrawsItsWindow) {
    const TemporaryFolder folder;
    ScriptedApp app;
    app.onTick = [&] {
        if (app.ticks == 20) app.platform->requestScreenshot(folder / "shot.png");
        if (app.ticks == 100) app.platform->quit(3);
    };
    EXPECT_EQ(run(app, small()), 3);
    EXPECT_EQ(app.ticks, 100);
    EXPECT_GT(app.draws, 0);
    EXPECT_EQ(app.stops, 1);
    EXPECT_TRUE(app.alphaInRange);
    const Image shot = loadImage(folder / "shot.png");
    ASSERT_EQ(shot.size(), (PixelSize{320, 240}));
    EXPECT_EQ(shot.pixel(160, 120), (std::array<std::uint8_t, 4>{0xFF, 0xB3, 0x47, 255}));
    EXPECT_EQ(shot.pixel(1, 1), (std::array<std::uint8_t, 4>{0x0B, 0x10, 0x26, 255}));
}

TEST(SdlApp, keyboardMouseAndWheelArrive) {
    ScriptedApp app;
    bool key = false;
    bool click = false;
    float wheel = 0;
    app.onTick = [&] {
        const InputState& input = app.platform->input();
        key = key || input.wasPressed(Key::W);
        if (input.wasPressed(MouseButton::Left)) click = input.mouse == Vec2(12, 34);
        wheel += input.wheel.y;
        if (app.ticks == 10) {
            pushKey(SDL_SCANCODE_W, true);
            pushButton(12, 34, true);
            pushWheel(-2);
        }
        if (app.ticks == 60) pushKey(SDL_SCANCODE_W, false);
        if (app.ticks == 120) app.platform->quit();
    };
    EXPECT_EQ(run(app, small()), 0);
    EXPECT_TRUE(key);
    EXPECT_TRUE(click);
    EXPECT_EQ(wheel, -2);
    ASSERT_TRUE(app.last<KeyEvent>().has_value());
    EXPECT_FALSE(app.last<KeyEvent>().value().down);
}

TEST(SdlApp, closingAsksTheApplication) {
    ScriptedApp app;
    app.refuseCloses = 1;
    app.onTick = [&] {
        if (app.ticks == 5 || app.ticks == 50) {
            SDL_Event event{};
            event.type = SDL_QUIT;
            SDL_PushEvent(&event);
        }
    };
    EXPECT_EQ(run(app, small()), 0);
    EXPECT_EQ(app.closeRequests, 2);
    EXPECT_GE(app.ticks, 50);
}

TEST(SdlApp, resizingChangesTheCanvas) {
    ScriptedApp app;
    PixelSize seen;
    app.onTick = [&] {
        if (app.ticks == 10) app.platform->setWindowSize({400, 200});
        if (app.ticks >= 50 && (seen == PixelSize{400, 200} || app.ticks > 5000))
            app.platform->quit();
    };
    app.onDraw = [&](Canvas& canvas) { seen = canvas.size(); };
    EXPECT_EQ(run(app, small()), 0);
    EXPECT_EQ(seen, (PixelSize{400, 200}));
    EXPECT_EQ(app.platform != nullptr, true);
    ASSERT_TRUE(app.last<WindowResized>().has_value());
    EXPECT_EQ(app.last<WindowResized>().value().size, (PixelSize{400, 200}));
}

TEST(SdlApp, textAndClipboardAreUtf8) {
    ScriptedApp app;
    std::string typed;
    std::string pasted;
    app.onTick = [&] {
        typed += app.platform->input().text;
        if (app.ticks == 5) {
            app.platform->setTextInput(true);
            SDL_Event event{};
            event.type = SDL_TEXTINPUT;
            SDL_strlcpy(event.text.text, "grün", sizeof(event.text.text));
            SDL_PushEvent(&event);
            app.platform->setClipboard("Wäldchen");
            pasted = app.platform->clipboard();
        }
        if (app.ticks == 60) app.platform->quit();
    };
    EXPECT_EQ(run(app, small()), 0);
    EXPECT_EQ(typed, "grün");
    EXPECT_EQ(pasted, "Wäldchen");
}

TEST(SdlApp, slowTicksSlowTimeDownAndSaySo) {
    ScriptedApp app;
    double overload = 0;
    app.onTick = [&] {
        // Ten times longer than a tick may take, at any speed of the machine.
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        overload = std::max(overload, app.platform->clock().overload());
        if (overload > 0 || app.ticks > 500) app.platform->quit();
    };
    EXPECT_EQ(run(app, small()), 0);
    EXPECT_GT(overload, 0.3);
    EXPECT_GT(app.platform == nullptr ? 0 : app.draws, 5) << "and it goes on drawing";
}

TEST(SdlApp, runsTwiceInOneProgram) {
    for (int i = 0; i < 2; ++i) {
        ScriptedApp app;
        app.onTick = [&] { app.platform->quit(); };
        EXPECT_EQ(run(app, small()), 0);
        EXPECT_EQ(app.ticks, 1);
    }
}

TEST(SdlApp, offscreenNeedsNoWindow) {
    ScriptedApp app;
    app.onDraw = [&](Canvas&) {
        if (app.draws == 30) app.platform->quit();
    };
    WindowOptions options = small();
    options.offscreen = true;
    EXPECT_EQ(run(app, options), 0);
    EXPECT_EQ(app.ticks, 250);
}

TEST(SdlApp, resizingToTheSmallestAndBackDoesNoHarm) {
    ScriptedApp app;
    app.onTick = [&] {
        if (app.ticks % 20 == 10)
            app.platform->setWindowSize(app.ticks % 40 == 10 ? PixelSize{1, 1}
                                                             : PixelSize{500, 300});
        if (app.ticks == 200) app.platform->quit();
    };
    EXPECT_EQ(run(app, small()), 0);
    EXPECT_EQ(app.ticks, 200);
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

TEST(SdlApp, aPadComesAndGoes) {
    expectAPadToComeAndGo([](Application& app) { return run(app, small()); });
}

TEST(SdlApp, aLostContextIsMadeAgain) {
    const TemporaryFolder folder;
    const LostDriver driver;
    RestorableApp app;
    app.onDraw = [&](Canvas&) {
        if (app.draws == 5) LostDriver::lose();
        if (app.draws == 10) app.platform->requestScreenshot(folder / "after.png");
        if (app.draws == 12) app.platform->quit();
    };
    EXPECT_EQ(run(app, small()), 0);
    EXPECT_EQ(app.restored, 1);
    EXPECT_EQ(loadImage(folder / "after.png").pixel(160, 120),
              (std::array<std::uint8_t, 4>{0xFF, 0xB3, 0x47, 255}));
}

// Run apart, with a display that does not exist.
TEST(SdlApp, DISABLED_noDisplayIsOneClearSentence) {
    ScriptedApp app;
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(app, small()), 1);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("no window can be opened"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_EQ(app.platform, nullptr);
}

}  // namespace
