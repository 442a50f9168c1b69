// A graphics driver that is reset: pictures are made again, or the program ends with a sentence.
#include <gtest/gtest.h>

#include <atlax/backend.hpp>
#include <atlax/error.hpp>
#include <atlax/image.hpp>
#include <atlax/log.hpp>
#include <atlax/offscreen.hpp>

#include "lost_driver.hpp"
#include "scripted_app.hpp"
#include "temporary_folder.hpp"

namespace {

using namespace atlax;

constexpr std::array<std::uint8_t, 4> amber{0xFF, 0xB3, 0x47, 255};

Image plain(std::array<std::uint8_t, 4> color) {
    Image image({4, 4});
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) image.setPixel(x, y, color);
    return image;
}

WindowOptions smallWindow() {
    WindowOptions options;
    options.size = {160, 120};
    options.offscreen = true;
    return options;
}

/// Draws a texture, which it makes again when asked to.
class TexturedApp : public ScriptedApp {
public:
    TexturedApp() {
        onStart = [this] { texture = platform->canvas().createTexture(plain({0, 255, 0, 255})); };
        onDraw = [this](Canvas& canvas) {
            canvas.sprite(texture, {80, 60}, {100, 80});
            if (draws == 5) LostDriver::lose();
            if (draws == 10) platform->quit();
        };
    }
    bool restoreGraphics() override {
        ++restored;
        if (refuses) return false;
        before = texture;
        onStart();
        return true;
    }

    LostDriver driver;
    Texture texture;
    Texture before;
    int restored = 0;
    bool refuses = false;
};

TEST(LostContext, picturesAreMadeAgainAndTheProgramGoesOn) {
    const TemporaryFolder folder;
    TexturedApp app;
    const auto draw = app.onDraw;
    app.onDraw = [&](Canvas& canvas) {
        draw(canvas);
        if (app.draws == 8) app.platform->requestScreenshot(folder / "after.png");
    };
    EXPECT_EQ(runOffscreen(app, smallWindow()), 0);
    EXPECT_EQ(app.restored, 1);
    EXPECT_EQ(app.draws, 10);
    EXPECT_EQ(app.stops, 1);
    const Image after = loadImage(folder / "after.png");
    EXPECT_EQ(after.pixel(80, 60), (std::array<std::uint8_t, 4>{0, 255, 0, 255}));
    EXPECT_EQ(after.pixel(2, 2), (std::array<std::uint8_t, 4>{0x0B, 0x10, 0x26, 255}));
}

TEST(LostContext, whatWasMadeBeforeIsNoPictureAnyMore) {
    TexturedApp app;
    std::array<std::uint8_t, 4> seen{};
    const auto draw = app.onDraw;
    app.onDraw = [&](Canvas& canvas) {
        draw(canvas);
        if (app.draws != 8) return;
        canvas.sprite(app.before, {80, 60}, {100, 80}, {.tint = Color::hex(0xFFB347)});
        seen = canvas.readFrame().pixel(80, 60);
    };
    EXPECT_EQ(runOffscreen(app, smallWindow()), 0);
    EXPECT_EQ(seen, amber) << "plain in its tint, and not what has its name in the new context";
}

TEST(LostContext, aProgramThatMakesNothingAgainEndsWithASentence) {
    TexturedApp app;
    app.refuses = true;
    testing::internal::CaptureStderr();
    EXPECT_EQ(runOffscreen(app, smallWindow()), 1);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("the graphics driver was reset, and this program cannot"),
              std::string::npos)
        << said;
    EXPECT_EQ(app.stops, 1);
    EXPECT_EQ(app.draws, 5);
}

TEST(LostContext, aDriverThatIsResetAgainAndAgainEndsTheProgram) {
    TexturedApp app;
    app.onDraw = [&](Canvas&) {
        if (app.draws == 5) LostDriver::lose(1000);
        if (app.draws == 100) app.platform->quit();
    };
    testing::internal::CaptureStderr();
    EXPECT_EQ(runOffscreen(app, smallWindow()), 1);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("reset again and again"), std::string::npos) << said;
}

TEST(LostContext, whatCannotBeReadIsNoPicture) {
    const LostDriver driver;
    OffscreenCanvas offscreen({32, 32});
    Canvas& canvas = offscreen.begin();
    canvas.clear(colors::white);
    EXPECT_FALSE(canvas.contextLost());
    LostDriver::lose(3);
    EXPECT_THROW(canvas.readFrame(), Error);
    EXPECT_THROW(canvas.read(offscreen.target()), Error);
    EXPECT_TRUE(canvas.contextLost());
    EXPECT_EQ(canvas.readFrame().pixel(3, 3)[0], 255) << "the driver is well again";
    offscreen.finish();
}

TEST(LostContext, targetsOfAnotherCanvasAreRefused) {
    OffscreenCanvas one({32, 32});
    const RenderTarget foreign = one.canvas().createTarget({8, 8});
    OffscreenCanvas other({32, 32});
    Canvas& canvas = other.begin();
    EXPECT_THROW(canvas.pushTarget(foreign), Error);
    EXPECT_THROW(canvas.drawTarget(foreign), Error);
    EXPECT_THROW(canvas.read(foreign), Error);
    EXPECT_THROW(canvas.pushTarget({}), Error);
    EXPECT_EQ(canvas.size(), (PixelSize{32, 32})) << "and what is drawn into stays the same";
    other.finish();
}

}  // namespace
