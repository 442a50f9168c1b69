// Snapping of what is drawn and moved, and what is told while one draws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/transform.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

using Kind = SnapPlace::Kind;
constexpr double reach = 0.1;

BodyId box(Workbench& bench, const Point& at, const Point& size = {1, 1}, double angle = 0) {
    Document& document = bench.document();
    document.edit("Add box", [&] {
        document.add("box", sulfur::shapes::BoxOptions{.size = size.cast<sulfur::Real>()},
                     {.position = at, .angle = angle});
    });
    return document.world().bodies().back();
}

Pointer at(const Point& place) {
    return {.position = place, .reach = reach};
}

TEST(Snapping, CornersAreThoseThatOneSees) {
    Workbench bench;
    const BodyId square = box(bench, {2, 3}, {2, 1});
    const auto places =
        snapPlaces(bench.document().world(), square, {.corners = true, .centres = true});
    ASSERT_EQ(places.size(), 5u);
    for (const Point& corner : {Point(1, 2.5), Point(3, 2.5), Point(3, 3.5), Point(1, 3.5)})
        EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&](const SnapPlace& place) {
            return place.kind == Kind::corner && (place.at - corner).norm() < 1e-4;
        })) << corner.transpose();
    EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&](const SnapPlace& place) {
        return place.kind == Kind::centre && (place.at - Point(2, 3)).norm() < 1e-4;
    }));
}

TEST(Snapping, APointGoesToTheNearestOfWhatIsOn) {
    Workbench bench;
    box(bench, {2, 3});
    const auto& world = bench.document().world();
    const auto snap = [&](const Point& point, const SnapOptions& options) {
        return snapPoint(world, point, reach, options);
    };
    EXPECT_FALSE(snap({1.55, 2.55}, {}).place);
    const auto corner = snap({1.55, 2.55}, {.corners = true});
    EXPECT_LT((corner.point - Point(1.5, 2.5)).norm(), 1e-4);
    EXPECT_EQ(corner.place->kind, Kind::corner);
    EXPECT_FALSE(snap({1.7, 2.7}, {.corners = true}).place) << "out of reach";
    EXPECT_FALSE(snap({2.04, 3.05}, {.corners = true}).place);
    EXPECT_EQ(snap({2.04, 3.05}, {.centres = true}).place->kind, Kind::centre);
    const auto grid = snap({1.7, 2.8}, {.grid = 0.5, .corners = true});
    EXPECT_LT((grid.point - Point(1.5, 3)).norm(), 1e-9);
    EXPECT_EQ(grid.place->kind, Kind::grid);
}

TEST(Snapping, LinesGoInStepsOfFifteenDegrees) {
    Workbench bench;
    const auto& world = bench.document().world();
    const auto snap = [&](double degrees) {
        const double angle = degrees * 3.14159265358979 / 180;
        return snapPoint(world, Point(0, 5) + 2 * Point(std::cos(angle), std::sin(angle)), reach,
                         {.angles = true}, Point(0, 5));
    };
    const auto found = snap(46);
    ASSERT_TRUE(found.place);
    EXPECT_EQ(found.place->kind, Kind::angle);
    EXPECT_NEAR(directionOf(found.point - Point(0, 5)), 3.14159265358979 / 4, 1e-9);
    EXPECT_NEAR((found.point - Point(0, 5)).norm(), 2, 0.01);
    EXPECT_FALSE(snap(52).place) << "in between one is free";
    bench.setTool(ToolKind::ground);
    bench.setSnapping({.angles = true});
    bench.press(at({0, 5}));
    bench.move(at({3, 5.05}));
    ASSERT_TRUE(bench.snapMark());
    EXPECT_EQ(bench.snapMark()->kind, Kind::angle);
    bench.release(at({3, 5.05}));
    EXPECT_FALSE(bench.snapMark());
    const auto& document = bench.document();
    const auto particles = world.particles(document.bodyOf("ground"));
    EXPECT_NEAR(world.position(particles[1]).y(), 5, 1e-5);
}

TEST(Snapping, ACreatingToolShowsWhereItWouldBegin) {
    Workbench bench;
    box(bench, {2, 3});
    bench.setTool(ToolKind::box);
    bench.setSnapping({.corners = true});
    bench.move(at({2.46, 3.53}));
    ASSERT_TRUE(bench.snapMark());
    EXPECT_LT((bench.snapMark()->at - Point(2.5, 3.5)).norm(), 1e-4);
    bench.press(at({2.46, 3.53}));
    bench.move(at({4, 5}));
    bench.release(at({4, 5}));
    const auto bounds = bench.document().world().bounds(bench.document().world().bodies().back());
    EXPECT_LT((bounds.low - Point(2.5, 3.5)).norm(), 1e-4) << "corner on corner";
}

TEST(Snapping, WhatIsMovedGoesToCornersOfOthers) {
    Workbench bench;
    box(bench, {2, 3});
    const BodyId other = box(bench, {-2, 2.2});
    bench.setSnapping({.corners = true, .centres = true});
    bench.press(at({-2, 2.2}));
    bench.move(at({0, 2.5}));
    const Point beside = Point(0.96, 3.05);
    bench.move(at(beside));
    ASSERT_TRUE(bench.snapMark());
    EXPECT_EQ(bench.snapMark()->kind, Kind::corner);
    bench.release(at(beside));
    EXPECT_LT((bench.document().world().centreOfMass(other) - Point(1, 3)).norm(), 1e-3)
        << "side by side";
    // Off the others it is where the pointer has it, to the end.
    bench.press(at({1, 3}));
    bench.move(at({1.02, 3}));
    bench.move(at({-2.3, 4.7}));
    bench.release(at({-2.3, 4.7}));
    const BodyId now = bench.selection().front();
    EXPECT_LT((bench.document().world().centreOfMass(now) - Point(-2.3, 4.7)).norm(), 1e-3);
}

TEST(Snapping, OnTheGridTheLowerLeftCornerMoves) {
    Workbench bench;
    box(bench, {2.13, 3.07});
    bench.setSnapping({.grid = 0.5});
    bench.press(at({2.13, 3.07}));
    bench.move(at({2.33, 3.2}));
    bench.release(at({2.33, 3.2}));
    const auto bounds = *selectionBounds(bench);
    EXPECT_NEAR(std::remainder(bounds.low.x(), 0.5), 0, 1e-4);
    EXPECT_NEAR(std::remainder(bounds.low.y(), 0.5), 0, 1e-4);
}

TEST(Snapping, ACornerThatIsDraggedGoesToOthers) {
    Workbench bench;
    box(bench, {3, 3});
    const BodyId small = box(bench, {0, 3});
    bench.select({small});
    bench.setSnapping({.corners = true});
    const Handle side = handlesOf(*selectionFrame(bench), reach)[2];
    // The upper left corner of the other one is at 2.5, 3.5: the diagonal leads elsewhere.
    const Point to = side.at + Point(2.5, 3.5) - Point(0.5, 3.5) + Point(0.04, 0.03);
    bench.press(at(side.at));
    bench.move(at(to));
    ASSERT_TRUE(bench.snapMark());
    EXPECT_LT((bench.snapMark()->at - Point(2.5, 3.5)).norm(), 1e-4);
    bench.cancel();
    EXPECT_FALSE(bench.snapMark());
}

TEST(Snapping, HiddenBodiesDoNotCatch) {
    Workbench bench;
    const BodyId other = box(bench, {2, 3});
    setHidden(bench, {{other}}, true);
    bench.setTool(ToolKind::box);
    bench.setSnapping({.corners = true});
    bench.move(at({2.46, 3.53}));
    EXPECT_FALSE(bench.snapMark());
}

std::vector<std::string> textsOf(const Workbench& bench) {
    std::vector<std::string> texts;
    for (const Label& label : bench.preview().labels) texts.push_back(label.text);
    return texts;
}

using Texts = std::vector<std::string>;

TEST(LiveMeasures, TellSizeAndMassWhileOneDraws) {
    Workbench bench;
    const auto draw = [&](ToolKind tool, const Point& to) {
        bench.setTool(tool);
        bench.press(at({0, 1}));
        bench.move(at(to));
        return textsOf(bench);
    };
    EXPECT_EQ(draw(ToolKind::box, {1.2, 1.5}), (Texts{"1.20 m", "0.50 m", "2.40 kg"}));
    EXPECT_EQ(draw(ToolKind::wall, {2, 2}), (Texts{"2.00 m", "1.00 m", "30 kg"}));
    EXPECT_EQ(draw(ToolKind::ball, {0.5, 1}), (Texts{"radius 0.50 m", "3.14 kg"}));
    EXPECT_EQ(draw(ToolKind::rope, {2, 3}), (Texts{"2.83 m  45.0\xC2\xB0  1.13 kg"}));
    EXPECT_EQ(draw(ToolKind::ground, {2, 1}), (Texts{"2.00 m  0.0\xC2\xB0"}));
    bench.cancel();
    EXPECT_TRUE(textsOf(bench).empty());
}

TEST(LiveMeasures, WhatTheyTellIsWhatIsMade) {
    for (const ToolKind tool :
         {ToolKind::box, ToolKind::ball, ToolKind::jelly, ToolKind::wheel, ToolKind::rope,
          ToolKind::chain, ToolKind::bridge, ToolKind::cloth, ToolKind::wall}) {
        Workbench bench;
        bench.setTool(tool);
        bench.press(at({0, 3}));
        bench.move(at({1.3, 4.1}));
        const std::string last = textsOf(bench).back();
        bench.release(at({1.3, 4.1}));
        const auto& world = bench.document().world();
        const std::string mass =
            kilogramsText(static_cast<double>(world.mass(world.bodies().back())));
        EXPECT_TRUE(last.ends_with(mass)) << toolName(tool) << ": " << last << ", " << mass;
    }
}

TEST(LiveMeasures, TellWhatAPolygonWillWeigh) {
    Workbench bench;
    bench.setTool(ToolKind::polygon);
    for (const Point& corner : {Point(0, 1), Point(2, 1)}) {
        bench.press(at(corner));
        bench.release(at(corner));
    }
    bench.move(at({2, 2}));
    EXPECT_EQ(textsOf(bench), (Texts{"1.00 m  90.0\xC2\xB0", "4.00 kg"}));
}

TEST(LiveMeasures, TellWhatAStretchedBodyWillBe) {
    Workbench bench;
    bench.select({box(bench, {0, 3})});
    const Handle side = handlesOf(*selectionFrame(bench), reach)[5];
    bench.press(at(side.at));
    bench.move(at(side.at + Point(0.5, 0.3)));
    EXPECT_EQ(textsOf(bench), (Texts{"1.50 m", "1.00 m", "1.50 kg"}));
    bench.release(at(side.at + Point(0.5, 0.3)));
    EXPECT_NEAR(static_cast<double>(bench.document().world().mass(bench.selection()[0])), 1.5,
                1e-4);
    const Handle knob = handlesOf(*selectionFrame(bench), reach)[8];
    bench.press(at(knob.at));
    bench.move({.position = knob.at + Point(0.6, 0), .reach = reach, .shift = true});
    ASSERT_EQ(textsOf(bench).size(), 1u);
    EXPECT_TRUE(textsOf(bench)[0].ends_with("\xC2\xB0"));
    EXPECT_EQ(std::stod(textsOf(bench)[0]), std::round(std::stod(textsOf(bench)[0]) / 15) * 15);
}

}  // namespace
}  // namespace sulfurchamber
