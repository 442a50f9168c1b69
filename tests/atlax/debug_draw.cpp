// Debug drawing, checked by pixels: what an adaptor tells is seen where it is, at any zoom.
#include <gtest/gtest.h>

#include <array>
#include <atlax/debug_draw.hpp>
#include <atlax/offscreen.hpp>
#include <limits>
#include <stdexcept>

namespace {

using namespace atlax;
using Pixel = std::array<std::uint8_t, 4>;

constexpr int side = 200;

Image drawnWorld(const DebugWorld& world, float pixelsPerMetre = 50, const DebugStyle& style = {}) {
    OffscreenCanvas offscreen({side, side});
    Canvas& canvas = offscreen.begin();
    canvas.clear(colors::black);
    canvas.setCamera({.centre = {0, 0}, .pixelsPerMetre = pixelsPerMetre});
    drawDebug(canvas, world, style);
    offscreen.finish();
    return offscreen.image();
}

bool lit(const Image& image, int x, int y) {
    const Pixel p = image.pixel(x, y);
    return p[0] > 30 || p[1] > 30 || p[2] > 30;
}

int litPixels(const Image& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += lit(image, x, y) ? 1 : 0;
    return count;
}

TEST(DebugDraw, showsEachThingWhereItIs) {
    const Image disc = drawnWorld([](DebugPen& pen) { pen.disc({0, 0}, 1, DebugState::Moving); });
    EXPECT_TRUE(lit(disc, 149, 100)) << "its rim, one metre to the right";
    EXPECT_FALSE(lit(disc, 100, 100)) << "an outline covers nothing";

    const Image capsule = drawnWorld([](DebugPen& pen) {
        pen.capsule({-1, 0}, {1, 0}, 0.5f, DebugState::Moving);
    });
    EXPECT_TRUE(lit(capsule, 100, 75)) << "its upper edge";
    EXPECT_TRUE(lit(capsule, 174, 100)) << "its round end";

    const Image joint = drawnWorld([](DebugPen& pen) {
        pen.joint({-1, 0}, {1, 0}, 0, DebugState::Moving);
    });
    EXPECT_TRUE(lit(joint, 120, 100) || lit(joint, 120, 99));

    const Image contact = drawnWorld([](DebugPen& pen) { pen.contact({0, 0}, {0, 1}, 5); });
    EXPECT_TRUE(lit(contact, 100, 60) || lit(contact, 99, 60)) << "5 N s are a metre up";
    EXPECT_FALSE(lit(contact, 100, 140));

    const Image bounds = drawnWorld([](DebugPen& pen) {
        pen.bounds({{-1, -1}, {2, 2}}, DebugState::Moving);
    });
    EXPECT_TRUE(lit(bounds, 50, 100) || lit(bounds, 49, 100));

    const Image field = drawnWorld([](DebugPen& pen) { pen.field({0, 0}, 1, {0, -0.5f}); });
    EXPECT_TRUE(lit(field, 100, 115) || lit(field, 99, 115)) << "half a metre down";
}

TEST(DebugDraw, statesAndLoadsHaveTheirColours) {
    DebugStyle style;
    style.dot = 10;
    style.line = 10;
    for (int i = 0; i < debugStateCount; ++i) {
        const Image image = drawnWorld(
            [&](DebugPen& pen) {
                pen.particle({0, 0}, static_cast<DebugState>(i));
            },
            50, style);
        const Color wanted = style.states[i];
        EXPECT_NEAR(image.pixel(100, 100)[0], wanted.r * 255, 1);
        EXPECT_NEAR(image.pixel(100, 100)[2], wanted.b * 255, 1);
    }
    const auto loaded = [&](float load) {
        return drawnWorld(
                   [&](DebugPen& pen) {
                       pen.joint({-1, 0}, {1, 0}, load, DebugState::Moving);
                   },
                   50, style)
            .pixel(100, 100);
    };
    EXPECT_NEAR(loaded(1)[0], style.pulled.r * 255, 1);
    EXPECT_NEAR(loaded(7)[0], style.pulled.r * 255, 1) << "more than all is all";
    EXPECT_NEAR(loaded(-1)[2], style.pressed.b * 255, 1);
    EXPECT_GT(loaded(1)[0], loaded(0.2f)[0]);
}

TEST(DebugDraw, dotsAndLinesAreAsThickAtAnyZoom) {
    const auto dots = [](float zoom) {
        return litPixels(drawnWorld(
            [](DebugPen& pen) {
                pen.particle({0, 0}, DebugState::Moving);
            },
            zoom));
    };
    EXPECT_GT(dots(5), 8);
    EXPECT_EQ(dots(5), dots(5000));
}

TEST(DebugDraw, nonsenseDrawsNothing) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float inf = std::numeric_limits<float>::infinity();
    const Vec2 nowhere{nan, inf};
    const Image image = drawnWorld([&](DebugPen& pen) {
        pen.particle(nowhere, DebugState::Moving);
        pen.disc({0, 0}, -1, DebugState::Moving);
        pen.disc(nowhere, 1, DebugState::Moving);
        pen.capsule({0, 0}, nowhere, 1, DebugState::Moving);
        pen.joint(nowhere, {0, 0}, nan, DebugState::Moving);
        pen.outline(std::array{Vec2{0, 0}, nowhere}, DebugState::Moving);
        pen.outline({}, DebugState::Moving);
        pen.contact(nowhere, {0, 1}, 1);
        pen.spring({0, 0}, nowhere);
        pen.velocity({0, 0}, nowhere);
        pen.bounds({nowhere, {1, 1}}, DebugState::Moving);
        pen.field(nowhere, nan, {0, 0});
        pen.field(Rect{nowhere, {1, 1}}, {0, 0});
    });
    EXPECT_EQ(litPixels(image), 0);
    EXPECT_EQ(litPixels(drawnWorld({})), 0) << "and so does no world at all";
}

TEST(DebugDraw, whatTheAdaptorThrowsPassesThrough) {
    EXPECT_THROW(drawnWorld([](DebugPen&) { throw std::runtime_error("no world"); }),
                 std::runtime_error);
}

TEST(DebugDraw, aThousandBodiesAreOneDrawCall) {
    OffscreenCanvas offscreen({side, side});
    Canvas& canvas = offscreen.begin();
    canvas.setCamera({.centre = {0, 0}, .pixelsPerMetre = 50});
    drawDebug(canvas, [](DebugPen& pen) {
        for (int i = 0; i < 1000; ++i) {
            const Vec2 at{static_cast<float>(i % 40) * 0.1f - 2, static_cast<float>(i / 40) * 0.1f};
            pen.disc(at, 0.05f, DebugState::Moving);
            pen.centreOfMass(at, DebugState::Asleep);
            pen.velocity(at, {1, 1});
        }
    });
    offscreen.finish();
    EXPECT_EQ(canvas.statistics().drawCalls, 1);
}

}  // namespace
