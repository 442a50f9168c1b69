// Meters that stand in a scene: what they tell, that they are kept, moved, deleted and undone.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "model/forces.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

constexpr double floorTop = 0.05;

void dragTool(Workbench& bench, ToolKind tool, const Point& from, const Point& to) {
    bench.setTool(tool);
    bench.press({.position = from});
    bench.move({.position = to});
    bench.release({.position = to});
}

void clickTool(Workbench& bench, ToolKind tool, const Point& at) {
    dragTool(bench, tool, at, at);
}

void letPass(Workbench& bench, double seconds) {
    const int ticks = static_cast<int>(std::lround(seconds * 500));
    for (int i = 0; i < ticks; ++i) bench.tick();
}

double readFirst(const Workbench& bench, std::size_t place = 0) {
    const Meter& meter = bench.meters().all().at(place);
    return bench.meters().read(meter, readingsOf(meter.kind)[0]).value_or(std::nan(""));
}

/// A pendulum 1 m long, its ball of a kilogram to the right of the pin at (0, 3).
void openPendulum(Workbench& bench) {
    bench.document().adopt(sulfur::scene::parse(R"({
      "format": "sulfur-scene", "version": 1, "title": "pendulum", "world": {},
      "blueprints": {"p": {
        "particles": [{"position": [0, 0], "pinned": true},
                      {"position": [1, 0], "mass": 1, "radius": 0.1}],
        "joints": [{"a": 0, "b": 1}]}},
      "bodies": [{"id": "swing", "blueprint": "p", "position": [0, 3]}]})",
                                                "pendulum"));
    bench.documentChanged();
}

TEST(Meters, ARulerHoldsOnToWhatItMeasures) {
    Workbench bench;
    openPendulum(bench);
    dragTool(bench, ToolKind::measure, {0, 3}, {1, 3});
    dragTool(bench, ToolKind::measure, {0, 0.5}, {1.02, 3.01});
    ASSERT_EQ(bench.meters().all().size(), 2u);
    EXPECT_EQ(bench.meters().all()[0].id, "ruler");
    EXPECT_EQ(bench.meters().all()[1].id, "ruler2");
    EXPECT_NEAR(readFirst(bench), 1, 1e-6);
    EXPECT_NEAR(readFirst(bench, 1), std::hypot(1, 2.5), 1e-6);
    letPass(bench, 0.3);
    EXPECT_NEAR(readFirst(bench), 1, 1e-4) << "a rigid joint";
    const auto& world = bench.document().world();
    const Point ball = world.position(world.particles(world.bodies()[0])[1]);
    EXPECT_NEAR(readFirst(bench, 1), (ball - Point(0, 0.5)).norm(), 1e-9);
    EXPECT_EQ(bench.meters().record("ruler2")[0].samples.size(), 150u);
}

TEST(Meters, AProtractorFollowsAPendulum) {
    Workbench bench;
    openPendulum(bench);
    // From straight down to the ball, anticlockwise.
    dragTool(bench, ToolKind::protractor, {0, 3}, {0, 1});
    EXPECT_TRUE(bench.meters().all().empty()) << "the second leg is missing";
    clickTool(bench, ToolKind::protractor, {9, 9});
    EXPECT_TRUE(bench.meters().all().empty()) << "the tool was chosen anew";
    bench.setTool(ToolKind::protractor);
    bench.press({.position = {0, 3}});
    bench.move({.position = {0, 1}});
    bench.release({.position = {0, 1}});
    bench.press({.position = {1, 3}});
    bench.release({.position = {1, 3}});
    ASSERT_EQ(bench.meters().all().size(), 1u);
    EXPECT_NEAR(readFirst(bench), 90, 1e-4);
    // It comes to the other side: energy allows no more than 90 degrees there.
    double least = 90;
    for (int i = 0; i < 1000; ++i) {
        bench.tick();
        least = std::min(least, readFirst(bench));
    }
    EXPECT_NEAR(least, -90, 1);
}

TEST(Meters, ATracerLeavesTheWayOfItsPoint) {
    Workbench bench;
    openPendulum(bench);
    clickTool(bench, ToolKind::tracer, {1, 3});
    clickTool(bench, ToolKind::tracer, {5, 5});  // nothing is there
    ASSERT_EQ(bench.meters().all().size(), 1u);
    EXPECT_NE(bench.hint().find("no body"), std::string::npos);
    letPass(bench, 1);
    const auto record = bench.meters().record("tracer");
    ASSERT_EQ(record.size(), 3u);
    ASSERT_EQ(record[1].samples.size(), 500u);
    for (std::size_t i = 0; i < 500; ++i)
        EXPECT_NEAR(std::hypot(record[1].samples[i].value, record[2].samples[i].value - 3), 1,
                    1e-4);
    // Speed by energy: v^2 = 2 g h, at the velocity's time, half a tick before the place.
    const double height = 3 - record[2].samples[200].value;
    EXPECT_NEAR(record[0].samples[200].value, std::sqrt(2 * 9.81 * height), 0.02);
    // Going back and on again replaces what came later.
    const auto& timeline = bench.document().timeline();
    ASSERT_TRUE(bench.document().goTo({timeline.line(), 250}));
    bench.tick();
    EXPECT_EQ(bench.meters().record("tracer")[1].samples.size(), 251u);
}

TEST(Meters, AGaugeTellsTheWeightOfWhatLies) {
    Workbench bench;
    dragTool(bench, ToolKind::box, {0, floorTop}, {1, 1 + floorTop});
    const auto& world = bench.document().world();
    const double mass = static_cast<double>(world.mass(world.bodies().back()));
    clickTool(bench, ToolKind::gauge, {0.5, 0.6});
    ASSERT_EQ(bench.meters().all().size(), 1u);
    EXPECT_EQ(bench.meters().all()[0].ends.size(), 1u);
    EXPECT_EQ(readFirst(bench), 0) << "no time has passed";
    letPass(bench, 1.5);
    EXPECT_NEAR(readFirst(bench), mass * 9.81, 0.01 * mass * 9.81);
    const double scale = bench.meters().scaleOf(bench.meters().all()[0]);
    EXPECT_GE(scale, mass * 9.81);
    EXPECT_EQ(scale, roundAbove(scale));
}

TEST(Meters, AGaugeTellsThePullOfAJoint) {
    Workbench bench;
    openPendulum(bench);
    clickTool(bench, ToolKind::gauge, {0.5, 3});
    ASSERT_EQ(bench.meters().all().size(), 1u);
    ASSERT_EQ(bench.meters().all()[0].ends.size(), 2u);
    // At the lowest point it bears 3 m g, whatever the length.
    double most = 0;
    for (int i = 0; i < 600; ++i) {
        bench.tick();
        most = std::max(most, readFirst(bench));
    }
    EXPECT_NEAR(most, 3 * 9.81, 0.3);
    // A joint that is cut is told no more.
    bench.document().pause();
    dragTool(bench, ToolKind::cut, {-5, 2.8}, {5, 2.8});
    for (const Point& way : {Point(0.3, -0.3), Point(-0.3, -0.3), Point(0.05, -0.5)})
        dragTool(bench, ToolKind::cut, Point(0, 3) + way + Point(way.y(), -way.x()),
                 Point(0, 3) + way - Point(way.y(), -way.x()));
    letPass(bench, 0.02);
    EXPECT_TRUE(std::isnan(readFirst(bench)));
}

/// A spring of 250 N/m on which 2.5 kg hang.
TEST(Meters, AGaugeTellsTheStrainOfItsJoint) {
    Workbench bench;
    bench.setTool(ToolKind::particle);
    bench.press({.position = {0, 4}, .shift = true});
    bench.release({.position = {0, 4}, .shift = true});
    bench.press({.position = {0, 3}});
    bench.release({.position = {0, 3}});
    dragTool(bench, ToolKind::joint, {0, 4}, {0, 3});
    auto& document = bench.document();
    const std::string id = document.scene().bodies.back().id;
    document.edit("Soften", [&] {
        const auto body = document.bodyOf(id);
        document.change({&body, 1}, [](sulfur::scene::Prefab& prefab) {
            prefab.blueprint.joints[0].stiffness = 250;
            prefab.blueprint.joints[0].damping = 40;
            prefab.blueprint.particles[1].mass = 2.5f;
        });
    });
    clickTool(bench, ToolKind::gauge, {0, 3.5});
    ASSERT_EQ(bench.meters().all().size(), 1u);
    const Meter meter = bench.meters().all()[0];
    ASSERT_EQ(readingsOf(meter).size(), 2u);
    letPass(bench, 3);
    EXPECT_NEAR(bench.meters().read(meter, readingsOf(meter)[1]).value_or(0), 9.81, 0.05);
    const auto record = bench.meters().record(meter.id);
    ASSERT_EQ(record.size(), 2u) << "both are plotted";
    EXPECT_GT(record[1].samples.size(), 100u);
}

TEST(Meters, AGaugeTellsWhatAHingeBears) {
    Workbench bench;
    bench.document().adopt(sulfur::scene::parse(R"({
      "format": "sulfur-scene", "version": 1, "title": "door", "world": {},
      "blueprints": {"post": {"kind": "fixed", "shape": "box", "size": [0.2, 0.2]},
                     "arm": {"shape": "box", "size": [1, 0.2], "mass": 3}},
      "bodies": [{"id": "post", "blueprint": "post", "position": [0, 3]},
                 {"id": "arm", "blueprint": "arm", "position": [0, 2.5], "angle": 1.5707963}],
      "mechanisms": [{"type": "hinge", "a": "post", "b": "arm", "at": [0, 3]}]})",
                                                "door"));
    bench.documentChanged();
    clickTool(bench, ToolKind::gauge, {0, 3});
    ASSERT_EQ(bench.meters().all().size(), 1u);
    EXPECT_EQ(bench.meters().all()[0].ends[0].body, "post");
    EXPECT_EQ(bench.meters().all()[0].ends[1].body, "arm");
    letPass(bench, 1);
    EXPECT_NEAR(readFirst(bench), 3 * 9.81, 0.3) << "it hangs straight down";
}

TEST(Meters, AGunTellsTheSpeedOfWhatPasses) {
    Workbench bench;
    dragTool(bench, ToolKind::ball, {0, 6}, {0.25, 6});
    const BodyId ball = bench.document().world().bodies().back();
    dragTool(bench, ToolKind::gun, {-2, 3}, {2, 3});
    ASSERT_EQ(bench.meters().all().size(), 1u);
    EXPECT_TRUE(std::isnan(readFirst(bench))) << "nobody is in the beam";
    const auto radius = static_cast<double>(
        bench.document().world().info(bench.document().world().particles(ball)[0]).radius);
    letPass(bench, 0.75);
    EXPECT_FALSE(std::isnan(readFirst(bench)));
    letPass(bench, 0.15);
    EXPECT_TRUE(std::isnan(readFirst(bench))) << "it has passed";
    const auto samples = bench.meters().record("gun")[0].samples;
    ASSERT_GT(samples.size(), 5u);
    // From its centre to the beam less and plus its radius.
    EXPECT_NEAR(samples.front().value, std::sqrt(2 * 9.81 * (3 - radius)), 0.05);
    EXPECT_NEAR(samples.back().value, std::sqrt(2 * 9.81 * (3 + radius)), 0.05);
    EXPECT_EQ(bench.meters().last(bench.meters().all()[0])->value, samples.back().value);
}

TEST(Meters, AreSavedMovedDeletedAndUndone) {
    const auto file = std::filesystem::path(testing::TempDir()) / "meters_test.json";
    Workbench bench;
    openPendulum(bench);
    dragTool(bench, ToolKind::measure, {0, 3}, {1, 3});
    clickTool(bench, ToolKind::tracer, {1, 3});
    dragTool(bench, ToolKind::gun, {-2, 0.5}, {2, 0.5});
    const std::string text = bench.document().text();
    bench.document().save(file);
    const auto before = bench.meters().all();
    Workbench other;
    other.document().open(file);
    EXPECT_EQ(other.meters().all(), before);
    EXPECT_EQ(other.document().text(), text);

    // An end of the gun, then the whole of it.
    dragTool(other, ToolKind::select, {2, 0.5}, {3, 1.5});
    EXPECT_EQ(other.selectedMeters(), std::vector<std::string>{"gun"});
    EXPECT_EQ(other.meters().find("gun")->ends[1].at, Point(3, 1.5));
    EXPECT_EQ(other.document().undoLabel(), "Move gun");
    dragTool(other, ToolKind::select, {0.5, 1}, {0.5, 2});
    EXPECT_NEAR(other.meters().find("gun")->ends[0].at.y(), 1.5, 1e-9);
    EXPECT_NEAR(other.meters().find("gun")->ends[1].at.y(), 2.5, 1e-9);
    other.deleteSelection();
    EXPECT_EQ(other.meters().find("gun"), nullptr);
    EXPECT_EQ(other.meters().all().size(), 2u);
    for (int i = 0; i < 3; ++i) other.document().undo();
    other.documentChanged();
    EXPECT_EQ(other.document().text(), text);
    EXPECT_EQ(other.meters().all(), before);
    for (int i = 0; i < 3; ++i) other.document().redo();
    EXPECT_EQ(other.meters().all().size(), 2u);
    // Escape in a drag puts the end back.
    bench.setTool(ToolKind::select);
    bench.press({.position = {2, 0.5}});
    bench.move({.position = {3, 1.5}});
    bench.cancel();
    EXPECT_EQ(bench.document().text(), text);
    std::filesystem::remove(file);
}

TEST(Meters, FollowNamesAndGoWithTheirBodies) {
    Workbench bench;
    openPendulum(bench);
    dragTool(bench, ToolKind::measure, {0, 3}, {1, 3});
    dragTool(bench, ToolKind::gun, {-2, 0.5}, {2, 0.5});
    const BodyId body = bench.document().world().bodies()[0];
    bench.document().edit("Rename", [&] { bench.document().rename(body, "bob"); });
    EXPECT_EQ(bench.meters().find("ruler")->ends[1].body, "bob");
    EXPECT_NEAR(readFirst(bench), 1, 1e-6);
    bench.selectAll();
    bench.deleteSelection();
    ASSERT_EQ(bench.meters().all().size(), 1u);
    EXPECT_EQ(bench.meters().all()[0].id, "gun");
    bench.document().undo();
    EXPECT_EQ(bench.meters().all().size(), 2u);
}

TEST(Meters, JoinTheDiagramWithAllThatTheyHaveShown) {
    Workbench bench;
    openPendulum(bench);
    clickTool(bench, ToolKind::tracer, {1, 3});
    letPass(bench, 0.1);
    bench.measure({});
    ASSERT_EQ(bench.measurements().series().size(), 3u);
    EXPECT_EQ(bench.measurements().series()[1].title(), "Horizontal place of tracer");
    EXPECT_EQ(bench.measurements().series()[1].samples.size(), 50u);
    letPass(bench, 0.1);
    EXPECT_EQ(bench.measurements().series()[1].samples.size(), 100u);
    bench.measure({quantity("energy")});
    bench.select({bench.document().world().bodies()[0]});
    EXPECT_EQ(bench.measurements().series().size(), 1u);
    bench.selectMeters({"tracer"}, true);
    EXPECT_EQ(bench.measurements().series().size(), 4u);
}

TEST(Meters, WhatIsWrongInAFileIsRefusedWithItsLine) {
    const auto refusal = [](const std::string& meters) -> std::string {
        Document document;
        const std::string before = document.text();
        try {
            document.adopt(sulfur::scene::parse(
                "{\"format\": \"sulfur-scene\", \"version\": 1, \"title\": \"x\", \"world\": {},\n"
                "\"blueprints\": {}, \"bodies\": [],\n\"meters\": " +
                    meters + "}",
                "file.json"));
        } catch (const sulfur::scene::ReadError& error) {
            EXPECT_EQ(document.text(), before);
            EXPECT_EQ(error.line(), 3);
            return error.what();
        }
        return "";
    };
    const std::string good =
        R"({"id": "r", "kind": "ruler", "ends": [{"at": [0, 0]}, {"at": [1, 0]}]})";
    EXPECT_EQ(refusal("[" + good + "]"), "");
    EXPECT_NE(refusal("[" + good + "," + good + "]"), "");
    EXPECT_NE(refusal("7"), "");
    EXPECT_NE(refusal(R"([{"id": "r", "kind": "scales", "ends": []}])"), "");
    EXPECT_NE(refusal(R"([{"id": "r", "kind": "ruler", "ends": [{"at": [0, 0]}]}])"), "");
    EXPECT_NE(refusal(R"([{"id": "g", "kind": "gauge", "ends": [{"at": [0, 0]}]}])"), "");
    EXPECT_NE(
        refusal(R"([{"id": "t", "kind": "tracer", "ends": [{"at": [0, 0], "body": "nobody"}]}])")
            .find("nobody"),
        std::string::npos);
}

TEST(Meters, ASceneHasAtMostSoMany) {
    Workbench bench;
    for (std::size_t i = 0; i < mostMeters; ++i)
        dragTool(bench, ToolKind::measure, {0, 2}, {1, 2 + 0.1 * static_cast<double>(i)});
    EXPECT_EQ(bench.meters().all().size(), mostMeters);
    const std::string before = bench.document().text();
    EXPECT_THROW(dragTool(bench, ToolKind::measure, {0, 2}, {1, 5}), std::runtime_error);
    EXPECT_EQ(bench.document().text(), before);
}

TEST(Forces, BalanceOnWhatLies) {
    Workbench bench;
    dragTool(bench, ToolKind::box, {0, floorTop}, {1, 1 + floorTop});
    letPass(bench, 1.5);
    const auto& world = bench.document().world();
    Point sum(0, 0);
    for (const ForceArrow& arrow : gravityForces(world)) sum += arrow.force;
    const double weight = -sum.y();
    EXPECT_NEAR(weight, static_cast<double>(world.mass(world.bodies().back())) * 9.81, 1e-3);
    EXPECT_NEAR(typicalForce(world), weight, 1e-3);
    for (const ForceArrow& arrow : contactForces(world)) sum += arrow.force;
    EXPECT_LT(sum.norm(), 0.01 * weight);
}

TEST(Forces, AJointPullsBothOfItsEnds) {
    Workbench bench;
    openPendulum(bench);
    letPass(bench, 0.4);
    const auto arrows = jointForces(bench.document().world());
    ASSERT_EQ(arrows.size(), 1u) << "the other end is pinned";
    const Point towardsPin = Point(0, 3) - arrows[0].at;
    EXPECT_GT(arrows[0].force.dot(towardsPin), 0);
    EXPECT_NEAR(sulfur::cross(arrows[0].force, towardsPin), 0, 1e-3);
}

}  // namespace
}  // namespace sulfurchamber
