// What the eye reads: meters with their numbers, arrows of forces, and the legend.
#include <gtest/gtest.h>

#include <algorithm>
#include <atlax/offscreen.hpp>
#include <cmath>

#include "view/force_painter.hpp"
#include "view/meter_painter.hpp"
#include "view/palette.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

constexpr int paper = 400;

struct Painted {
    atlax::Image image;
    std::vector<atlax::DrawnText> texts;

    bool says(const std::string& words) const {
        return std::any_of(texts.begin(), texts.end(),
                           [&](const atlax::DrawnText& one) { return one.text == words; });
    }
    int count(const atlax::Color& colour) const {
        int found = 0;
        for (int y = 0; y < paper; ++y)
            for (int x = 0; x < paper; ++x) {
                const auto p = image.pixel(x, y);
                found += std::abs(p[0] - colour.r * 255) < 30 &&
                                 std::abs(p[1] - colour.g * 255) < 30 &&
                                 std::abs(p[2] - colour.b * 255) < 30
                             ? 1
                             : 0;
            }
        return found;
    }
};

const atlax::Camera camera{{0, 2}, 80};

Painted painted(const std::function<void(atlax::Canvas&, const atlax::Font&)>& paint) {
    atlax::OffscreenCanvas offscreen({paper, paper});
    const atlax::Font font = atlax::Font::standard();
    atlax::Canvas& canvas = offscreen.begin();
    canvas.recordTexts(true);
    canvas.clear(atlax::colors::black);
    canvas.setCamera(camera);
    paint(canvas, font);
    Painted result;
    result.texts = canvas.recordedTexts();
    offscreen.finish();
    result.image = offscreen.image();
    return result;
}

Painted meterPicture(const Workbench& bench) {
    return painted([&](atlax::Canvas& canvas, const atlax::Font& font) {
        paintMeters(canvas, camera, font, bench, 1);
    });
}

void placeMeter(Workbench& bench, ToolKind tool, const Point& from, const Point& to) {
    bench.setTool(tool);
    bench.press({.position = from});
    bench.move({.position = to});
    bench.release({.position = to});
}

// A crate of 4 kg that lies on the floor.
void layCrate(Workbench& bench) {
    placeMeter(bench, ToolKind::box, {-0.5, 0.05}, {0.5, 1.05});
    for (int i = 0; i < 600; ++i) bench.tick();
}

TEST(MeasurePainters, ARulerTellsItsLength) {
    Workbench bench;
    EXPECT_EQ(meterPicture(bench).count(palette::amber), 0);
    placeMeter(bench, ToolKind::measure, {-1, 2}, {0.5, 2});
    bench.select({});
    const Painted picture = meterPicture(bench);
    EXPECT_TRUE(picture.says("1.500 m"));
    EXPECT_GT(picture.count(palette::amber), 200);
    // What is selected has handles and another colour.
    bench.selectMeters({"ruler"});
    EXPECT_GT(meterPicture(bench).count(palette::ice), 200);
}

TEST(MeasurePainters, AProtractorTellsItsAngle) {
    Workbench bench;
    placeMeter(bench, ToolKind::protractor, {-1, 1}, {1, 1});
    bench.press({.position = {1, 3}});
    bench.release({.position = {1, 3}});
    bench.select({});
    const Painted picture = meterPicture(bench);
    EXPECT_TRUE(picture.says("45.0\xC2\xB0"));
    EXPECT_GT(picture.count(palette::amber), 200);
}

TEST(MeasurePainters, AGaugeHasAScaleAndANeedle) {
    Workbench bench;
    layCrate(bench);
    bench.setTool(ToolKind::gauge);
    bench.press({.position = {0, 0.5}});
    bench.release({.position = {0, 0.5}});
    bench.tick();
    const Painted picture = meterPicture(bench);
    const auto& meter = bench.meters().all().at(0);
    EXPECT_TRUE(picture.says(meterText(bench.meters(), meter)));
    EXPECT_NE(meterText(bench.meters(), meter).find(" N"), std::string::npos);
    EXPECT_TRUE(picture.says("50")) << "4 kg weigh 39 N";
    EXPECT_GT(picture.count(palette::hot), 10);
}

TEST(MeasurePainters, AGunSeesWhatIsInItsBeam) {
    Workbench bench;
    layCrate(bench);
    placeMeter(bench, ToolKind::gun, {-2, 3}, {2, 3});
    EXPECT_TRUE(meterPicture(bench).says("\xE2\x80\x93"));
    EXPECT_EQ(meterPicture(bench).count(palette::hot), 0);
    placeMeter(bench, ToolKind::gun, {-2, 0.6}, {2, 0.6});
    EXPECT_TRUE(meterPicture(bench).says("0.00 m/s"));
    EXPECT_GT(meterPicture(bench).count(palette::hot), 20);
}

TEST(MeasurePainters, ATracerLeavesALine) {
    Workbench bench;
    placeMeter(bench, ToolKind::ball, {0, 3.4}, {0.2, 3.4});
    bench.setTool(ToolKind::tracer);
    bench.press({.position = {0, 3.4}});
    bench.release({.position = {0, 3.4}});
    bench.select({});
    bench.document().startTime();
    const int before = meterPicture(bench).count(palette::amber);
    for (int i = 0; i < 300; ++i) bench.tick();
    EXPECT_GT(meterPicture(bench).count(palette::amber), before + 60);
}

TEST(MeasurePainters, ForcesAreArrowsWithALegend) {
    Workbench bench;
    layCrate(bench);
    const auto& world = bench.document().world();
    const auto picture = [&](const ViewOptions& options) {
        return painted([&](atlax::Canvas& canvas, const atlax::Font& font) {
            paintForces(canvas, camera, world, options);
            paintLegend(canvas, camera, font, world, options);
        });
    };
    const Painted none = picture({});
    EXPECT_EQ(none.count(palette::hot), 0);
    EXPECT_TRUE(none.texts.empty());
    ViewOptions options;
    options.contactForces = true;
    const Painted contacts = picture(options);
    EXPECT_GT(contacts.count(palette::hot), 100);
    EXPECT_TRUE(contacts.says("Contact"));
    EXPECT_TRUE(contacts.says("20 N")) << "of 39 N, which are 70 pixels";
    options.gravity = true;
    const Painted both = picture(options);
    EXPECT_TRUE(both.says("Weight"));
    // The weight of 39 N is 70 pixels long.
    EXPECT_NEAR(
        pixelsPerNewton(world) * static_cast<double>(world.mass(world.bodies().back())) * 9.81, 70,
        1e-3);
    EXPECT_GT(both.count(palette::ice), 100);
}

TEST(MeasurePainters, StrainHasALegendOfItsColours) {
    Workbench bench;
    ViewOptions options;
    options.strain = true;
    const Painted picture = painted([&](atlax::Canvas& canvas, const atlax::Font& font) {
        paintLegend(canvas, camera, font, bench.document().world(), options);
    });
    EXPECT_TRUE(picture.says("-8 %"));
    EXPECT_TRUE(picture.says("+8 %"));
    EXPECT_GT(picture.count(strainColour(-0.077f)), 10);
    EXPECT_GT(picture.count(strainColour(0.077f)), 10);
    EXPECT_GT(picture.count(strainColour(0.04f)), 10);
}

}  // namespace
}  // namespace sulfurchamber
