// What the canvas draws, checked by pixels without a window.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atlax/error.hpp>
#include <atlax/offscreen.hpp>
#include <cmath>
#include <functional>
#include <limits>

namespace {

using namespace atlax;
using Pixel = std::array<std::uint8_t, 4>;

constexpr Pixel white{255, 255, 255, 255};
constexpr Pixel nothing{0, 0, 0, 0};

Image drawn(const std::function<void(Canvas&)>& draw, PixelSize size = {64, 64}) {
    OffscreenCanvas offscreen(size);
    draw(offscreen.begin());
    offscreen.finish();
    return offscreen.image();
}

/// Sum of the alpha of all pixels, in pixels.
double coveredArea(const Image& image) {
    double sum = 0;
    for (std::size_t i = 3; i < image.bytes().size(); i += 4) sum += image.bytes()[i];
    return sum / 255;
}

int softPixels(const Image& image) {
    int count = 0;
    for (std::size_t i = 3; i < image.bytes().size(); i += 4)
        count += image.bytes()[i] > 0 && image.bytes()[i] < 255;
    return count;
}

TEST(Canvas, circleHasItsColourItsAreaAndASoftBorder) {
    const Image image = drawn([](Canvas& c) { c.circle({32, 32}, 20, Color::hex(0xFFB347)); });
    EXPECT_EQ(image.pixel(32, 32), (Pixel{0xFF, 0xB3, 0x47, 255}));
    EXPECT_EQ(image.pixel(2, 2), nothing);
    EXPECT_NEAR(coveredArea(image), 3.14159 * 400, 5);
    EXPECT_GT(softPixels(image), 60);
}

TEST(Canvas, capsuleAndOutlineHaveTheirArea) {
    const Image capsule = drawn([](Canvas& c) { c.capsule({20, 25}, {44, 39}, 8, colors::white); });
    EXPECT_NEAR(coveredArea(capsule), 3.14159 * 64 + 16 * std::hypot(24, 14), 4);
    const Image ring = drawn([](Canvas& c) { c.circleOutline({32, 32}, 20, 4, colors::white); });
    EXPECT_NEAR(coveredArea(ring), 3.14159 * (400 - 256), 4);
    EXPECT_EQ(ring.pixel(32, 32), nothing);
    EXPECT_EQ(ring.pixel(32, 14), white) << "the line lies inside of the radius";
}

TEST(Canvas, thinLinesFadeInsteadOfVanishing) {
    const auto area = [](float width) {
        return coveredArea(drawn([=](Canvas& c) {
            c.line({10, 12}, {54, 47}, width, colors::white);
        }));
    };
    const double length = std::hypot(44, 35);
    EXPECT_NEAR(area(0.25f), 0.25 * length, 0.15 * length);
    EXPECT_NEAR(area(1), length, 0.1 * length);
    EXPECT_NEAR(area(3), 3 * length, 0.1 * length + 8);
}

TEST(Canvas, worldHasYUpAndTheScreenYDown) {
    const Image image = drawn([](Canvas& c) {
        c.setCamera({.centre = {100, 50}, .pixelsPerMetre = 10});
        c.circle({100, 52}, 0.5f, colors::white);
        c.setScreenSpace();
        c.rect({{0, 60}, {4, 4}}, colors::white);
    });
    EXPECT_EQ(image.pixel(32, 12), white);
    EXPECT_EQ(image.pixel(32, 52), nothing);
    EXPECT_EQ(image.pixel(1, 62), white);
    EXPECT_EQ(image.pixel(1, 1), nothing);
}

TEST(Canvas, cameraGoesThereAndBack) {
    OffscreenCanvas offscreen({640, 480});
    Canvas& c = offscreen.begin();
    const Camera camera = Camera::withHeight({-3, 7}, 12, c.size());
    c.setCamera(camera);
    EXPECT_FLOAT_EQ(c.pixel(), 12.0f / 480.0f);
    const Vec2 p{1.25f, 9.5f};
    EXPECT_NEAR(c.fromPixels(c.toPixels(p)).x, p.x, 1e-4f);
    EXPECT_NEAR(c.fromPixels(c.toPixels(p)).y, p.y, 1e-4f);
    EXPECT_NEAR(camera.toScreen(p, c.size()).y, c.toPixels(p).y, 1e-3f);
    EXPECT_NEAR(camera.toWorld(camera.toScreen(p, c.size()), c.size()).x, p.x, 1e-4f);
    EXPECT_TRUE(camera.view(c.size()).contains({-3, 7}));
    offscreen.finish();
}

TEST(Canvas, rectsOnPixelBordersAreSharp) {
    const Image image = drawn([](Canvas& c) { c.rect({{10, 10}, {20, 5}}, colors::white); });
    EXPECT_EQ(softPixels(image), 0);
    EXPECT_EQ(coveredArea(image), 100);
    EXPECT_EQ(image.pixel(10, 10), white);
    EXPECT_EQ(image.pixel(29, 14), white);
    EXPECT_EQ(image.pixel(30, 14), nothing);
}

TEST(Canvas, polygonsFillConvexAndConcaveInBothDirections) {
    std::vector<Vec2> arrow{{10, 10}, {54, 32}, {10, 54}, {24, 32}};
    const double area = 0.5 * 44 * (54 - 24);  // the kite less its notch
    for (int turn = 0; turn < 2; ++turn) {
        const Image image = drawn([&](Canvas& c) { c.polygon(arrow, colors::white); });
        EXPECT_NEAR(coveredArea(image), area, 0.02 * area);
        EXPECT_EQ(image.pixel(14, 32), nothing) << "the notch stays open";
        EXPECT_EQ(image.pixel(40, 32), white);
        EXPECT_GT(softPixels(image), 50);
        std::reverse(arrow.begin(), arrow.end());
    }
}

TEST(Canvas, transparentPolylinesDoNotOverlapAtTheirJoins) {
    const std::vector<Vec2> points{{8, 40}, {20, 20}, {32, 44}, {44, 20}, {56, 40}};
    const Image image =
        drawn([&](Canvas& c) { c.polyline(points, 6, colors::white.withAlpha(0.5f)); });
    int darkest = 0;
    for (std::size_t i = 3; i < image.bytes().size(); i += 4)
        darkest = std::max<int>(darkest, image.bytes()[i]);
    EXPECT_NEAR(darkest, 128, 2);
    EXPECT_NEAR(image.pixel(32, 44)[3], 128, 2) << "and they leave no hole";
    EXPECT_NEAR(image.pixel(20, 20)[3], 128, 2);
}

TEST(Canvas, alphaCoversAndLightAdds) {
    const Image image = drawn([](Canvas& c) {
        c.clear(Color{0, 0, 0.4f, 1});
        c.rect({{0, 0}, {32, 64}}, Color{1, 0, 0, 0.5f});
        c.setBlend(Blend::Additive);
        c.rect({{32, 0}, {32, 64}}, Color{1, 0, 0, 0.5f});
    });
    const Pixel covered = image.pixel(16, 32);
    EXPECT_NEAR(covered[0], 128, 1);
    EXPECT_NEAR(covered[2], 51, 1);
    const Pixel lit = image.pixel(48, 32);
    EXPECT_NEAR(lit[0], 128, 1);
    EXPECT_NEAR(lit[2], 102, 1) << "what is below stays";
    EXPECT_EQ(lit[3], 255);
}

TEST(Canvas, texturesArePremultiplied) {
    // Transparent pixels that are green must not shine through the border of opaque red ones.
    Image picture({2, 1});
    picture.setPixel(0, 0, {255, 0, 0, 255});
    picture.setPixel(1, 0, {0, 255, 0, 0});
    const Image image = drawn([&](Canvas& c) {
        c.sprite(c.createTexture(picture, {.mipmaps = false}), {32, 32}, {64, 64});
    });
    for (int x = 0; x < 64; ++x) EXPECT_LE(image.pixel(x, 32)[1], 2) << x;
    EXPECT_EQ(image.pixel(4, 32), (Pixel{255, 0, 0, 255}));
    EXPECT_NEAR(image.pixel(32, 32)[3], 128, 8);
}

Image quarters() {
    Image picture({2, 2});
    picture.setPixel(0, 0, {255, 0, 0, 255});
    picture.setPixel(1, 0, {0, 255, 0, 255});
    picture.setPixel(0, 1, {0, 0, 255, 255});
    picture.setPixel(1, 1, {255, 255, 0, 255});
    return picture;
}

TEST(Canvas, spritesStandUprightInBothSpacesAndTurn) {
    const Image image = drawn([](Canvas& c) {
        const Texture texture = c.createTexture(quarters(), {.smooth = false});
        c.sprite(texture, {16, 16}, {20, 20});
        c.setCamera({.centre = {0, 0}, .pixelsPerMetre = 1});
        c.sprite(texture, {16, 16}, {20, 20});
        // A quarter turn counter-clockwise brings the top right corner to the top left.
        c.sprite(texture, {-16, -16}, {20, 20}, {.angle = 1.5707963f});
    });
    EXPECT_EQ(image.pixel(10, 10), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(image.pixel(22, 22), (Pixel{255, 255, 0, 255}));
    EXPECT_EQ(image.pixel(42, 10), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(image.pixel(54, 22), (Pixel{255, 255, 0, 255}));
    EXPECT_EQ(image.pixel(10, 42), (Pixel{0, 255, 0, 255}));
}

TEST(Canvas, meshesDrawTheirTrianglesAndSkipBadIndices) {
    const Image image = drawn([](Canvas& c) {
        const std::array<MeshVertex, 3> vertices{
            {{{0, 0}, {0, 0}}, {{64, 0}, {1, 0}}, {{0, 64}, {0, 1}}}};
        const std::array<std::uint32_t, 8> indices{0, 1, 2, 0, 1, 99, 0, 1};
        c.mesh(Texture(), vertices, indices);
    });
    EXPECT_EQ(image.pixel(10, 10), white);
    EXPECT_EQ(image.pixel(60, 60), nothing);
}

TEST(Canvas, gradientsRunFromTopToBottomInBothSpaces) {
    for (const bool world : {false, true}) {
        const Image image = drawn([=](Canvas& c) {
            if (world) c.setCamera({.centre = {32, 32}, .pixelsPerMetre = 1});
            c.gradientRect({{0, 0}, {64, 64}}, colors::black, colors::white);
        });
        EXPECT_LT(image.pixel(32, 2)[0], 15);
        EXPECT_NEAR(image.pixel(32, 32)[0], 128, 4);
        EXPECT_GT(image.pixel(32, 61)[0], 240);
    }
}

TEST(Canvas, clipsConfineAndNest) {
    const Image image = drawn([](Canvas& c) {
        c.pushClip({{10, 10}, {20, 20}});
        c.pushClip({{0, 0}, {20, 64}});
        c.rect({{0, 0}, {64, 64}}, colors::white);
        c.popClip();
        c.popClip();
        c.popClip();  // one too many does no harm
        c.rect({{60, 60}, {2, 2}}, colors::white);
    });
    EXPECT_EQ(coveredArea(image), 200 + 4);
    EXPECT_EQ(image.pixel(10, 10), white);
    EXPECT_EQ(image.pixel(19, 29), white);
}

TEST(Canvas, textLeavesInkWhereItShould) {
    const Font font = Font::standard();
    TextExtent extent;
    const Image image = drawn(
        [&](Canvas& c) {
            extent = c.text(font, "Quaoar", {100, 40},
                            {.size = 32, .alignX = AlignX::Centre, .alignY = AlignY::Middle});
            EXPECT_EQ(c.measure(font, "Quaoar", 32).width, extent.width);
        },
        {200, 80});
    EXPECT_GT(coveredArea(image), 200);
    int left = 200;
    int right = 0;
    for (int x = 0; x < 200; ++x)
        for (int y = 0; y < 80; ++y)
            if (image.pixel(x, y)[3] > 100) {
                left = std::min(left, x);
                right = std::max(right, x);
            }
    EXPECT_NEAR((left + right) / 2.0, 100, 4);
    EXPECT_NEAR(right - left, static_cast<double>(extent.width), 8);
}

TEST(Canvas, worldTextIsMeasuredInMetres) {
    const Font font = Font::standard();
    OffscreenCanvas offscreen({200, 200});
    Canvas& c = offscreen.begin();
    c.setCamera({.centre = {}, .pixelsPerMetre = 100});
    const auto extent = c.text(font, "Wake", {}, {.size = 0.5f});
    offscreen.finish();
    EXPECT_GT(extent.width, 0.5f);
    EXPECT_LT(extent.width, 3);
    EXPECT_GT(coveredArea(offscreen.image()), 100);
}

TEST(Canvas, manyGlyphSizesOverflowTheAtlasWithoutHarm) {
    const Font font = Font::standard();
    OffscreenCanvas offscreen({256, 256});
    Canvas& c = offscreen.begin();
    for (int size = 20; size < 320; size += 4)
        c.text(font, "ABCDEFGHIJKLM", {0, 200}, {.size = static_cast<float>(size)});
    c.clear(colors::black);
    c.text(font, "M", {128, 128}, {.size = 100, .alignX = AlignX::Centre});
    offscreen.finish();
    const Image image = offscreen.image();
    int bright = 0;
    for (std::size_t i = 0; i < image.bytes().size(); i += 4) bright += image.bytes()[i] > 200;
    EXPECT_GT(bright, 300);
}

TEST(Canvas, drawCallsAreCounted) {
    OffscreenCanvas offscreen({64, 64});
    const Texture texture = offscreen.canvas().createTexture(quarters());
    Canvas& c = offscreen.begin();
    for (int i = 0; i < 1000; ++i) {
        c.circle({32, 32}, 5, colors::white);
        c.line({0, 0}, {64, 64}, 2, colors::white);
        c.setBlend(i % 2 == 0 ? Blend::Additive : Blend::Alpha);
        c.sprite(texture, {32, 32}, {8, 8});
    }
    offscreen.finish();
    EXPECT_EQ(c.statistics().drawCalls, 1);
    EXPECT_EQ(c.statistics().triangles, 6000);
    offscreen.begin();
    offscreen.finish();
    EXPECT_EQ(c.statistics().drawCalls, 0);
}

TEST(Canvas, hugeFramesAreSplitNotRefused) {
    OffscreenCanvas offscreen({16, 16});
    Canvas& c = offscreen.begin();
    for (int i = 0; i < 100'000; ++i) c.circle({8, 8}, 0.6f, colors::white.withAlpha(0.01f));
    offscreen.finish();
    EXPECT_EQ(c.statistics().triangles, 200'000);
    EXPECT_LE(c.statistics().drawCalls, 3);
}

TEST(Canvas, targetsKeepTheirPictureUpright) {
    const Image image = drawn([](Canvas& c) {
        const RenderTarget target = c.createTarget({32, 32});
        c.pushTarget(target);
        c.rect({{0, 0}, {32, 8}}, colors::white);
        c.popTarget();
        EXPECT_EQ(c.read(target).pixel(16, 2), white);
        EXPECT_EQ(c.read(target).pixel(16, 30), nothing);
        c.sprite(target.texture(), {32, 32}, {32, 32});
    });
    EXPECT_EQ(image.pixel(32, 20), white);
    EXPECT_EQ(image.pixel(32, 44), nothing);
}

TEST(Canvas, nonsenseDrawsNothing) {
    const float nan = std::nanf("");
    const float infinite = std::numeric_limits<float>::infinity();
    const Image image = drawn([=](Canvas& c) {
        for (const float bad : {nan, infinite, -1.0f}) {
            c.circle({32, 32}, bad, colors::white);
            c.line({32, 32}, {40, 40}, bad, colors::white);
            c.glow({32, 32}, bad, colors::white);
            c.dashedLine({0, 0}, {64, 64}, 1, bad, bad, colors::white);
            c.polyline(std::array<Vec2, 2>{Vec2{1, 1}, Vec2{60, 60}}, bad, colors::white);
        }
        c.circle({nan, 0}, 5, colors::white);
        c.line({nan, 0}, {5, infinite}, 2, colors::white);
        c.rect({{nan, 0}, {5, 5}}, colors::white);
        c.roundedRectOutline({{nan, 0}, {5, 5}}, 1, 1, colors::white);
        c.sprite(Texture(), {nan, 0}, {5, 5});
        c.polygon(std::array<Vec2, 3>{Vec2{nan, 0}, Vec2{1, 1}, Vec2{2, 0}}, colors::white);
        c.text(Font::standard(), "x", {nan, 0});
        c.text(Font::standard(), "x", {5, 5}, {.size = nan});
        c.circle({32, 32}, 5, Color{nan, nan, nan, nan});
    });
    EXPECT_EQ(coveredArea(image), 0);
}

TEST(Canvas, texturesMayOutliveTheirCanvas) {
    Texture texture;
    RenderTarget target;
    {
        OffscreenCanvas offscreen({8, 8});
        texture = offscreen.canvas().createTexture(quarters());
        target = offscreen.canvas().createTarget({4, 4});
    }
    EXPECT_EQ(texture.size(), (PixelSize{2, 2}));
    EXPECT_EQ(target.size(), (PixelSize{4, 4}));
}

TEST(Canvas, aPictureOfAnotherCanvasIsNoPicture) {
    OffscreenCanvas other({8, 8});
    Image red({1, 1});
    red.setPixel(0, 0, {255, 0, 0, 255});
    const Texture texture = other.canvas().createTexture(red);
    const Image image = drawn([&](Canvas& c) { c.sprite(texture, {32, 32}, {8, 8}); });
    EXPECT_EQ(image.pixel(32, 32), white);
}

TEST(Canvas, badSizesAreRefused) {
    EXPECT_THROW(OffscreenCanvas({0, 10}), Error);
    EXPECT_THROW(OffscreenCanvas({10, 1'000'000}), Error);
    OffscreenCanvas offscreen({8, 8});
    EXPECT_THROW(offscreen.canvas().createTexture(Image()), Error);
    EXPECT_THROW(offscreen.canvas().read(RenderTarget()), Error);
    offscreen.resize({16, 4});
    offscreen.begin();
    offscreen.finish();
    EXPECT_EQ(offscreen.image().size(), (PixelSize{16, 4}));
}

}  // namespace
