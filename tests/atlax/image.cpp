#include <gtest/gtest.h>

#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/image.hpp>
#include <string_view>

#include "temporary_folder.hpp"

namespace {

using namespace atlax;

Image pattern() {
    Image image({17, 9});
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.setPixel(x, y,
                           {static_cast<std::uint8_t>(x * 15), static_cast<std::uint8_t>(y * 28),
                            77, static_cast<std::uint8_t>(255 - x * 10)});
    return image;
}

std::span<const std::byte> bytesOf(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

TEST(Image, pngGoesThereAndBack) {
    const TemporaryFolder folder;
    const Image image = pattern();
    savePng(image, folder / "picture.png");
    const Image back = loadImage(folder / "picture.png");
    ASSERT_EQ(back.size(), image.size());
    EXPECT_TRUE(std::equal(back.bytes().begin(), back.bytes().end(), image.bytes().begin()));
}

TEST(Image, everyCutOffPngIsRefused) {
    const auto png = encodePng(pattern());
    for (std::size_t size = 0; size + 16 < png.size(); size += 3)
        EXPECT_THROW(decodeImage(std::span(png).first(size), "cut"), Error) << size;
}

TEST(Image, aSmallFileCannotAnnounceAHugePicture) {
    auto png = encodePng(pattern());
    png[16] = std::byte{0x7F};  // the width in the header
    EXPECT_THROW(decodeImage(png, "bomb"), Error);
    png[16] = png[17] = png[18] = png[19] = std::byte{0};
    EXPECT_THROW(decodeImage(png, "no width"), Error);
}

TEST(Image, rubbishIsRefusedWithItsName) {
    try {
        decodeImage(bytesOf("this is no picture at all, only text"), "some.png");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).rfind("some.png: ", 0), 0u);
    }
    EXPECT_THROW(decodeImage({}, "empty"), Error);
    EXPECT_THROW(loadImage("/no/such.png"), Error);
    const std::string zeros(10 << 20, '\0');
    EXPECT_THROW(decodeImage(bytesOf(zeros), "zeros"), Error);
}

TEST(Image, sizesAreChecked) {
    EXPECT_THROW(Image({0, 5}), Error);
    EXPECT_THROW(Image({5, -1}), Error);
    EXPECT_THROW(Image({Image::maxSide + 1, 1}), Error);
    Image image({2, 2});
    EXPECT_THROW(image.pixel(2, 0), Error);
    EXPECT_THROW(image.setPixel(0, -1, {}), Error);
    EXPECT_THROW(encodePng(Image()), Error);
}

constexpr std::string_view drawing =
    R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10" width="10" height="10">
<rect x="0" y="0" width="5" height="10" fill="#ff0000"/>
<rect x="5" y="0" width="5" height="10" fill="#0000ff"/></svg>)";

TEST(Image, svgIsRasterisedAtTheSizeAskedFor) {
    for (const int side : {10, 64, 333}) {
        const Image image = decodeSvg(bytesOf(drawing), {side, side}, "drawing");
        ASSERT_EQ(image.size(), (PixelSize{side, side}));
        EXPECT_EQ(image.pixel(side / 4, side / 2), (std::array<std::uint8_t, 4>{255, 0, 0, 255}));
        EXPECT_EQ(image.pixel(side * 3 / 4, side / 2),
                  (std::array<std::uint8_t, 4>{0, 0, 255, 255}));
    }
}

TEST(Image, svgKeepsItsAspect) {
    const Image image = decodeSvg(bytesOf(drawing), {200, 50}, "drawing");
    EXPECT_LE(image.width(), 200);
    EXPECT_LE(image.height(), 50);
    EXPECT_NEAR(image.width(), image.height(), 1);
}

TEST(Image, brokenSvgIsRefused) {
    EXPECT_THROW(decodeSvg(bytesOf("no drawing"), {10, 10}, "text"), Error);
    EXPECT_THROW(decodeSvg(bytesOf(drawing), {0, 10}, "no size"), Error);
    EXPECT_THROW(decodeSvg(bytesOf(drawing), {10, 100'000}, "too large"), Error);
}

}  // namespace
