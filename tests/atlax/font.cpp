#include <gtest/gtest.h>

#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/font.hpp>

#include "temporary_folder.hpp"

namespace {

using atlax::Font;

TEST(Font, widerTextMeasuresWider) {
    const Font font = Font::standard();
    const float one = font.measure("m", 32).width;
    EXPECT_GT(one, 8);
    EXPECT_NEAR(font.measure("mmmm", 32).width, 4 * one, 2);
    EXPECT_NEAR(font.measure("Cold Wake", 64).width, 2 * font.measure("Cold Wake", 32).width, 4);
    EXPECT_EQ(font.measure("", 32).width, 0);
}

TEST(Font, kerningPullsPairsTogether) {
    const Font font = Font::standard();
    const float pair = font.measure("AV", 100).width;
    const float apart = font.measure("A", 100).width + font.measure("V", 100).width;
    EXPECT_LT(pair, apart - 0.5f);
}

TEST(Font, linesAddUp) {
    const Font font = Font::standard();
    const auto one = font.measure("first", 20);
    const auto two = font.measure("first\nx", 20);
    EXPECT_EQ(two.width, one.width);
    EXPECT_FLOAT_EQ(two.height, 2 * one.height);
}

TEST(Font, metricsAreSensible) {
    const auto m = Font::standard().metrics(50);
    EXPECT_GT(m.ascent, m.capHeight);
    EXPECT_GT(m.capHeight, 25);
    EXPECT_GT(m.descent, 0);
    EXPECT_GE(m.lineHeight, 45);
}

TEST(Font, wrapsAtSpaces) {
    const Font font = Font::standard();
    const float width = font.measure("aaaa bbbb", 20).width + 1;
    EXPECT_EQ(font.wrap("aaaa bbbb cccc dddd", 20, width), "aaaa bbbb\ncccc dddd");
    EXPECT_EQ(font.wrap("aaaa\nbbbb", 20, width), "aaaa\nbbbb");
    EXPECT_EQ(font.wrap("oneverylongword", 20, 5), "oneverylongword");
    EXPECT_EQ(font.wrap("", 20, 5), "");
}

TEST(Font, brokenUtf8IsShownNotRefused) {
    const Font font = Font::standard();
    EXPECT_GT(font.measure("ab\xff\xfe\xc3", 20).width, font.measure("ab", 20).width);
    EXPECT_GT(font.measure("Grüße, Привет", 20).width, 50);
}

TEST(Font, extremeSizesAreClamped) {
    const Font font = Font::standard();
    EXPECT_EQ(font.measure("x", -5).width, font.measure("x", Font::minSize).width);
    EXPECT_EQ(font.measure("x", 1e9f).width, font.measure("x", Font::maxSize).width);
    EXPECT_EQ(font.measure("x", std::nanf("")).width, font.measure("x", Font::minSize).width);
}

TEST(Font, glyphsHaveInk) {
    const Font font = Font::standard();
    const auto& line = font.shape("O", 40);
    ASSERT_EQ(line.glyphs.size(), 1u);
    const auto bitmap = font.rasterise(line.glyphs[0].glyph, 40, 0);
    EXPECT_GT(bitmap.width, 10);
    EXPECT_EQ(bitmap.coverage.size(), static_cast<std::size_t>(bitmap.width * bitmap.height));
    EXPECT_NE(font.rasterise(line.glyphs[0].glyph, 40, 2).coverage, bitmap.coverage);
}

TEST(Font, badFilesAreRefused) {
    const TemporaryFolder folder;
    atlax::writeFileAtomic(folder / "bad.ttf", "this is no font");
    EXPECT_THROW(Font::load(folder / "bad.ttf"), atlax::Error);
    EXPECT_THROW(Font::load(folder / "missing.ttf"), atlax::Error);
    EXPECT_THROW(Font::find({"NoSuchFace-Regular"}), atlax::Error);
}

}  // namespace
