// Drawings and pictures that become bodies.
#include <gtest/gtest.h>

#include <algorithm>
#include <atlax/image.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "model/drawing.hpp"
#include "model/file_kind.hpp"
#include "model/geometry.hpp"
#include "model/properties.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

constexpr const char* head = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 100 100\">";

Drawing drawn(const std::string& inside, const DrawingOptions& options = {}) {
    return readDrawing(head + inside + "</svg>", "test.svg", options);
}

std::string drawingRefusal(const std::string& text, const DrawingOptions& options = {}) {
    try {
        readDrawing(text, "test.svg", options);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

double areaOf(const Drawing& drawing) {
    double sum = 0;
    for (const DrawnShape& shape : drawing.shapes) sum += momentsOf(shape.region).area;
    return sum;
}

TEST(SvgShapes, EveryElementHasItsArea) {
    const double pi = std::numbers::pi;
    const DrawingOptions fine{.size = 2, .tolerance = 1e-4};
    // The longer side becomes 2 m.
    EXPECT_NEAR(areaOf(drawn("<rect x='10' y='10' width='40' height='20'/>", fine)), 2, 1e-6);
    EXPECT_NEAR(areaOf(drawn("<circle cx='5' cy='5' r='3'/>", fine)), pi, 2e-3);
    EXPECT_NEAR(areaOf(drawn("<ellipse rx='8' ry='4'/>", fine)), pi / 2, 2e-3);
    EXPECT_NEAR(areaOf(drawn("<polygon points='0,0 4,0 0,4'/>", fine)), 2, 1e-6);
    EXPECT_NEAR(areaOf(drawn("<polyline points='0 0 4 0 4 4 0 4'/>", fine)), 4, 1e-6);
    EXPECT_NEAR(areaOf(drawn("<path d='M0 0h4v4h-4z'/>", fine)), 4, 1e-6);
    // Four quarters of a circle of 5 are missing of 20 x 10.
    EXPECT_NEAR(areaOf(drawn("<rect width='20' height='10' rx='5'/>", fine)),
                (200 - (4 - pi) * 25) / 100, 2e-3);
    EXPECT_NEAR(areaOf(drawn("<rect width='1cm' height='10mm'/>", fine)), 4, 1e-6);
}

TEST(SvgShapes, GroupsHandDownTheirTransforms) {
    const Drawing one = drawn(
        "<g transform='translate(100 0)'><g transform='scale(2)'>"
        "<rect id='left' width='10' height='10'/></g>"
        "<rect id='right' x='80' width='20' height='20'/></g>");
    ASSERT_EQ(one.shapes.size(), 2u);
    EXPECT_EQ(one.shapes[0].name, "left");
    // Both are 20 units of 100, which are 2 m, and lie at the ends.
    for (const DrawnShape& shape : one.shapes)
        EXPECT_NEAR(momentsOf(shape.region).area, 0.16, 1e-9);
    EXPECT_NEAR(momentsOf(one.shapes[0].region).centre.x(), -0.8, 1e-9);
    EXPECT_NEAR(momentsOf(one.shapes[1].region).centre.x(), 0.8, 1e-9);
    // y goes up: what is drawn below is below.
    const Drawing two = drawn("<rect width='9' height='1'/><rect y='9' width='1' height='1'/>");
    EXPECT_LT(momentsOf(two.shapes[1].region).centre.y(), 0);
}

TEST(SvgShapes, HolesFollowTheFillRule) {
    // Both squares run in the same sense.
    const std::string path = "M0 0h10v10h-10z M3 3h4v4h-4z";
    const Drawing nonzero = drawn("<path d='" + path + "'/>");
    ASSERT_EQ(nonzero.shapes.size(), 1u);
    EXPECT_TRUE(nonzero.shapes[0].region.holes.empty());
    for (const char* rule : {"fill-rule='evenodd'", "style='fill : red; fill-rule: evenodd'"}) {
        const Drawing evenOdd = drawn("<path " + std::string(rule) + " d='" + path + "'/>");
        ASSERT_EQ(evenOdd.shapes.size(), 1u);
        EXPECT_EQ(evenOdd.shapes[0].region.holes.size(), 1u);
        EXPECT_NEAR(areaOf(evenOdd), 4 * 0.84, 1e-9);
    }
    // An island in the hole is another shape.
    const Drawing island =
        drawn("<g fill-rule='evenodd'><path d='" + path + " M4 4h2v2h-2z'/></g>");
    EXPECT_EQ(island.shapes.size(), 2u);
    EXPECT_NEAR(areaOf(island), 4 * 0.88, 1e-9);
    // Against the sense of the outer one it is a hole by either rule.
    EXPECT_NEAR(areaOf(drawn("<path d='M0 0h10v10h-10z M3 3v4h4v-4z'/>")), 4 * 0.84, 1e-9);
}

TEST(SvgShapes, OnlyWhatIsSeenAndEnclosesSomethingCounts) {
    const Drawing drawing = drawn(
        "<defs><rect width='50' height='50'/></defs><clipPath><circle r='9'/></clipPath>"
        "<rect display='none' width='90' height='1'/><g style='display:none'><circle r='8'/></g>"
        "<path fill='none' d='M0 0L50 50L0 50'/><use href='#a'/><text>hello</text>"
        "<rect id='seen' fill='#1f4' width='10' height='10'/>");
    ASSERT_EQ(drawing.shapes.size(), 1u);
    EXPECT_EQ(drawing.shapes[0].name, "seen");
    EXPECT_EQ(drawing.shapes[0].colour, "#11ff44");
    EXPECT_EQ(drawing.leftOut.size(), 3u);  // the open line, the use, the text
}

TEST(SvgShapes, WhatCannotBeUsedIsToldWithItsReason) {
    EXPECT_NE(drawingRefusal("hello").find("test.svg: is not well-formed"), std::string::npos);
    EXPECT_NE(drawingRefusal("<svg><rect></svg>").find("line 1"), std::string::npos);
    EXPECT_EQ(drawingRefusal("<html/>"), "test.svg: is XML, but no SVG drawing");
    EXPECT_EQ(drawingRefusal("<svg/>"), "test.svg: holds no closed outline");
    EXPECT_EQ(drawingRefusal("<svg>\n<path id='p' d='M0 0 L1'/></svg>"),
              "test.svg: holds no closed outline (p, line 2: character 8: a number is missing)");
    EXPECT_EQ(drawingRefusal("<svg><rect width='1' height='9%'/></svg>"),
              "test.svg: holds no closed outline (rect, line 1: height is \"9%\"; allowed is a "
              "number, also with px, mm, cm, in, pt or pc)");
    EXPECT_EQ(drawingRefusal("<svg/>", {.size = 1000}), "the size must be 0.01 m to 100 m");
    EXPECT_NE(drawingRefusal("\x1F\x8B").find("compressed"), std::string::npos);
}

TEST(SvgShapes, HostileDrawingsAreBounded) {
    std::string deep = "<svg>";
    for (int i = 0; i < 150; ++i) deep += "<g>";
    EXPECT_NE(drawingRefusal(deep + "<rect width='1' height='1'/>").find("test.svg"),
              std::string::npos);
    for (int i = 0; i < 150; ++i) deep += "</g>";
    EXPECT_NE(drawingRefusal(deep + "</svg>").find("more than 100 groups"), std::string::npos);
    std::string many = "<svg>";
    for (int i = 0; i < 20'001; ++i) many += "<g/>";
    EXPECT_NE(drawingRefusal(many + "</svg>").find("more than 20000 elements"), std::string::npos);
    std::string shapes = "<svg>";
    for (int i = 0; i < 501; ++i) shapes += "<rect width='1' height='1'/>";
    EXPECT_NE(drawingRefusal(shapes + "</svg>").find("more than 500 shapes"), std::string::npos);
    EXPECT_NE(drawingRefusal(std::string(5 << 20, ' ')).find("allowed are at most"),
              std::string::npos);
    // An entity that would grow is not replaced, and no file is read.
    EXPECT_NE(
        drawingRefusal("<!DOCTYPE svg [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;'>"
                       "<!ENTITY c SYSTEM 'file:///etc/passwd'>]><svg><text>&b;&c;</text></svg>"),
        "");
    std::string rings = "<svg><path d='";
    for (int i = 0; i < 201; ++i) rings += "M0 0h1v1z";
    EXPECT_NE(drawingRefusal(rings + "'/></svg>").find("201 outlines"), std::string::npos);
}

// --- regions and bodies ----------------------------------------------------------------------

// A frame of 2 m x 2 m with a window of 1 m x 1 m.
Region frame() {
    return {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},
            {{{-0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}}}};
}

TEST(SvgShapes, AKeyholeHasTheAreaOfTheRegion) {
    Region region = frame();
    region.holes.push_back({{0.6, 0.6}, {0.6, 0.9}, {0.9, 0.9}, {0.9, 0.6}});
    EXPECT_NEAR(momentsOf(region).area, 4 - 1 - 0.09, 1e-12);
    const Outline one = keyholed(region, 1e-3);
    EXPECT_EQ(one.size(), 12u + 4u);
    EXPECT_FALSE(meetsItself(one));
    EXPECT_NEAR(areaWithin(one), momentsOf(region).area, 2e-3);
}

TEST(SvgShapes, ARigidBodyHasTheInertiaOfItsArea) {
    const auto prefab = bodyOf(frame(), OutlineKind::rigid);
    double mass = 0, inertia = 0;
    for (const auto& particle : prefab.blueprint.particles) {
        mass += static_cast<double>(particle.mass);
        inertia +=
            static_cast<double>(particle.mass) * particle.position.cast<double>().squaredNorm();
    }
    EXPECT_NEAR(mass, 3 * outlineMassPerArea, 1e-4);
    // (m w^2 / 6) of the square less that of the window.
    EXPECT_NEAR(inertia, outlineMassPerArea * (4.0 * 4 / 6 - 1.0 / 6), 2e-3);
    EXPECT_NEAR(prefab.blueprint.centreOfMass().norm(), 0, 1e-4);
}

// What is in the hole touches its side, and does not fall through it.
TEST(SvgShapes, AHoleIsHollow) {
    Document document;
    std::vector<std::string> leftOut;
    BodyId hollow, ball;
    document.edit("Import", [&] {
        hollow =
            addShapes(document, {{"frame", frame()}}, OutlineKind::rigid, {0, 1.2}, leftOut)[0];
        ball = document.add("ball", sulfur::shapes::BallOptions{.radius = 0.2f}, {{0, 1.2}, 0});
    });
    EXPECT_TRUE(leftOut.empty());
    for (int i = 0; i < 1500; ++i) document.tick();
    const double lower = document.world().bounds(hollow).low.y();
    EXPECT_NEAR(lower, 0.05, 0.01);  // on the floor, which is 5 cm thick
    EXPECT_NEAR(document.world().centreOfMass(ball).y(), lower + 0.5 + 0.2, 0.02);
}

TEST(SvgShapes, SoftBodiesAreLatticesWithTheirHoles) {
    const auto prefab = bodyOf(frame(), OutlineKind::soft);
    EXPECT_NEAR(static_cast<double>(prefab.blueprint.mass()), 3 * outlineMassPerArea, 1e-3);
    EXPECT_GT(prefab.blueprint.particles.size(), 40u);
    for (const auto& joint : prefab.blueprint.joints) {
        EXPECT_TRUE(std::isfinite(joint.stiffness));
        const auto middle = (prefab.blueprint.particles[joint.a].position +
                             prefab.blueprint.particles[joint.b].position) /
                            2;
        EXPECT_GT(middle.cwiseAbs().maxCoeff(), 0.42) << "a spring crosses the window";
    }
}

TEST(SvgShapes, ADrawingBecomesBodiesInOneStep) {
    Document document;
    const Drawing drawing = drawn(
        "<rect id='box' fill='#ff8800' width='20' height='10'/>"
        "<circle id='round' cx='80' cy='5' r='5'/>"
        "<polygon id='bow' points='0,50 20,70 20,50 0,70'/>",
        {.size = 5});
    std::vector<std::string> leftOut = drawing.leftOut;
    std::vector<BodyId> made;
    document.edit("Import", [&] {
        made = addShapes(document, drawing.shapes, OutlineKind::fixed, {0, 3}, leftOut);
    });
    ASSERT_EQ(made.size(), 2u);
    ASSERT_EQ(leftOut.size(), 1u);
    EXPECT_EQ(leftOut[0].substr(0, 5), "bow: ");
    EXPECT_EQ(document.world().kind(document.bodyOf("round")), sulfur::BodyKind::fixed);
    EXPECT_EQ(colourOf(document.plan().body("box")), "#ff8800");
    const auto bounds = document.world().bounds(document.bodyOf("box"));
    EXPECT_NEAR(bounds.high.x() - bounds.low.x(), 20 * 5.0 / 85, 0.01);
    document.undo();
    EXPECT_FALSE(document.plan().contains("box"));
}

TEST(SvgShapes, ALargeOutlineIsMadeSimpler) {
    Region region;
    for (int i = 0; i < 3000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 3000;
        const double radius = 1 + 0.05 * std::sin(40 * angle);
        region.outer.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    const auto prefab = bodyOf(region, OutlineKind::rigid);
    EXPECT_LE(prefab.blueprint.particles.size(), 203u);
    EXPECT_GT(prefab.blueprint.particles.size(), 60u);
}

// --- pictures --------------------------------------------------------------------------------

atlax::Image picture(int side, const std::function<bool(double, double)>& opaque) {
    atlax::Image image({side, side});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            if (opaque(x + 0.5, y + 0.5)) image.setPixel(x, y, {200, 100, 50, 255});
    return image;
}

TEST(SvgShapes, APictureHasTheOutlineOfItsOpaquePart) {
    const auto disc = [](double x, double y) { return std::hypot(x - 60, y - 40) < 30; };
    const Drawing round = traced(picture(120, disc), "disc.png", {.size = 2});
    ASSERT_EQ(round.shapes.size(), 1u);
    EXPECT_EQ(round.shapes[0].name, "disc");
    EXPECT_NEAR(momentsOf(round.shapes[0].region).area, std::numbers::pi, 0.15);
    EXPECT_NEAR(momentsOf(round.shapes[0].region).centre.norm(), 0, 0.02);
    EXPECT_LT(round.shapes[0].region.outer.size(), 60u);

    const Drawing ring = traced(
        picture(120,
                [&](double x, double y) { return disc(x, y) && std::hypot(x - 60, y - 40) > 15; }),
        "ring.png", {.size = 2});
    ASSERT_EQ(ring.shapes.size(), 1u);
    EXPECT_EQ(ring.shapes[0].region.holes.size(), 1u);
    EXPECT_NEAR(areaOf(ring), std::numbers::pi * 0.75, 0.15);
    EXPECT_NO_THROW(bodyOf(ring.shapes[0].region, OutlineKind::rigid));
}

TEST(SvgShapes, LargePicturesAreTracedInSteps) {
    const Drawing half =
        traced(picture(2000, [](double x, double) { return x < 1000; }), "half.png", {.size = 1});
    ASSERT_EQ(half.shapes.size(), 1u);
    EXPECT_EQ(half.shapes[0].region.outer.size(), 4u);
    EXPECT_NEAR(areaOf(half), 0.5, 0.02);
}

TEST(SvgShapes, PicturesWithoutAnOutlineAreRefused) {
    const auto problem = [](const atlax::Image& image) -> std::string {
        try {
            traced(image, "a.png", {});
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(problem(picture(20, [](double, double) { return true; })).find("no transparent part"),
              std::string::npos);
    EXPECT_EQ(problem(picture(20, [](double, double) { return false; })),
              "a.png: is wholly transparent");
    EXPECT_EQ(problem(picture(200, [](double x, double y) { return x < 2 && y < 2; })),
              "a.png: has only specks that are opaque");
}

TEST(SvgShapes, FilesAreKnownByWhatTheyHold) {
    EXPECT_EQ(kindOfBytes("\x89PNG\r\n\x1A\n"), FileKind::picture);
    EXPECT_EQ(kindOfBytes("\xEF\xBB\xBF  <!-- a --><svg>"), FileKind::drawing);
    EXPECT_EQ(kindOfBytes("<?xml version=\"1.0\"?>"), FileKind::drawing);
    EXPECT_EQ(kindOfBytes("{\n \"format\": \"sulfur-scene\","), FileKind::scene);
    EXPECT_EQ(kindOfBytes("{\"format\": \"sulfur-blueprint\"}"), FileKind::blueprint);
    EXPECT_EQ(kindOfBytes("{}"), FileKind::other);
    EXPECT_EQ(kindOfBytes(""), FileKind::other);
    EXPECT_THROW(kindOfFile("/"), std::runtime_error);
}

}  // namespace
}  // namespace sulfurchamber
