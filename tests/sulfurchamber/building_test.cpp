// Building: ready-made shapes, outlines drawn by hand, particles and joints one by one.
#include <gtest/gtest.h>

#include <cmath>

#include "model/lattice.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

void stroke(Workbench& bench, const std::vector<Point>& way, bool shift = false) {
    bench.press({.position = way.front(), .reach = 0.05, .shift = shift});
    for (const Point& point : way) bench.move({.position = point, .reach = 0.05, .shift = shift});
    bench.release({.position = way.back(), .reach = 0.05, .shift = shift});
}

const sulfur::World& play(Workbench& bench, int ticks) {
    for (int i = 0; i < ticks; ++i) bench.tick();
    EXPECT_EQ(bench.document().world().validate(), "");
    return bench.document().world();
}

TEST(Building, EveryShapeIsMadeByAClickOrADragAndStays) {
    for (const ToolKind tool :
         {ToolKind::wheel, ToolKind::chain, ToolKind::bridge, ToolKind::cloth, ToolKind::wall}) {
        Workbench bench;
        bench.setTool(tool);
        stroke(bench, {{-1, 3}, {0, 3.2}, {1, 4}});
        const auto& document = bench.document();
        ASSERT_EQ(document.scene().bodies.size(), 2u) << toolName(tool);
        EXPECT_EQ(document.scene().bodies[1].id, toolName(tool));
        EXPECT_NE(document.scene().blueprints[1].generator.index(), 0u) << "a recipe";
        const auto& world = play(bench, 1500);
        for (const BodyId body : world.bodies())
            EXPECT_LT(world.centreOfMass(body).norm(), 8) << toolName(tool);
        bench.document().reset();
        bench.document().undo();
        bench.document().undo();
        EXPECT_EQ(document.scene().bodies.size(), 1u);
    }
}

TEST(Building, AWheelOnABoxTurnsOnItsAxle) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    stroke(bench, {{-1, 0.8}, {1, 1.2}});
    bench.setTool(ToolKind::wheel);
    for (const double x : {-0.7, 0.7}) stroke(bench, {{x, 0.8}, {x + 0.3, 0.8}});
    auto& document = bench.document();
    EXPECT_EQ(document.scene().attachments.size(), 2u);
    const auto& world = play(bench, 1000);
    const Point hub = world.position(world.particles(document.bodyOf("wheel")).back());
    const Point box = world.centreOfMass(document.bodyOf("box"));
    EXPECT_NEAR((hub - box).norm(), std::hypot(0.7, 0.2), 0.03);
    // A push makes it roll.
    document.world().setVelocity(document.bodyOf("box"), {2, 0});
    play(bench, 500);
    EXPECT_GT(world.centreOfMass(document.bodyOf("box")).x(), box.x() + 0.5);
}

TEST(Building, APolygonIsClosedByItsFirstCornerAndMayBeConcave) {
    Workbench bench;
    bench.setTool(ToolKind::polygon);
    const std::vector<Point> corners{{0, 1}, {2, 1}, {2, 3}, {1, 1.5}, {0, 3}};
    for (const Point& corner : corners) stroke(bench, {corner});
    EXPECT_EQ(bench.preview().points.size(), 6u);
    stroke(bench, {corners[0]});
    const auto& document = bench.document();
    ASSERT_TRUE(document.bodyOf("polygon"));
    const auto bounds = document.world().bounds(document.bodyOf("polygon"));
    EXPECT_NEAR(bounds.high.x() - bounds.low.x(), 2, 0.05);
    EXPECT_NEAR(static_cast<double>(document.world().mass(document.bodyOf("polygon"))),
                4 * areaWithin(corners), 0.01);
    play(bench, 1000);
    EXPECT_LT(document.world().meanVelocity(document.bodyOf("polygon")).norm(), 0.1f);
}

TEST(Building, APolygonThatCrossesItselfIsRefused) {
    Workbench bench;
    bench.setTool(ToolKind::polygon);
    for (const Point& corner : {Point(0, 1), Point(2, 3), Point(2, 1), Point(0, 3)})
        stroke(bench, {corner});
    EXPECT_THROW(bench.finish(), std::runtime_error);
    EXPECT_EQ(bench.document().scene().bodies.size(), 1u);
    EXPECT_FALSE(bench.document().canUndo());
}

std::vector<Point> circle(const Point& centre, double radius, double lobes) {
    std::vector<Point> line;
    for (int i = 0; i <= 90; ++i) {
        const double angle = i * 6.2831853 / 90;
        const double r = radius * (1 + 0.2 * std::sin(lobes * angle));
        line.emplace_back(centre + r * Point(std::cos(angle), std::sin(angle)));
    }
    return line;
}

TEST(Building, ADrawnCreatureIsSoftAndKeepsItsShape) {
    for (const double size : {0.3, 1.0, 3.0}) {
        Workbench bench;
        bench.setTool(ToolKind::draw);
        stroke(bench, circle({0, 2 * size + 1}, size, 3));
        const auto& document = bench.document();
        ASSERT_TRUE(document.bodyOf("drawing")) << size;
        const auto& world = document.world();
        const auto particles = world.particles(document.bodyOf("drawing")).size();
        EXPECT_GT(particles, 20u);
        EXPECT_LT(particles, 200u);
        const auto before = world.bounds(document.bodyOf("drawing"));
        const double width = before.high.x() - before.low.x();
        play(bench, 500 * 6);
        const auto after = world.bounds(document.bodyOf("drawing"));
        EXPECT_GT((after.high - after.low).minCoeff(), 0.6 * width) << size;
        EXPECT_LT((after.high - after.low).maxCoeff(), 1.3 * width) << size;
    }
}

TEST(Building, AScribbleIsRefusedInASentence) {
    Workbench bench;
    bench.setTool(ToolKind::draw);
    EXPECT_THROW(stroke(bench, {{0, 1}, {2, 3}, {2, 1}, {0, 3}}), std::runtime_error);
    EXPECT_EQ(bench.document().scene().bodies.size(), 1u);
}

TEST(Building, ParticlesAndJointsMakeABody) {
    Workbench bench;
    bench.setTool(ToolKind::particle);
    const std::vector<Point> corners{{0, 2}, {1, 2}, {0.5, 2.8}};
    for (const Point& corner : corners) stroke(bench, {corner});
    auto& document = bench.document();
    EXPECT_EQ(document.scene().bodies.size(), 4u);
    bench.setTool(ToolKind::joint);
    stroke(bench, {corners[0], corners[1]});
    stroke(bench, {corners[1], corners[2]});
    stroke(bench, {corners[2], corners[0]}, true);
    ASSERT_EQ(document.scene().bodies.size(), 2u) << "the particles have become one body";
    const auto blueprint = document.plan().blueprint(document.scene().bodies[1].id);
    ASSERT_EQ(blueprint.particles.size(), 3u);
    ASSERT_EQ(blueprint.joints.size(), 3u);
    EXPECT_FALSE(std::isfinite(blueprint.joints[0].stiffness));
    EXPECT_TRUE(std::isfinite(blueprint.joints[2].stiffness)) << "Shift makes it elastic";
    const auto& world = play(bench, 1500);
    const BodyId body = document.bodyOf(document.scene().bodies[1].id);
    ASSERT_TRUE(body);
    EXPECT_GT(world.centreOfMass(body).y(), 0.05);
    document.reset();
    while (document.canUndo()) document.undo();
    EXPECT_EQ(document.scene().bodies.size(), 1u);
}

TEST(Building, AParticleIsJoinedToABodyThatRuns) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    stroke(bench, {{0, 1}});
    auto& document = bench.document();
    const auto& world = play(bench, 1000);
    const Point corner = world.position(world.particles(document.bodyOf("box"))[2]);
    bench.setTool(ToolKind::particle);
    stroke(bench, {corner + Point(0.3, 0.4)});
    bench.setTool(ToolKind::joint);
    stroke(bench, {corner, corner + Point(0.3, 0.4)});
    ASSERT_TRUE(document.bodyOf("box"));
    EXPECT_EQ(world.particles(document.bodyOf("box")).size(), 6u);
    play(bench, 200);
    document.reset();
    const auto bounds = world.bounds(document.bodyOf("box"));
    EXPECT_NEAR(bounds.high.x(), corner.x() + 0.35, 0.02) << "the plan has it where it was joined";
}

TEST(Building, TwoBodiesAreJoinedByAJointBetweenThem) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    for (const double x : {-1.0, 1.0}) stroke(bench, {{x, 1}});
    auto& document = bench.document();
    const auto& world = document.world();
    const Point a = world.position(world.particles(document.bodyOf("box"))[1]);
    const Point b = world.position(world.particles(document.bodyOf("box2"))[0]);
    bench.setTool(ToolKind::joint);
    stroke(bench, {a, b});
    EXPECT_EQ(world.connections().size(), 1u);
    EXPECT_EQ(document.scene().connections.size(), 1u);
}

TEST(Lattice, SimplifiedLinesStayNear) {
    const auto line = circle({0, 0}, 1, 3);
    const auto few = simplified(line, 0.01, true);
    EXPECT_LT(few.size(), line.size() / 2);
    EXPECT_NEAR(areaWithin(few), areaWithin(line), 0.05);
    EXPECT_FALSE(meetsItself(few));
}

}  // namespace
}  // namespace sulfurchamber
