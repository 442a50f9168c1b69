// Many pictures on few pages.
#include <gtest/gtest.h>

#include <atlax/error.hpp>
#include <atlax/offscreen.hpp>
#include <atlax/sprite_atlas.hpp>

namespace {

using namespace atlax;

Image filled(PixelSize size, std::array<std::uint8_t, 4> color) {
    Image image(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) image.setPixel(x, y, color);
    return image;
}

std::vector<AtlasImage> manyImages() {
    std::vector<AtlasImage> images;
    for (int i = 0; i < 40; ++i)
        images.push_back(
            {"n" + std::to_string(i),
             filled({5 + i % 7, 3 + i % 11}, {static_cast<std::uint8_t>(i * 6), 0, 200, 255})});
    return images;
}

TEST(SpriteAtlas, everyPictureIsFoundWholeAndAlone) {
    OffscreenCanvas offscreen({64, 64});
    const auto images = manyImages();
    const SpriteAtlas atlas(offscreen.canvas(), images, {.pageSide = 128});
    EXPECT_EQ(atlas.size(), images.size());
    for (const AtlasImage& one : images) {
        const AtlasSprite& sprite = atlas.at(one.name);
        ASSERT_EQ(sprite.size, one.image.size());
        Canvas& c = offscreen.begin();
        // Drawn much larger: no neighbour may show at its border.
        c.sprite(sprite.texture, {32, 32}, {64, 64}, {.uv = sprite.uv});
        offscreen.finish();
        const Image seen = offscreen.image();
        for (const auto& [x, y] : {std::pair{0, 0}, {63, 0}, {0, 63}, {63, 63}, {32, 32}})
            ASSERT_EQ(seen.pixel(x, y), one.image.pixel(0, 0))
                << one.name << " at " << x << ' ' << y;
    }
}

TEST(SpriteAtlas, aPageIsOneDrawCall) {
    OffscreenCanvas offscreen({64, 64});
    const auto images = manyImages();
    const SpriteAtlas atlas(offscreen.canvas(), images, {.pageSide = 256});
    ASSERT_EQ(atlas.pages(), 1);
    Canvas& c = offscreen.begin();
    for (const AtlasImage& one : images)
        c.sprite(atlas.at(one.name).texture, {32, 32}, {8, 8}, {.uv = atlas.at(one.name).uv});
    offscreen.finish();
    EXPECT_EQ(c.statistics().drawCalls, 1);
}

TEST(SpriteAtlas, whatDoesNotFitOnOnePageGoesToTheNext) {
    OffscreenCanvas offscreen({8, 8});
    std::vector<AtlasImage> images;
    for (int i = 0; i < 5; ++i)
        images.push_back({std::to_string(i), filled({56, 56}, {255, 255, 255, 255})});
    EXPECT_EQ(SpriteAtlas(offscreen.canvas(), images, {.pageSide = 64}).pages(), 5);
    EXPECT_EQ(SpriteAtlas(offscreen.canvas(), images, {.pageSide = 128}).pages(), 2);
}

TEST(SpriteAtlas, whatCannotBeIsRefusedByName) {
    OffscreenCanvas offscreen({8, 8});
    const auto said = [&](std::vector<AtlasImage> images, int side) -> std::string {
        try {
            const SpriteAtlas atlas(offscreen.canvas(), images, {.pageSide = side});
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    const Image small = filled({4, 4}, {1, 2, 3, 4});
    EXPECT_NE(said({{"a", small}, {"a", small}}, 64).find("\"a\""), std::string::npos);
    EXPECT_NE(said({{"b", Image()}}, 64).find("\"b\""), std::string::npos);
    EXPECT_NE(said({{"c", filled({64, 4}, {})}}, 64).find("\"c\""), std::string::npos);
    EXPECT_NE(said({{"d", small}}, 63).find("64"), std::string::npos);
    EXPECT_EQ(said({}, 64), "");
    EXPECT_THROW(SpriteAtlas().at("none"), Error);
}

}  // namespace
