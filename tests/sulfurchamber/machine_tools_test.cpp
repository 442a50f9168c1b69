// Tools that fit something: what a click or a drag makes, and what that does.
#include <gtest/gtest.h>

#include <cmath>

#include "model/fitting_marks.hpp"
#include "model/fitting_properties.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
namespace scene = sulfur::scene;

/// An empty floor, and what a person does.
struct Shop {
    Workbench bench;

    Document& document() { return bench.document(); }
    sulfur::World& world() { return document().world(); }
    void drag(Point from, Point to) {
        bench.press({.position = from, .reach = 0.05});
        bench.move({.position = (from + to) / 2, .reach = 0.05});
        bench.release({.position = to, .reach = 0.05});
    }
    void click(Point at) { drag(at, at); }
    void use(ToolKind tool, Point from, Point to) {
        bench.setTool(tool);
        drag(from, to);
    }
    void use(ToolKind tool, Point at) { use(tool, at, at); }
    void run(double seconds) {
        const int ticks = static_cast<int>(std::lround(seconds * world().settings().tickRate));
        for (int i = 0; i < ticks; ++i) bench.tick();
    }
    BodyId body(const char* id) { return document().bodyOf(id); }
    Point centre(const char* id) { return world().centreOfMass(body(id)); }
    const auto& mechanisms() { return document().scene().mechanisms; }
    template <class Spec>
    const Spec& spec(std::size_t i = 0) {
        return std::get<Spec>(mechanisms().at(i).spec);
    }
    sulfur::MechanismInfo info(std::size_t i = 0) {
        return world().info(document().made().at(i).id);
    }
    void set(const char* key, double value) {
        const FittingRef ref = *bench.fitting();
        document().edit("Change", [&] {
            setFittingProperty(document(), ref, *fittingProperty(key, document().fitting(ref)),
                               value);
        });
    }
};

TEST(MachineTools, AHingeOnOneBodyHangsItFromAPegThatGoesAlong) {
    Shop shop;
    shop.use(ToolKind::box, {0, 3}, {2, 3.4});
    shop.use(ToolKind::hinge, {0.1, 3.2});
    ASSERT_EQ(shop.mechanisms().size(), 1u);
    EXPECT_EQ(shop.document().undoLabel(), "Add hinge");
    EXPECT_EQ(shop.spec<scene::Hinge>().a, "peg");
    ASSERT_TRUE(shop.bench.fitting());
    shop.bench.select({shop.body("box")});
    shop.bench.nudge({1, 0});
    EXPECT_NEAR(shop.world().pose(shop.body("peg")).position.x(), 1.1, 1e-6);
    EXPECT_NEAR(shop.spec<scene::Hinge>().at.x(), 1.1, 1e-6);
    shop.run(3);
    EXPECT_GT(shop.centre("box").y(), 2) << "it hangs";
    EXPECT_LT(shop.centre("box").y(), 3.1) << "and has swung";
    shop.document().reset();
    shop.document().undo();
    shop.document().undo();  // the nudge
    shop.document().undo();  // the hinge
    EXPECT_TRUE(shop.mechanisms().empty());
    EXPECT_FALSE(shop.document().plan().contains("peg")) << "one step has made both";
}

TEST(MachineTools, AHingeWhereTwoOverlapJoinsThemAndTheyPass) {
    Shop shop;
    shop.use(ToolKind::box, {0, 3}, {2, 3.4});
    shop.use(ToolKind::box, {1.7, 3}, {3.7, 3.4});
    shop.use(ToolKind::hinge, {1.85, 3.2});
    EXPECT_EQ(shop.spec<scene::Hinge>().a, "box");
    EXPECT_EQ(shop.spec<scene::Hinge>().b, "box2");
    shop.run(1);
    EXPECT_LT((shop.info().pointA - shop.info().pointB).norm(), 1e-3);
    EXPECT_LT(shop.centre("box").y(), 3.1);
}

TEST(MachineTools, AWeldMakesTwoAsOne) {
    Shop shop;
    shop.use(ToolKind::box, {0, 3}, {2, 3.4});
    shop.use(ToolKind::box, {1.7, 3}, {2.1, 5});
    shop.use(ToolKind::weld, {1.85, 3.2});
    const double before = (shop.centre("box") - shop.centre("box2")).norm();
    shop.run(2);
    EXPECT_NEAR((shop.centre("box") - shop.centre("box2")).norm(), before, 5e-3);
}

TEST(MachineTools, AMotorTurnsWhatIsOnIt) {
    Shop shop;
    shop.use(ToolKind::wheel, {0, 3}, {0.5, 3});
    shop.use(ToolKind::motor, {0, 3});
    shop.run(1);
    EXPECT_NEAR(shop.info().speed, 3, 0.05);
    shop.set("speed", -5);
    shop.run(1);
    EXPECT_NEAR(shop.info().speed, -5, 0.05) << "also while time runs";
    EXPECT_THROW(shop.set("speed", 1e9), std::runtime_error);
}

TEST(MachineTools, ASpringPullsAndPushesAndACableOnlyPulls) {
    Shop shop;
    shop.use(ToolKind::box, {0, 2}, {0.5, 2.5});
    shop.use(ToolKind::spring, {0.25, 4}, {0.25, 2.25});
    const double rest = shop.info().value;
    EXPECT_NEAR(rest, 1.75, 1e-4);
    shop.run(5);
    EXPECT_GT(shop.info().value, rest + 0.05) << "it bears the weight";
    EXPECT_LT(shop.info().value, rest + 0.3);
    Shop other;
    other.use(ToolKind::box, {0, 2}, {0.5, 2.5});
    other.use(ToolKind::cable, {0.25, 1}, {0.25, 2.25});
    other.run(2);
    EXPECT_LT(other.centre("box").y(), 0.5) << "it falls, the cable pushes nothing";
    other.document().reset();
    other.document().undo();
    other.document().undo();
    other.use(ToolKind::cable, {1, 4}, {0.25, 2.25});
    const double length = other.info().value;
    other.run(3);
    EXPECT_LT(other.info().value, length + 1e-3);
    EXPECT_GT(other.centre("box").y(), 1) << "it hangs";
}

TEST(MachineTools, BothEndsOnOneBodyAreRefusedAndChangeNothing) {
    Shop shop;
    shop.use(ToolKind::box, {0, 2}, {2, 3});
    const std::string before = shop.document().text();
    shop.bench.setTool(ToolKind::spring);
    EXPECT_THROW(shop.drag({0.2, 2.5}, {1.8, 2.5}), std::runtime_error);
    EXPECT_THROW(shop.drag({5, 5}, {6, 5}), std::runtime_error);
    EXPECT_EQ(shop.document().text(), before);
}

TEST(MachineTools, ASliderLeadsABodyToItsEnds) {
    Shop shop;
    shop.use(ToolKind::box, {0, 3}, {0.5, 3.5});
    shop.use(ToolKind::slider, {0.25, 3.25}, {2.25, 1.25});
    EXPECT_EQ(shop.spec<scene::Slider>().a, "rail");
    shop.run(3);
    EXPECT_NEAR(shop.centre("box").x(), 2.25, 0.02);
    EXPECT_NEAR(shop.centre("box").y(), 1.25, 0.02);
    EXPECT_NEAR(shop.world().pose(shop.body("box")).angle, 0, 1e-2);
}

TEST(MachineTools, AnAxleIsSprungAndDriven) {
    Shop shop;
    shop.use(ToolKind::box, {0, 1}, {2, 1.4});
    shop.use(ToolKind::wheel, {0.3, 0.8}, {0.3, 0.4});
    shop.document().undo();
    shop.use(ToolKind::wheel, {2.3, 0.45}, {2.3, 0.05});
    EXPECT_THROW(shop.use(ToolKind::axle, {2.3, 0.45}), std::runtime_error);
    shop.use(ToolKind::axle, {2.3, 0.45}, {1.9, 1.2});
    ASSERT_EQ(shop.mechanisms().size(), 1u);
    const auto& axle = shop.spec<scene::Wheel>();
    EXPECT_EQ(axle.a, "box");
    EXPECT_EQ(axle.b, "wheel");
    EXPECT_GT(axle.options.spring.stiffness, 0);
    EXPECT_EQ(keysOf(shop.mechanisms()[0]).forward, "Right");
}

TEST(MachineTools, APulleyIsFourClicks) {
    Shop shop;
    shop.use(ToolKind::box, {0, 1}, {0.5, 1.5});
    shop.use(ToolKind::box, {2, 1}, {3, 2});
    shop.bench.setTool(ToolKind::pulley);
    for (const Point& at : {Point(0.25, 1.4), Point(0.25, 4), Point(2.5, 4), Point(2.5, 1.9)})
        shop.click(at);
    ASSERT_EQ(shop.mechanisms().size(), 1u);
    shop.run(0.6);
    EXPECT_GT(shop.centre("box").y(), 1.5) << "the heavier one draws it up";
    EXPECT_LT(shop.centre("box2").y(), 1.4);
}

TEST(MachineTools, AGearTurnsTheOtherWheelTheOtherWay) {
    Shop shop;
    shop.use(ToolKind::wheel, {0, 3}, {0.5, 3});
    shop.use(ToolKind::motor, {0, 3});
    shop.use(ToolKind::wheel, {1.8, 3}, {2.8, 3});
    shop.use(ToolKind::hinge, {1.8, 3});
    shop.set("collide", 0);
    shop.use(ToolKind::gear, {0, 3}, {1.8, 3});
    ASSERT_EQ(shop.mechanisms().size(), 3u);
    EXPECT_NEAR(static_cast<double>(shop.spec<scene::Gear>(2).ratio), 2, 0.05);
    shop.document().edit("Pass",
                         [&] { shop.document().letPass(shop.body("wheel"), shop.body("wheel2")); });
    shop.run(2);
    EXPECT_NEAR(shop.info(0).speed, 3, 0.1);
    EXPECT_NEAR(shop.info(1).speed, -1.5, 0.1);
}

TEST(MachineTools, AThrusterPushesInTheFrameOfItsBody) {
    Shop shop;
    shop.use(ToolKind::ball, {0, 0.3}, {0.25, 0.3});
    shop.use(ToolKind::thruster, {0, 0.3}, {0, 1.3});
    ASSERT_EQ(shop.document().thrusters().size(), 1u);
    EXPECT_NEAR(static_cast<double>(shop.document().thrusters()[0].force.norm()),
                20 * 3.14159265 * 0.0625 * 4, 0.1);
    shop.run(1);
    EXPECT_LT(shop.centre("ball").y(), 0.4) << "no key is held";
    shop.bench.controls().hold("Up", true);
    shop.run(1);
    EXPECT_GT(shop.centre("ball").y(), 3) << "twice the weight lifts it";
}

TEST(MachineTools, ZonesBlowAndLift) {
    Shop shop;
    shop.use(ToolKind::box, {0, 2}, {0.4, 2.4});
    shop.use(ToolKind::gravity, {-2, 1}, {6, 5});
    shop.run(1);
    EXPECT_NEAR(shop.centre("box").y(), 2.2, 1e-2) << "without weight";
    shop.document().reset();
    shop.use(ToolKind::wind, {-2, 1}, {6, 5});
    shop.run(1);
    EXPECT_GT(shop.centre("box").x(), 1.5) << "the wind takes it along";
    ASSERT_EQ(shop.document().scene().fields.size(), 2u);
    shop.bench.chooseFitting(FittingRef{FittingRef::Kind::zone, 0});
    shop.bench.deleteSelection();
    EXPECT_EQ(shop.document().scene().fields.size(), 1u);
    EXPECT_EQ(shop.world().fields().size(), 1u) << "also in this moment";
}

TEST(MachineTools, AConveyorCarriesWhereItWasDrawnTo) {
    for (const double way : {1.0, -1.0}) {
        Shop shop;
        shop.use(ToolKind::conveyor, {-3 * way, 1}, {3 * way, 1});
        shop.use(ToolKind::box, {0, 1.4});
        shop.run(2);
        EXPECT_GT(shop.centre("box").x() * way, 1);
    }
    Shop shop;
    shop.use(ToolKind::box, {0, 0.1}, {1, 0.5});
    shop.use(ToolKind::conveyor, {0.5, 0.3});
    const auto speed = [&] { return shop.world().material(shop.body("box")).surfaceSpeed; };
    EXPECT_GT(speed(), 0);
    shop.use(ToolKind::conveyor, {0.5, 0.3});
    EXPECT_LT(speed(), 0) << "a second click turns it round";
}

TEST(MachineTools, LiquidFindsItsLevel) {
    Shop shop;
    shop.use(ToolKind::ground, {-1, 0}, {-1, 2});
    shop.use(ToolKind::ground, {1, 0}, {1, 2});
    shop.use(ToolKind::liquid, {-0.9, 0.1}, {-0.1, 1.3});
    const std::size_t drops = shop.world().bodies().size() - 3;
    EXPECT_GT(drops, 50u);
    EXPECT_EQ(shop.document().scene().blueprints.size(), 3u) << "they share one blueprint";
    shop.run(4);
    double left = 0, right = 0;
    for (const BodyId body : shop.world().bodies()) {
        if (shop.world().name(body) != "drop") continue;
        const Point at = shop.world().centreOfMass(body);
        (at.x() < 0 ? left : right) += 1;
        EXPECT_LT(at.y(), 0.9);
    }
    EXPECT_NEAR(left / (left + right), 0.5, 0.12);
}

TEST(MachineTools, MarksAreHitMovedAndErased) {
    Shop shop;
    shop.use(ToolKind::box, {0, 3}, {2, 3.4});
    shop.use(ToolKind::hinge, {0.1, 3.2});
    shop.bench.select({});
    EXPECT_FALSE(fittingAt(shop.document(), {1, 3.2}, 0.05));
    ASSERT_TRUE(fittingAt(shop.document(), {0.12, 3.2}, 0.05));
    shop.use(ToolKind::select, {0.1, 3.2});
    ASSERT_TRUE(shop.bench.fitting()) << "a click selects the mark, not the box";
    EXPECT_TRUE(shop.bench.selection().empty());
    shop.drag({0.1, 3.2}, {1.9, 3.2});
    EXPECT_NEAR(shop.spec<scene::Hinge>().at.x(), 1.9, 1e-6);
    EXPECT_NEAR(shop.world().pose(shop.body("peg")).position.x(), 1.9, 1e-6);
    shop.document().undo();
    EXPECT_NEAR(shop.spec<scene::Hinge>().at.x(), 0.1, 1e-6);
    shop.use(ToolKind::erase, {0.1, 3.2});
    EXPECT_TRUE(shop.mechanisms().empty());
    EXPECT_FALSE(shop.body("peg"));
    EXPECT_TRUE(shop.body("box"));
}

TEST(MachineTools, CopiesMirrorsAndScalesTakePegsAndThrustersAlong) {
    Shop shop;
    shop.use(ToolKind::box, {0, 3}, {2, 3.4});
    shop.use(ToolKind::hinge, {0.1, 3.2});
    shop.use(ToolKind::thruster, {1.8, 3.2}, {2.3, 3.2});
    shop.bench.select({shop.body("box")});
    shop.bench.paste(shop.bench.copy(), {5, 0});
    ASSERT_EQ(shop.mechanisms().size(), 2u);
    ASSERT_EQ(shop.document().thrusters().size(), 2u);
    EXPECT_NEAR(shop.spec<scene::Hinge>(1).at.x(), 5.1, 1e-5);
    EXPECT_NEAR(shop.world().pose(shop.body("peg2")).position.x(), 5.1, 1e-5);
    shop.bench.select({shop.body("box2")});
    shop.bench.mirror();
    EXPECT_NEAR(shop.spec<scene::Hinge>(1).at.x(), 6.9, 1e-4);
    EXPECT_NEAR(shop.world().pose(shop.body("peg2")).position.x(), 6.9, 1e-4);
    EXPECT_LT(shop.document().thrusters()[1].force.x(), 0);
    shop.bench.scale(2);
    EXPECT_NEAR(shop.spec<scene::Hinge>(1).at.x(), 7.8, 1e-3);
    shop.run(1);
    EXPECT_EQ(shop.world().validate(), "");
}

TEST(MachineTools, WhatIsFittedInAMomentStandsInThePlanAsItDoesThere) {
    Shop shop;
    shop.use(ToolKind::box, {0, 3}, {2, 3.4});
    shop.run(0.3);
    const Point now = shop.centre("box");
    shop.use(ToolKind::hinge, {now.x() - 0.9, now.y()});
    ASSERT_EQ(shop.world().mechanisms().size(), 1u);
    EXPECT_NEAR(shop.spec<scene::Hinge>().at.y(), now.y(), 1e-3);
    shop.run(1);
    EXPECT_GT(shop.centre("box").y(), 0.8) << "it hangs in the moment";
    shop.document().reset();
    shop.run(1);
    EXPECT_GT(shop.centre("box").y(), 0.8) << "and in the plan";
    shop.bench.chooseFitting(FittingRef{FittingRef::Kind::mechanism, 0});
    shop.bench.deleteSelection();
    EXPECT_TRUE(shop.world().mechanisms().empty());
    shop.run(2);
    EXPECT_LT(shop.world().bounds(shop.body("box")).low.y(), 0.06) << "it stands on the floor";
}

TEST(MachineTools, ThrustersFollowNamesAndGoWithTheirBodies) {
    Shop shop;
    shop.use(ToolKind::box, {0, 3}, {2, 3.4});
    shop.use(ToolKind::thruster, {1.8, 3.2}, {2.3, 3.2});
    const std::string before = shop.document().text();
    shop.document().edit("Rename", [&] { shop.document().rename(shop.body("box"), "a rocket"); });
    EXPECT_EQ(shop.document().thrusters().size(), 1u);
    shop.document().undo();
    EXPECT_EQ(shop.document().text(), before);
    shop.document().edit("Rename", [&] { shop.document().rename(shop.body("box"), "rocket"); });
    ASSERT_EQ(shop.document().thrusters().size(), 1u);
    EXPECT_EQ(shop.document().thrusters()[0].body, "rocket");
    shop.bench.select({shop.body("rocket")});
    shop.bench.deleteSelection();
    EXPECT_TRUE(shop.document().thrusters().empty());
    EXPECT_EQ(shop.document().text().find("devices"), std::string::npos);
}

}  // namespace
}  // namespace sulfurchamber
