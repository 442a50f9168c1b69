// Diagrams: round numbers, zoom, scales and what is read from them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "view/plot_layout.hpp"

namespace sulfurchamber {
namespace {

Series ramp(const char* key, double slope, double seconds = 10) {
    Series series{{}, 0, "box", quantity(key), {}};
    for (int i = 0; i <= static_cast<int>(seconds * 500); ++i)
        series.samples.push_back({i * 0.002, slope * i * 0.002});
    return series;
}

TEST(Plot, NumbersAreRoundAndWithinTheRange) {
    EXPECT_EQ(roundNumbers(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(roundNumbers(-1.2, 1.2, 5), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
    EXPECT_EQ(roundNumbers(3, 3, 5), std::vector<double>{});
    for (const double size : {1e-6, 0.03, 7.0, 1234.0, 1e9}) {
        const auto numbers = roundNumbers(-size, size, 6);
        EXPECT_GE(numbers.size(), 3u);
        EXPECT_LE(numbers.size(), 7u);
    }
    EXPECT_EQ(numberText(0.5, 0.5), "0.5");
    EXPECT_EQ(numberText(-20, 10), "-20");
    EXPECT_EQ(numberText(0.25, 0.05), "0.25");
    EXPECT_EQ(numberText(2e6, 1e6), "2e+06");
}

TEST(Plot, ZoomKeepsTheTimeUnderThePointerAndEndsAtTheWhole) {
    const std::vector<Series> series{ramp("height", 1)};
    PlotRange range;
    EXPECT_EQ(range.shown(series), (std::pair<double, double>{0, 10}));
    range.zoom(series, 0.5, 4);
    EXPECT_TRUE(range.zoomed());
    EXPECT_DOUBLE_EQ(range.shown(series).first, 2);
    EXPECT_DOUBLE_EQ(range.shown(series).second, 7);
    for (int i = 0; i < 50; ++i) range.zoom(series, 0.5, 4);
    EXPECT_GE(range.shown(series).second - range.shown(series).first, 0.01);
    for (int i = 0; i < 50; ++i) range.zoom(series, 2, 4);
    EXPECT_FALSE(range.zoomed());
    range.show(6, 5);
    EXPECT_EQ(range.shown(series), (std::pair<double, double>{5, 6}));
    range.show(5, 5);  // no time at all
    EXPECT_FALSE(range.zoomed());
    EXPECT_EQ(PlotRange::whole({}), (std::pair<double, double>{0, 1}));
}

TEST(Plot, UnitsHaveScalesOfTheirOwn) {
    const std::vector<Series> series{ramp("height", 1), ramp("speed", 100), ramp("x", -2)};
    ASSERT_EQ(unitsOf(series).size(), 2u);
    const auto [low, high] = valuesOf(series, "m", {0, 10});
    EXPECT_LT(low, -20);
    EXPECT_GT(low, -23);
    EXPECT_GT(high, 10);
    const auto part = valuesOf(series, "m/s", {0, 1});
    EXPECT_GT(part.second, 100);
    EXPECT_LT(part.second, 110);
    EXPECT_EQ(valuesOf({}, "m", {0, 1}), (std::pair<double, double>{0, 1}));
}

TEST(Plot, FitsTellWhatIsShown) {
    const Series series = ramp("velocity-y", -9.81);
    EXPECT_EQ(fitted(series, {1, 2}, FitKind::line)->text, "slope -9.81 m/s per s");
    EXPECT_EQ(fitted(series, {1, 2}, FitKind::mean)->text, "mean -14.71 m/s");
    EXPECT_NEAR(fitted(series, {1, 2}, FitKind::line)->at(5), -49.05, 1e-6);
    EXPECT_FALSE(fitted(series, {1, 2}, FitKind::none));
    EXPECT_FALSE(fitted(series, {20, 30}, FitKind::mean));
    Series wave{{}, 0, "bob", quantity("x"), {}};
    for (int i = 0; i < 5000; ++i) wave.samples.push_back({i * 0.002, 0.1 * std::sin(i * 0.01)});
    EXPECT_EQ(fitted(wave, {0, 10}, FitKind::sine)->text,
              "sine 0.7958 Hz, \xC2\xB1"
              "0.1 m");
}

// Seven pixels for each character.
double widthOf(const std::string& text) {
    return 7.0 * static_cast<double>(std::count_if(text.begin(), text.end(), [](char byte) {
               return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
           }));
}

TEST(Plot, TheLegendKeepsToItsWidthAndItsLines) {
    std::vector<Series> series;
    for (const char* subject : {"car", "polygon", "wheel", "wheel2"})
        for (const char* key : {"x", "height", "speed"})
            series.push_back({{}, 0, subject, quantity(key), {}});
    const std::vector<std::string> values(series.size(), ": -3.25 m");
    std::vector<std::string> fits(series.size());
    for (const double width : {110.0, 180.0, 400.0})
        for (const std::size_t most : {1u, 4u, 7u, 12u, 30u}) {
            const auto lines = legendLines(series, values, fits, width, most, widthOf);
            ASSERT_LE(lines.size(), most);
            std::size_t told = 0;
            for (const LegendLine& line : lines) {
                EXPECT_LE(widthOf(line.text), width) << line.text;
                if (!line.series) continue;
                EXPECT_EQ(*line.series, told++);
                EXPECT_TRUE(line.text.ends_with(values[0])) << line.text;
            }
            if (told < series.size()) {
                EXPECT_EQ(lines.back().text, "+" + std::to_string(series.size() - told));
            }
        }
    // With room titles are whole; without it only what differs is told.
    EXPECT_EQ(legendLines(series, values, fits, 400, 30, widthOf)[3].text,
              series[3].title() + values[3]);
    const std::span<const Series> one(series.data(), 3);
    EXPECT_EQ(legendLines(one, values, fits, 150, 30, widthOf)[1].text, "Height: -3.25 m");
    std::vector<Series> heights{series[1], series[4]};
    EXPECT_EQ(legendLines(heights, values, fits, 120, 30, widthOf)[1].text, "polygon: -3.25 m");
    // A fit that has no room beside the value has a line of its own.
    fits[0] = "slope -9.81 m/s per s";
    const auto fitted = legendLines(one, values, fits, 200, 30, widthOf);
    ASSERT_EQ(fitted.size(), 4u);
    EXPECT_EQ(fitted[1].series, 0u);
    EXPECT_EQ(fitted[1].text, "   " + fits[0]);
}

TEST(Plot, ACurveLosesNoPeak) {
    Series series = ramp("height", 0);
    series.samples[2345].value = 7;
    const PlotScale time{0, 10, 0, 300};
    const PlotScale values{0, 10, 200, 0};
    const auto points = curve(series.samples, time, values);
    EXPECT_LE(points.size(), 602u);
    double top = 200;
    for (const auto& [x, y] : points) top = std::min(top, y);
    EXPECT_DOUBLE_EQ(top, values.pixel(7));
    EXPECT_DOUBLE_EQ(time.value(time.pixel(4.5)), 4.5);
}

TEST(Plot, ACurveOverAnEmptyRangeEnds) {
    const Series series = ramp("height", 1);
    const auto points = curve(series.samples, {5, 5, 0, 300}, {0, 10, 200, 0});
    EXPECT_LE(points.size(), series.samples.size());
}

}  // namespace
}  // namespace sulfurchamber
