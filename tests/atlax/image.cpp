#include <gtest/gtest.h>
#include <turbojpeg.h>

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

// 8 x 8 pixels of one red.
std::vector<std::byte> smallJpeg() {
    const std::unique_ptr<void, decltype([](void* encoder) { tjDestroy(encoder); })> encoder(
        tjInitCompress());
    std::vector<unsigned char> pixels(8 * 8 * 3);
    for (std::size_t i = 0; i < pixels.size(); i += 3) pixels[i] = 200;
    unsigned char* file = nullptr;
    unsigned long size = 0;
    EXPECT_EQ(tjCompress2(encoder.get(), pixels.data(), 8, 0, 8, TJPF_RGB, &file, &size, TJSAMP_444,
                          90, 0),
              0);
    const auto bytes = std::as_bytes(std::span(file, size));
    std::vector<std::byte> out(bytes.begin(), bytes.end());
    tjFree(file);
    return out;
}

TEST(Image, jpegIsReadAndRefusedWhenCutOff) {
    const auto jpeg = smallJpeg();
    const Image image = decodeImage(jpeg, "red.jpg");
    ASSERT_EQ(image.size(), (PixelSize{8, 8}));
    EXPECT_NEAR(image.pixel(4, 4)[0], 200, 4);
    EXPECT_NEAR(image.pixel(4, 4)[1], 0, 4);
    EXPECT_EQ(image.pixel(4, 4)[3], 255);
    for (std::size_t size = 0; size + 4 < jpeg.size(); size += 5)
        EXPECT_THROW(decodeImage(std::span(jpeg).first(size), "cut"), Error) << size;
}

// Found by fuzzing: a reader that takes what follows the end for more chunks never ends.
TEST(Image, aPngThatEndsWithinAChunkIsRefusedAtOnce) {
    auto png = encodePng(pattern());
    png[33 + 3] = std::byte{0xFF};  // the length of the chunk after the header
    EXPECT_THROW(decodeImage(png, "long chunk"), Error);
    png.resize(40);
    EXPECT_THROW(decodeImage(png, "cut"), Error);
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

TEST(Image, svgWithoutASizeHasTheAspectOfItsViewBox) {
    const Image image = decodeSvg(
        bytesOf(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 10"/>)"), {80, 80}, "a");
    EXPECT_EQ(image.size(), (PixelSize{80, 20}));
}

TEST(Image, svgHasStraightAlpha) {
    const Image image =
        decodeSvg(bytesOf(R"(<svg xmlns="http://www.w3.org/2000/svg" width="4" height="4">
<rect width="4" height="4" fill="#ff8000" fill-opacity="0.5"/></svg>)"),
                  {4, 4}, "half");
    const auto pixel = image.pixel(1, 1);
    EXPECT_NEAR(pixel[0], 255, 1);
    EXPECT_NEAR(pixel[1], 128, 2);
    EXPECT_EQ(pixel[2], 0);
    EXPECT_NEAR(pixel[3], 128, 1);
}

TEST(Image, svgReachesNoOtherFile) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "atlax-other.png";
    Image red({2, 2});
    for (int i = 0; i < 4; ++i) red.setPixel(i % 2, i / 2, {255, 0, 0, 255});
    savePng(red, file);
    const std::string text =
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="4" height="4"><image width="4" height="4"
href="file://)" +
        file.string() + R"("/></svg>)";
    const Image image = decodeSvg(bytesOf(text), {4, 4}, "reaching out");
    std::filesystem::remove(file);
    EXPECT_EQ(image.pixel(2, 2)[3], 0);
}

TEST(Image, aRefusedSvgSaysSoInOneSentenceOnly) {
    testing::internal::CaptureStderr();
    try {
        decodeSvg(bytesOf("<?xml version=\"1.0\" encoding=\"EUC-JP\"?>"
                          "<svg xmlns=\"http://www.w3.org/2000/svg\">\x8f\xff\xff</svg>"),
                  {4, 4}, "odd.svg");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).rfind("odd.svg: ", 0), 0u);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Image, brokenSvgIsRefused) {
    EXPECT_THROW(decodeSvg(bytesOf(drawing.substr(0, 90)), {10, 10}, "cut off"), Error);
    EXPECT_THROW(decodeSvg({}, {10, 10}, "empty"), Error);
    EXPECT_THROW(decodeSvg(bytesOf("no drawing"), {10, 10}, "text"), Error);
    EXPECT_THROW(decodeSvg(bytesOf(drawing), {0, 10}, "no size"), Error);
    EXPECT_THROW(decodeSvg(bytesOf(drawing), {10, 100'000}, "too large"), Error);
}

}  // namespace
