#include <gtest/gtest.h>

#include <atlax/backend.hpp>
#include <atlax/error.hpp>
#include <atlax/image.hpp>
#include <stdexcept>

#include "scripted_app.hpp"
#include "temporary_folder.hpp"
#include "virtual_pad.hpp"

namespace {

using namespace atlax;

WindowOptions small(int rate = 500) {
    WindowOptions options;
    options.size = {160, 120};
    options.tickRateHz = rate;
    options.offscreen = true;
    return options;
}

TEST(OffscreenApp, ticksAndFramesFollowTheFakeClockExactly) {
    ScriptedApp app;
    app.onDraw = [&](Canvas&) {
        if (app.draws == 60) app.platform->quit(7);
    };
    EXPECT_EQ(runOffscreen(app, small()), 7);
    EXPECT_EQ(app.draws, 60);
    EXPECT_EQ(app.ticks, 500);
    EXPECT_EQ(app.stops, 1);
    EXPECT_TRUE(app.alphaInRange);
}

TEST(OffscreenApp, postedEventsReachEventsAndTicks) {
    ScriptedApp app;
    bool seen = false;
    app.onTick = [&] {
        if (app.ticks == 5) app.platform->post(KeyEvent{.key = Key::R, .down = true});
        seen = seen || app.platform->input().wasPressed(Key::R);
        if (app.ticks == 100) app.platform->post(CloseRequested{});
    };
    EXPECT_EQ(runOffscreen(app, small()), 0);
    EXPECT_TRUE(seen);
    ASSERT_TRUE(app.last<KeyEvent>().has_value());
    EXPECT_EQ(app.last<KeyEvent>().value().key, Key::R);
    EXPECT_EQ(app.closeRequests, 1);
}

TEST(OffscreenApp, twoPressesInOneFrameAreTwo) {
    ScriptedApp app;
    int presses = 0, held = 0;
    app.onTick = [&] {
        presses += app.platform->input().wasPressed(Key::R) ? 1 : 0;
        held += app.platform->input().isDown(Key::R) ? 1 : 0;
    };
    app.onDraw = [&](Canvas&) {
        for (const bool down : {true, false, true, false})
            if (app.draws == 3) app.platform->post(KeyEvent{.key = Key::R, .down = down});
        if (app.draws == 6) app.platform->quit();
    };
    EXPECT_EQ(runOffscreen(app, small()), 0);
    EXPECT_EQ(presses, 2);
    EXPECT_EQ(held, 4) << "two of the frame's eight ticks each";
}

TEST(OffscreenApp, closingMayBeRefused) {
    ScriptedApp app;
    app.refuseCloses = 2;
    app.onTick = [&] { app.platform->post(CloseRequested{}); };
    EXPECT_EQ(runOffscreen(app, small(60)), 0);
    EXPECT_EQ(app.closeRequests, 3);
}

TEST(OffscreenApp, screenshotsShowTheFrame) {
    const TemporaryFolder folder;
    ScriptedApp app;
    app.onTick = [&] {
        if (app.ticks == 1) app.platform->requestScreenshot(folder / "shot.png");
        if (app.ticks == 30) app.platform->quit();
    };
    EXPECT_EQ(runOffscreen(app, small()), 0);
    const Image shot = loadImage(folder / "shot.png");
    ASSERT_EQ(shot.size(), (PixelSize{160, 120}));
    EXPECT_EQ(shot.pixel(80, 60), (std::array<std::uint8_t, 4>{0xFF, 0xB3, 0x47, 255}));
    EXPECT_EQ(shot.pixel(1, 1), (std::array<std::uint8_t, 4>{0x0B, 0x10, 0x26, 255}));
}

TEST(OffscreenApp, aScreenshotThatFailsChangesNothing) {
    ScriptedApp app;
    app.onTick = [&] {
        if (app.ticks == 1) app.platform->requestScreenshot("/proc/no/such/place.png");
        if (app.ticks == 30) app.platform->quit();
    };
    EXPECT_EQ(runOffscreen(app, small()), 0);
}

TEST(OffscreenApp, resizingChangesTheCanvas) {
    ScriptedApp app;
    PixelSize seen;
    app.onTick = [&] {
        if (app.ticks == 10) app.platform->setWindowSize({33, 44});
        if (app.ticks == 60) app.platform->quit();
    };
    app.onDraw = [&](Canvas& canvas) { seen = canvas.size(); };
    EXPECT_EQ(runOffscreen(app, small()), 0);
    EXPECT_EQ(seen, (PixelSize{33, 44}));
    ASSERT_TRUE(app.last<WindowResized>().has_value());
}

TEST(OffscreenApp, onePixelAndBackAndNoAreaAtAll) {
    ScriptedApp app;
    app.onTick = [&] {
        if (app.ticks == 50) app.platform->setWindowSize({1, 1});
        if (app.ticks == 100) app.platform->post(WindowResized{{0, 0}, 1});
        if (app.ticks == 150) app.platform->setWindowSize({640, 480});
        if (app.ticks == 200) app.platform->quit();
    };
    EXPECT_EQ(runOffscreen(app, small()), 0);
    EXPECT_LT(app.draws, 24) << "nothing is drawn where there is no area";
}

TEST(OffscreenApp, pauseStopsTicksButNotDrawing) {
    ScriptedApp app;
    app.onTick = [&] { app.platform->clock().setPaused(true); };
    app.onDraw = [&](Canvas&) {
        if (app.draws == 20) app.platform->clock().singleTick();
        if (app.draws == 40) app.platform->quit();
    };
    EXPECT_EQ(runOffscreen(app, small()), 0);
    EXPECT_EQ(app.ticks, 2);
}

TEST(OffscreenApp, pressesInAPauseDoNotReachLaterTicks) {
    ScriptedApp app;
    bool seenInPause = false;
    bool seenByTick = false;
    app.onTick = [&] {
        seenByTick = seenByTick || app.platform->input().wasPressed(MouseButton::Left);
        if (app.ticks == 1) app.platform->clock().setPaused(true);
        if (app.ticks == 100) app.platform->quit();
    };
    app.onDraw = [&](Canvas&) {
        seenInPause = seenInPause || app.platform->input().wasPressed(MouseButton::Left);
        if (app.draws == 10) app.platform->post(MouseButtonEvent{.down = true});
        if (app.draws == 20) app.platform->clock().setPaused(false);
    };
    EXPECT_EQ(runOffscreen(app, small()), 0);
    EXPECT_TRUE(seenInPause);
    EXPECT_FALSE(seenByTick);
    EXPECT_TRUE(app.platform != nullptr);
}

TEST(OffscreenApp, aPadComesAndGoes) {
    expectAPadToComeAndGo([](Application& app) { return runOffscreen(app, small()); });
}

TEST(OffscreenApp, errorsBecomeOneSentenceAndAnExitCode) {
    ScriptedApp app;
    app.onTick = [] { throw Error("the level is broken"); };
    testing::internal::CaptureStderr();
    EXPECT_EQ(runOffscreen(app, small()), 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "the level is broken\n");
    EXPECT_EQ(app.stops, 1);

    ScriptedApp broken;
    broken.onStart = [] { throw std::runtime_error("no assets"); };
    testing::internal::CaptureStderr();
    EXPECT_EQ(runOffscreen(broken, small()), 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "no assets\n");
    EXPECT_EQ(broken.stops, 0);

    ScriptedApp never;
    WindowOptions bad = small(7);
    testing::internal::CaptureStderr();
    EXPECT_EQ(runOffscreen(never, bad), 1);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("7 Hz"), std::string::npos);
}

}  // namespace
