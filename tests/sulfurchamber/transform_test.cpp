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

constexpr double reach = 0.1;

void drag(Workbench& bench, Point from, Point to, Pointer keys = {}) {
    keys.reach = reach;
    keys.position = from;
    bench.press(keys);
    keys.position = (from + to) / 2;
    bench.move(keys);
    keys.position = to;
    bench.move(keys);
    bench.release(keys);
}

enum : std::size_t {
    lowerLeft,
    lowerRight,
    upperRight,
    upperLeft,
    lower,
    rightSide,
    upper,
    leftSide,
    knob
};

Handle handle(const Workbench& bench, std::size_t which) {
    return handlesOf(*selectionFrame(bench), reach).at(which);
}

BodyId oneBox(Workbench& bench, const Point& at = {0, 3}, double angle = 0) {
    Document& document = bench.document();
    BodyId box;
    document.edit("Add box", [&] {
        box = document.add("box", sulfur::shapes::BoxOptions{.size = {2, 1}, .mass = 3},
                           {.position = at, .angle = angle});
    });
    bench.select({document.world().bodies().back()});
    return bench.selection().front();
}

TEST(Transform, ACornerScalesAboutTheOtherOne) {
    Workbench bench;
    oneBox(bench);
    const std::string before = bench.document().text();
    const Frame frame = *selectionFrame(bench);
    drag(bench, handle(bench, upperRight).at, handle(bench, upperRight).at + Point(2, 1));
    EXPECT_EQ(bench.document().undoLabel(), "Scale");
    Frame now = *selectionFrame(bench);
    EXPECT_NEAR(now.half.x(), 2, 1e-4);
    EXPECT_NEAR(now.half.y(), 1, 1e-4);
    EXPECT_LT((now.at(-1, -1) - frame.at(-1, -1)).norm(), 1e-4) << "the other corner stays";
    EXPECT_NEAR(static_cast<double>(bench.document().world().mass(bench.selection()[0])), 12, 1e-3);
    bench.document().undo();
    EXPECT_EQ(bench.document().text(), before) << "one step";
    drag(bench, handle(bench, upperRight).at, handle(bench, upperRight).at + Point(1, 0.5),
         {.control = true});
    now = *selectionFrame(bench);
    EXPECT_NEAR(now.half.x(), 2, 1e-4);
    EXPECT_LT((now.middle - frame.middle).norm(), 1e-4) << "with Ctrl the middle stays";
}

TEST(Transform, ASideStretchesWhatCanBeStretched) {
    for (const double angle : {0.0, 0.6, right}) {
        Workbench bench;
        oneBox(bench, {0, 4}, angle);
        const Point along(std::cos(angle), std::sin(angle));
        drag(bench, handle(bench, rightSide).at, handle(bench, rightSide).at + Point(1.0 * along));
        EXPECT_EQ(bench.document().undoLabel(), "Stretch");
        const Frame now = *selectionFrame(bench);
        EXPECT_NEAR(2 * now.half.x(), 3, 1e-4) << angle;
        EXPECT_NEAR(2 * now.half.y(), 1, 1e-4) << angle;
        const auto& document = bench.document();
        EXPECT_NEAR(static_cast<double>(document.world().mass(bench.selection()[0])), 4.5, 1e-3);
        EXPECT_NE(
            document.plan().prefab(document.scene().bodies.back().blueprint).generator.index(), 0u)
            << "the recipe says it";
    }
}

TEST(Transform, ASideOfARoundBodyScalesIt) {
    Workbench bench;
    bench.document().edit("Add ball", [&] {
        bench.document().add("ball", sulfur::shapes::BallOptions{.radius = Real(0.5)},
                             {.position = {0, 3}});
    });
    bench.select({bench.document().bodyOf("ball")});
    drag(bench, handle(bench, rightSide).at, handle(bench, rightSide).at + Point(1, 0));
    const Frame now = *selectionFrame(bench);
    EXPECT_NEAR(now.half.x(), 1, 1e-4);
    EXPECT_NEAR(now.half.y(), 1, 1e-4);
}

TEST(Transform, ManyBodiesStretchAsOne) {
    Workbench bench;
    Document& document = bench.document();
    document.edit("Build", [&] {
        const BodyId low =
            document.add("box", sulfur::shapes::BoxOptions{.size = {1, 1}}, {.position = {0, 2}});
        const BodyId high = document.add("box", sulfur::shapes::BoxOptions{.size = {1, 1}},
                                         {.position = {2, 2}, .angle = right});
        document.connect(document.world().particles(low)[1], document.world().particles(high)[0]);
    });
    bench.select({document.bodyOf("box"), document.bodyOf("box2")});
    const auto gap = [&] {
        return (placeOf(bench, "box", 1) - placeOf(bench, "box2", 0)).norm() -
               static_cast<double>(*document.scene().connections.at(0).options.restLength);
    };
    ASSERT_NEAR(gap(), 0, 1e-5);
    drag(bench, handle(bench, rightSide).at, handle(bench, rightSide).at + Point(3, 0));
    EXPECT_EQ(document.undoLabel(), "Stretch");
    const auto bounds = *selectionBounds(bench);
    EXPECT_NEAR(bounds.size().x(), 6, 1e-3);
    EXPECT_NEAR(bounds.size().y(), 1, 1e-3);
    // The capsules stay as thick: the ends of the tie move by less than the whole.
    EXPECT_NEAR(gap(), 0, 0.1);
}

TEST(Transform, TheKnobTurnsWithShiftInSteps) {
    Workbench bench;
    oneBox(bench);
    const Point middle = selectionFrame(bench)->middle;
    const double arm = (handle(bench, knob).at - middle).norm();
    drag(bench, handle(bench, knob).at, middle + Point(-arm, 0));
    EXPECT_EQ(bench.document().undoLabel(), "Turn");
    EXPECT_NEAR(bench.document().world().angle(bench.selection()[0]), right, 1e-4);
    drag(bench, handle(bench, knob).at, middle + arm * Point(-std::sin(0.8), std::cos(0.8)),
         {.shift = true});
    EXPECT_NEAR(bench.document().world().angle(bench.selection()[0]), 3 * right / 6, 1e-4);
    // Escape in between takes it back.
    const std::string text = bench.document().text();
    bench.press({.position = handle(bench, knob).at, .reach = reach});
    bench.move({.position = middle + Point(1, 1), .reach = reach});
    bench.cancel();
    EXPECT_EQ(bench.document().text(), text);
}

TEST(Transform, HandlesWorkWhileTimeRunsAndAfterRewinding) {
    Workbench bench;
    oneBox(bench);
    Document& document = bench.document();
    document.play();
    for (int i = 0; i < 100; ++i) bench.tick();
    const auto dragWhileRunning = [&](std::size_t which, Point way) {
        const Point from = handle(bench, which).at;
        bench.press({.position = from, .reach = reach});
        bench.move({.position = from + way, .reach = reach});
        for (int i = 0; i < 10; ++i) bench.tick();
        bench.release({.position = from + way, .reach = reach});
    };
    dragWhileRunning(rightSide, {1, 0});
    EXPECT_EQ(document.undoLabel(), "Stretch");
    EXPECT_NEAR(2 * selectionFrame(bench)->half.x(), 3, 1e-3);
    EXPECT_TRUE(document.playing());
    const Point middle = selectionFrame(bench)->middle;
    dragWhileRunning(knob, middle + Point(-2, 0) - handle(bench, knob).at);
    EXPECT_EQ(document.undoLabel(), "Turn");
    EXPECT_NEAR(std::abs(document.world().angle(bench.selection()[0])), right, 0.2);
    for (int i = 0; i < 200; ++i) bench.tick();
    ASSERT_TRUE(document.goTo({document.timeline().line(), 250}));
    bench.documentChanged();
    bench.select({document.bodyOf("box")});
    const Frame frame = *selectionFrame(bench);
    const Point diagonal = frame.at(1, 1) - frame.at(-1, -1);
    drag(bench, handle(bench, upperRight).at, handle(bench, upperRight).at + diagonal);
    EXPECT_EQ(document.undoLabel(), "Scale");
    EXPECT_NEAR(selectionFrame(bench)->half.x(), 2 * frame.half.x(), 1e-3);
    document.undo();
    EXPECT_NEAR(selectionFrame(bench)->half.x(), frame.half.x(), 1e-3);
}

TEST(Transform, NumbersSayWhereAndHowLarge) {
    Workbench bench;
    build(bench);
    Document& document = bench.document();
    const auto get = [&](const char* key) {
        return placeProperty(key)->get(*selectionFrame(bench));
    };
    const auto set = [&](const char* key, double value) {
        document.edit("Change", [&] { setPlace(bench, *placeProperty(key), value); });
    };
    const double gap = (placeOf(bench, "box", 0) - placeOf(bench, "rope", 5)).norm();
    set("x", -2);
    set("y", 5);
    EXPECT_NEAR(get("x"), -2, 1e-4);
    EXPECT_NEAR(get("y"), 5, 1e-4);
    EXPECT_NEAR((placeOf(bench, "box", 0) - placeOf(bench, "rope", 5)).norm(), gap, 1e-4)
        << "many move as one";
    const double height = get("frame-height");
    set("frame-width", 2 * get("frame-width"));
    EXPECT_NEAR(get("frame-height"), height, 0.05) << "ropes and boxes can be stretched";
    bench.select({document.bodyOf("box")});
    set("angle", 30);
    EXPECT_NEAR(document.world().angle(document.bodyOf("box")), right / 3, 1e-4);
    set("frame-height", 2);
    EXPECT_NEAR(get("frame-height"), 2, 1e-4);
    EXPECT_THROW(set("x", 5000), std::runtime_error);
    bench.select({});
    EXPECT_THROW(set("x", 1), std::runtime_error);
    EXPECT_EQ(placeProperty("z"), nullptr);
}

TEST(Transform, WhatIsStretchedKeepsItsAxles) {
    Workbench bench;
    Document& document = bench.document();
    oneBox(bench);
    document.edit("Add wheel", [&] {
        const BodyId wheel = document.add(
            "wheel", sulfur::shapes::WheelOptions{.radius = Real(0.3)}, {.position = {0.8, 2.6}});
        document.attach(document.world().particles(wheel).back(), document.bodyOf("box"));
        document.letPass(wheel, document.bodyOf("box"));
    });
    bench.select({document.bodyOf("box"), document.bodyOf("wheel")});
    bench.scale(2);
    const auto& attachment = document.scene().attachments.at(0);
    const auto& world = document.world();
    const auto pose = world.pose(document.bodyOf("box"));
    const Point hub = world.position(world.particles(document.bodyOf("wheel")).back());
    EXPECT_LT((pose.position + attachment.point.cast<double>() - hub).norm(), 1e-3);
}

TEST(Transform, WhatIsStretchedWhileTimeRunsKeepsItsAxles) {
    Workbench bench;
    Document& document = bench.document();
    oneBox(bench);
    document.edit("Add wheel", [&] {
        const BodyId wheel = document.add(
            "wheel", sulfur::shapes::WheelOptions{.radius = Real(0.3)}, {.position = {0.8, 2.6}});
        document.attach(document.world().particles(wheel).back(), document.bodyOf("box"));
        document.letPass(wheel, document.bodyOf("box"));
    });
    for (int i = 0; i < 50; ++i) bench.tick();
    bench.select({document.bodyOf("box"), document.bodyOf("wheel")});
    bench.scale(1.5);
    const auto& world = document.world();
    EXPECT_EQ(world.attachments().size(), 1u);
    EXPECT_EQ(world.vetoes().size(), 1u);
    for (int i = 0; i < 2000; ++i) bench.tick();
    const Point hub = world.position(world.particles(document.bodyOf("wheel")).back());
    EXPECT_NEAR((hub - world.centreOfMass(document.bodyOf("box"))).norm(),
                1.5 * std::hypot(0.8, 0.4), 0.05);
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
