#include <gtest/gtest.h>

#include <atlax/animated_png.hpp>
#include <atlax/error.hpp>
#include <string>

namespace {

std::size_t countOf(const std::vector<std::byte>& bytes, const std::string& part) {
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(AnimatedPng, HoldsEveryFrameAndIsAPictureOfTheFirst) {
    atlax::AnimatedPng film(40);
    for (const std::uint8_t level : {10, 100, 200}) {
        atlax::Image frame({6, 4});
        for (int x = 0; x < 6; ++x)
            for (int y = 0; y < 4; ++y) frame.setPixel(x, y, {level, 0, 0, 255});
        film.add(frame);
    }
    EXPECT_EQ(film.frames(), 3);
    const auto bytes = film.bytes();
    EXPECT_EQ(countOf(bytes, "acTL"), 1u);
    EXPECT_EQ(countOf(bytes, "fcTL"), 3u);
    EXPECT_EQ(countOf(bytes, "fdAT"), 2u);
    // Who knows no films checks all sums and shows the first frame.
    const atlax::Image still = atlax::decodeImage(bytes, "film");
    EXPECT_EQ(still.pixel(3, 2)[0], 10);
    EXPECT_THROW(film.add(atlax::Image({6, 5})), atlax::Error);
}

}  // namespace
