// Blend modes, gradients, shaders, nine-patches and post-processing, checked by pixels.
#include <gtest/gtest.h>

#include <array>
#include <atlax/error.hpp>
#include <atlax/offscreen.hpp>
#include <atlax/post_process.hpp>
#include <functional>

namespace {

using namespace atlax;
using Pixel = std::array<std::uint8_t, 4>;

Image drawn(const std::function<void(Canvas&)>& draw, PixelSize size = {64, 64}) {
    OffscreenCanvas offscreen(size);
    draw(offscreen.begin());
    offscreen.finish();
    return offscreen.image();
}

void expectNear(const Pixel& pixel, const Pixel& wanted, int tolerance) {
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(pixel[i], wanted[i], tolerance) << i;
}

Pixel blended(Blend blend, Color below, Color above) {
    return drawn([&](Canvas& c) {
               c.clear(below);
               c.setBlend(blend);
               c.rect({{0, 0}, {64, 64}}, above);
           })
        .pixel(32, 32);
}

TEST(CanvasBlend, everyModeIsItsFormula) {
    const Color below{0.5f, 0.25f, 1, 1};
    const Color above{0.5f, 0.5f, 0.5f, 0.5f};
    expectNear(blended(Blend::Alpha, below, above), {128, 96, 191, 255}, 1);
    expectNear(blended(Blend::Additive, below, above), {191, 128, 255, 255}, 1);
    // Half of below, and half of below times above.
    expectNear(blended(Blend::Multiply, below, above), {96, 48, 191, 255}, 1);
    // 1 - (1 - below)(1 - above * alpha).
    expectNear(blended(Blend::Screen, below, above), {159, 112, 255, 255}, 1);
}

TEST(CanvasBlend, onlyOtherFormulasCostDrawCalls) {
    OffscreenCanvas offscreen({64, 64});
    Canvas& c = offscreen.begin();
    for (const Blend blend : {Blend::Alpha, Blend::Additive, Blend::Alpha}) {
        c.setBlend(blend);
        c.circle({32, 32}, 10, colors::white);
    }
    c.setBlend(Blend::Multiply);
    c.circle({32, 32}, 10, colors::white);
    offscreen.finish();
    EXPECT_EQ(c.statistics().drawCalls, 2);
}

TEST(CanvasGradient, goesLinearlyAndStaysBeyond) {
    const std::array<Vec2, 4> all{Vec2{0, 0}, Vec2{64, 0}, Vec2{64, 64}, Vec2{0, 64}};
    const Image image = drawn([&](Canvas& c) {
        c.polygon(
            all,
            Gradient{.from = {16, 0}, .to = {48, 0}, .start = colors::black, .end = colors::white});
    });
    expectNear(image.pixel(5, 30), {0, 0, 0, 255}, 1);
    expectNear(image.pixel(32, 10), {130, 130, 130, 255}, 3);
    expectNear(image.pixel(32, 50), {130, 130, 130, 255}, 3);
    expectNear(image.pixel(60, 30), {255, 255, 255, 255}, 1);
}

TEST(CanvasGradient, goesRadiallyAlsoInTheWorldAndToNothing) {
    const std::array<Vec2, 4> all{Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}};
    const Color red{1, 0, 0, 1};
    const Image image = drawn([&](Canvas& c) {
        c.setCamera({.centre = {0, 0}, .pixelsPerMetre = 32});
        c.polygon(all, Gradient{.kind = Gradient::Kind::Radial,
                                .from = {0, 0},
                                .to = {0, 0.5f},
                                .start = red,
                                .end = red.withAlpha(0)});
    });
    expectNear(image.pixel(32, 32), {255, 0, 0, 250}, 10);
    EXPECT_NEAR(image.pixel(32, 24)[3], 128, 12);
    EXPECT_NEAR(image.pixel(40, 32)[3], 128, 12);
    EXPECT_EQ(image.pixel(32, 10)[3], 0);
}

TEST(CanvasShader, paintsSpritesWithItsValuesAndNothingAfterwards) {
    Image grey({1, 1});
    grey.setPixel(0, 0, {128, 128, 128, 255});
    const Image image = drawn([&](Canvas& c) {
        const Texture texture = c.createTexture(grey);
        const Shader shader = c.createShader(R"(
            uniform vec3 factor;
            vec4 paint(vec2 uv, vec4 tint) {
                return vec4(texture(picture, uv).rgb * factor, 1.0) * tint;
            })");
        const std::array values{ShaderValue{"factor", {1, 0.5f, 0, 0}}, ShaderValue{"absent", {}}};
        c.setShader(shader, values);
        c.sprite(texture, {16, 32}, {32, 64});
        c.setShader({});
        c.sprite(texture, {48, 32}, {32, 64});
    });
    expectNear(image.pixel(10, 30), {128, 64, 0, 255}, 1);
    expectNear(image.pixel(50, 30), {128, 128, 128, 255}, 1);
}

TEST(CanvasShader, whatIsNoShaderIsRefusedWithItsLine) {
    OffscreenCanvas offscreen({8, 8});
    try {
        offscreen.canvas().createShader("\n\nvec4 paint(vec2 uv, vec4 tint) { return nonsense; }");
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("nonsense"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(":3("), std::string::npos) << error.what();
    }
    EXPECT_THROW(offscreen.canvas().createShader("void other() {}"), Error);
    EXPECT_THROW(offscreen.canvas().createShader(""), Error);
    offscreen.begin().circle({4, 4}, 3, colors::white);
    offscreen.finish();
    EXPECT_EQ(offscreen.image().pixel(4, 4)[3], 255) << "and the canvas goes on";
}

/// 12 pixels a side: corners red, edges green, the middle blue, with borders of 4.
Image frame() {
    Image image({12, 12});
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) {
            const int borders = (x < 4 || x >= 8) + (y < 4 || y >= 8);
            const auto on = [&](int n) {
                return static_cast<std::uint8_t>(borders == n ? 255 : 0);
            };
            image.setPixel(x, y, {on(2), on(1), on(0), 255});
        }
    return image;
}

TEST(CanvasNinePatch, cornersKeepTheirSize) {
    const Image image = drawn([](Canvas& c) {
        const Texture texture = c.createTexture(frame(), {.smooth = false});
        c.ninePatch(texture, {{0, 0}, {64, 32}}, {4, 4, 4, 4});
    });
    EXPECT_EQ(image.pixel(3, 3), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(image.pixel(5, 2), (Pixel{0, 255, 0, 255}));
    EXPECT_EQ(image.pixel(5, 5), (Pixel{0, 0, 255, 255}));
    EXPECT_EQ(image.pixel(58, 26), (Pixel{0, 0, 255, 255}));
    EXPECT_EQ(image.pixel(61, 29), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(image.pixel(5, 33)[3], 0);
}

TEST(CanvasNinePatch, bordersShrinkWhereThereIsNoRoom) {
    const Image image = drawn([](Canvas& c) {
        const Texture texture = c.createTexture(frame(), {.smooth = false});
        c.ninePatch(texture, {{0, 0}, {4, 64}}, {4, 4, 4, 4});
        c.ninePatch(texture, {{20, 20}, {10, 10}}, {-1, 0, 0, 0});
    });
    EXPECT_EQ(image.pixel(1, 1), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(image.pixel(2, 30), (Pixel{0, 255, 0, 255}));
    EXPECT_EQ(image.pixel(5, 30)[3], 0);
    EXPECT_EQ(image.pixel(25, 25)[3], 0) << "a border below 0 draws nothing";
}

Image processed(std::span<const PostEffect> effects) {
    return drawn(
        [&](Canvas& c) {
            PostProcess post(c);
            c.setScreenSpace(2);
            post.begin();
            c.clear(Color::hex(0x202020));
            c.rect({{60, 60}, {8, 8}}, colors::white);
            post.end(effects);
            EXPECT_EQ(c.pixel(), 0.5f) << "the frame's space is back";
        },
        {128, 128});
}

TEST(CanvasPostProcess, withoutEffectsItChangesNothing) {
    const Image image = processed({});
    EXPECT_EQ(image.pixel(10, 10), (Pixel{0x20, 0x20, 0x20, 255}));
    EXPECT_EQ(image.pixel(61, 61), (Pixel{255, 255, 255, 255}));
    EXPECT_EQ(image.pixel(64, 59), (Pixel{0x20, 0x20, 0x20, 255})) << "and is not upside down";
}

TEST(CanvasPostProcess, bloomSpreadsFromWhatIsBrightAlikeToAllSides) {
    const std::array<PostEffect, 1> effects{Bloom{.threshold = 0.5f, .strength = 1, .radius = 16}};
    const Image image = processed(effects);
    const int near = image.pixel(64, 52)[0];
    const int far = image.pixel(64, 30)[0];
    EXPECT_GT(near, 0x20 + 8);
    EXPECT_LT(far, near);
    EXPECT_EQ(image.pixel(2, 2)[0], 0x20);
    EXPECT_NEAR(image.pixel(52, 64)[0], near, 4);
    EXPECT_NEAR(image.pixel(75, 64)[0], near, 4);
    EXPECT_NEAR(image.pixel(64, 75)[0], near, 4);
    EXPECT_EQ(image.pixel(64, 64)[0], 255);
}

TEST(CanvasPostProcess, vignetteDarkensCornersAndPassesFollowEachOther) {
    OffscreenCanvas offscreen({64, 64});
    Canvas& c = offscreen.begin();
    PostProcess post(c);
    const Shader invert = c.createShader(
        "vec4 paint(vec2 uv, vec4 tint) { vec4 p = texture(picture, uv); return vec4(p.a - p.rgb, "
        "p.a); }");
    const std::array<PostEffect, 2> effects{ShaderPass{invert, {}},
                                            Vignette{.strength = 1, .begin = 0.5f}};
    post.begin();
    c.clear(colors::black);
    post.end(effects);
    offscreen.finish();
    const Image image = offscreen.image();
    EXPECT_EQ(image.pixel(32, 32), (Pixel{255, 255, 255, 255})) << "inverted first";
    EXPECT_LT(image.pixel(0, 0)[0], 12);
    EXPECT_EQ(image.pixel(0, 0)[3], 255);
}

TEST(CanvasPostProcess, followsTheSizeDownToOnePixel) {
    OffscreenCanvas offscreen({64, 64});
    PostProcess post(offscreen.canvas());
    const std::array<PostEffect, 2> effects{Bloom{}, Vignette{}};
    for (const PixelSize size : {PixelSize{64, 64}, PixelSize{1, 1}, PixelSize{100, 3}}) {
        offscreen.resize(size);
        offscreen.begin();
        post.begin();
        offscreen.canvas().clear(Color::hex(0x404040));
        post.end(effects);
        offscreen.finish();
        const Image image = offscreen.image();
        EXPECT_GT(image.pixel(size.width / 2, size.height / 2)[0], 0x20);
    }
}

}  // namespace
