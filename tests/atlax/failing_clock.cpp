// A clock that fails: it stands, goes back by a day, or leaps ahead by a year. The program goes on,
// makes no more ticks for it than a hiccup asks for, and measures again afterwards.
#include <gtest/gtest.h>

#include <atlax/backend.hpp>
#include <atlax/offscreen.hpp>
#include <cmath>
#include <functional>

#include "scripted_app.hpp"

namespace {

using namespace atlax;

constexpr std::int64_t millisecond = 1'000'000;
constexpr std::int64_t wholeDay = 24 * 3600 * 1000 * millisecond;

WindowOptions tinyWindow() {
    WindowOptions options;
    options.size = {64, 48};
    options.tickRateHz = 500;
    return options;
}

/// Frames without a window, by a clock of the test.
class TimedPlatform : public BackendPlatform {
public:
    TimedPlatform(ScriptedApp& app, const FakeClock& clock)
        : BackendPlatform(app, tinyWindow(), [&clock] { return clock.now(); }),
          screen_(tinyWindow().size) {
        handle(WindowResized{screen_.size(), 1});
        begin();
    }
    ~TimedPlatform() override { end(); }

    void drawOneFrame() { frame(); }
    bool hasEnded() const { return finished(); }

    void setTitle(const std::string&) override {}
    void setFullscreen(bool) override {}
    bool fullscreen() const override { return false; }
    void setWindowSize(PixelSize) override {}
    void setMinimised(bool) override {}
    bool minimised() const override { return false; }
    void setVsync(bool) override {}
    void setCursorVisible(bool) override {}
    void setCursor(Cursor) override {}
    void setTextInput(bool) override {}
    std::string clipboard() override { return {}; }
    void setClipboard(const std::string&) override {}

protected:
    void beginCanvasFrame(Canvas& canvas) override { canvas.beginFrame(screen_.target(), 1); }

private:
    OffscreenCanvas screen_;
};

class FailingClock : public testing::Test {
protected:
    /// Frames of 10 or 20 ms for a second, other ones than the last time.
    void runASecond() {
        frames = frames == 50 ? 100 : 50;
        for (int i = 0; i < frames; ++i) {
            clock.advance(1000 / frames * millisecond);
            platform.drawOneFrame();
        }
    }
    /// What the clock does now costs at most the ticks of the longest frame that counts, and a
    /// second after it all is as before.
    void expectToGoOnAfter(std::int64_t leap) {
        constexpr int longestFrame = 125;  // ticks, in 0.25 s
        const int before = app.ticks;
        clock.advance(leap);
        platform.drawOneFrame();
        EXPECT_LE(app.ticks - before, longestFrame) << leap;
        const int after = app.ticks;
        runASecond();
        EXPECT_EQ(app.ticks - after, 500) << leap;
        EXPECT_NEAR(platform.statistics().framesPerSecond, frames, 3) << leap;
        EXPECT_TRUE(app.alphaInRange);
        EXPECT_FALSE(platform.hasEnded());
    }

    ScriptedApp app;
    FakeClock clock;
    TimedPlatform platform{app, clock};
    int frames = 50;
};

TEST_F(FailingClock, standsStill) {
    runASecond();
    const int before = app.ticks;
    for (int i = 0; i < 100; ++i) platform.drawOneFrame();
    EXPECT_EQ(app.ticks, before);
    EXPECT_TRUE(std::isfinite(platform.statistics().framesPerSecond));
    // The frames that no time has passed for count in the next half a second.
    runASecond();
    expectToGoOnAfter(0);
}

TEST_F(FailingClock, goesBack) {
    runASecond();
    for (const std::int64_t back : {millisecond, wholeDay, 365 * wholeDay})
        expectToGoOnAfter(-back);
}

TEST_F(FailingClock, leapsAhead) {
    runASecond();
    for (const std::int64_t ahead : {1000 * millisecond, wholeDay, 365 * wholeDay})
        expectToGoOnAfter(ahead);
}

TEST_F(FailingClock, failsWhileATickIsMade) {
    runASecond();
    app.onTick = [&] {
        if (app.ticks % 7 == 0) clock.advance(app.ticks % 2 == 0 ? wholeDay : -wholeDay);
    };
    for (int i = 0; i < 20; ++i) {
        clock.advance(20 * millisecond);
        platform.drawOneFrame();
    }
    EXPECT_TRUE(app.alphaInRange);
    app.onTick = {};
    runASecond();
    expectToGoOnAfter(20 * millisecond);
}

}  // namespace
