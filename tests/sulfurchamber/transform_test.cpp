// Turning, scaling, mirroring and nudging, by numbers and by handles.
#include <gtest/gtest.h>

#include <cmath>

#include "model/transform.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;

constexpr double right = 3.14159265358979 / 2;

// A box, and a rope of rigid links that hangs on it, both selected.
void build(Workbench& bench) {
    Document& document = bench.document();
    document.edit("Build", [&] {
        const BodyId box = document.add(
            "box", sulfur::shapes::BoxOptions{.size = {2, 1}, .mass = 3}, {.position = {1, 3}});
        const BodyId rope = document.add(
            "rope", sulfur::shapes::RopeOptions{.to = {1, 0}, .links = 5}, {.position = {2.2, 3}});
        document.connect(document.world().particles(box)[1],
                         document.world().particles(rope).front());
    });
    bench.select({document.bodyOf("box"), document.bodyOf("rope")});
}

Point placeOf(const Workbench& bench, const char* id, std::size_t particle) {
    const auto& document = bench.document();
    return document.world().position(document.world().particles(document.bodyOf(id))[particle]);
}

TEST(Transform, TurningKeepsDistancesAndRecipes) {
    Workbench bench;
    build(bench);
    const double before = (placeOf(bench, "box", 0) - placeOf(bench, "rope", 5)).norm();
    const std::string text = bench.document().text();
    const auto bounds = *selectionBounds(bench);
    bench.turn(right);
    EXPECT_NEAR((placeOf(bench, "box", 0) - placeOf(bench, "rope", 5)).norm(), before, 1e-5);
    const auto turned = *selectionBounds(bench);
    EXPECT_NEAR(turned.size().x(), bounds.size().y(), 1e-5);
    EXPECT_NEAR(turned.centre().x(), bounds.centre().x(), 1e-5);
    EXPECT_NE(bench.document().scene().prefab("box")->generator.index(), 0u);
    EXPECT_EQ(bench.selection().size(), 2u);
    bench.document().undo();
    EXPECT_EQ(bench.document().text(), text);
}

TEST(Transform, ScalingScalesAllLengthsAndMassWithTheArea) {
    Workbench bench;
    build(bench);
    const auto bounds = *selectionBounds(bench);
    bench.scale(1.5);
    const auto scaled = *selectionBounds(bench);
    EXPECT_NEAR(scaled.size().x(), 1.5 * bounds.size().x(), 1e-4);
    EXPECT_NEAR((scaled.centre() - bounds.centre()).norm(), 0, 1e-4);
    const auto& document = bench.document();
    EXPECT_NEAR(static_cast<double>(document.world().mass(document.bodyOf("box"))), 6.75, 1e-4);
    const auto& connection = document.scene().connections.at(0);
    EXPECT_NEAR(static_cast<double>(*connection.options.restLength),
                (placeOf(bench, "box", 1) - placeOf(bench, "rope", 0)).norm(), 1e-5);
    EXPECT_THROW(bench.scale(0), std::runtime_error);
}

TEST(Transform, MirroringTwiceIsAsBefore) {
    Workbench bench;
    build(bench);
    Document& document = bench.document();
    document.edit("Add", [&] {
        document.add("polygon", sulfur::shapes::PolygonOptions{.points = {{0, 0}, {2, 0}, {0, 1}}},
                     {.position = {-3, 2}, .angle = 0.4});
    });
    bench.selectAll();
    bench.toggle(document.bodyOf("floor"));
    std::vector<Point> before;
    for (std::size_t i = 0; i < 3; ++i) before.push_back(placeOf(bench, "polygon", i));
    const double middle = selectionBounds(bench)->centre().x();
    bench.mirror();
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(placeOf(bench, "polygon", i).x(), 2 * middle - before[i].x(), 1e-4);
        EXPECT_NEAR(placeOf(bench, "polygon", i).y(), before[i].y(), 1e-4);
    }
    bench.mirror();
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LT((placeOf(bench, "polygon", i) - before[i]).norm(), 1e-4);
    // What is mirrored collides on its outside.
    bench.mirror();
    for (int i = 0; i < 1500; ++i) bench.tick();
    EXPECT_GT(document.world().centreOfMass(document.bodyOf("polygon")).y(), 0.1);
}

TEST(Transform, HandlesTurnAndScale) {
    Workbench bench;
    build(bench);
    bench.select({bench.document().bodyOf("box")});
    constexpr double reach = 0.1;
    const auto drag = [&](Point from, Point to) {
        bench.press({.position = from, .reach = reach});
        bench.move({.position = (from + to) / 2, .reach = reach});
        bench.release({.position = to, .reach = reach});
    };
    Handles handles = handlesOf(*selectionBounds(bench), reach);
    const double arm = handles.turn.y() - handles.middle.y();
    drag(handles.turn, handles.middle + Point(-arm, 0));
    EXPECT_EQ(bench.document().undoLabel(), "Turn");
    EXPECT_NEAR(bench.document().world().angle(bench.document().bodyOf("box")), right, 1e-4);
    handles = handlesOf(*selectionBounds(bench), reach);
    drag(handles.corners[2], handles.middle + 2 * (handles.corners[2] - handles.middle));
    EXPECT_EQ(bench.document().undoLabel(), "Scale");
    EXPECT_NEAR(selectionBounds(bench)->size().y(), 4, 1e-3);
    // Escape in between takes it back.
    const std::string text = bench.document().text();
    handles = handlesOf(*selectionBounds(bench), reach);
    bench.press({.position = handles.turn, .reach = reach});
    bench.move({.position = handles.middle + Point(1, 1), .reach = reach});
    bench.cancel();
    EXPECT_EQ(bench.document().text(), text);
}

TEST(Transform, InAMomentThePlanFollows) {
    Workbench bench;
    build(bench);
    for (int i = 0; i < 300; ++i) bench.tick();
    bench.nudge({0.5, 1});
    bench.turn(0.3);
    const Point box = bench.document().world().centreOfMass(bench.document().bodyOf("box"));
    const double gap = (placeOf(bench, "box", 1) - placeOf(bench, "rope", 0)).norm();
    bench.document().reset();
    EXPECT_LT((bench.document().world().centreOfMass(bench.document().bodyOf("box")) - box).norm(),
              1e-3);
    EXPECT_NEAR((placeOf(bench, "box", 1) - placeOf(bench, "rope", 0)).norm(), gap, 1e-3)
        << "what is tied stays together";
}

}  // namespace
}  // namespace sulfurchamber
