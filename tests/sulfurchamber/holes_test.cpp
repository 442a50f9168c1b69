// Polygons with holes: drawn, filled, collided with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/lattice.hpp"
#include "model/plate.hpp"
#include "model/properties.hpp"
#include "model/loop_region.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using Line = std::vector<Point>;

Line square(const Point& middle, double half) {
    return {middle + Point(-half, -half), middle + Point(half, -half), middle + Point(half, half),
            middle + Point(-half, half)};
}

void draw(Workbench& bench, const Line& corners) {
    bench.setTool(ToolKind::polygon);
    for (const Point& corner : corners) {
        bench.press({.position = corner, .reach = 0.02});
        bench.release({.position = corner, .reach = 0.02});
    }
    bench.finish();
}

BodyId polygonOf(const Workbench& bench) {
    return bench.document().bodyOf("polygon");
}

// A plate of 2 m with a hole of 1 m, at a height.
void drawRing(Workbench& bench, double height, const Line& hole) {
    draw(bench, square({0, height}, 1));
    bench.select({polygonOf(bench)});
    draw(bench, hole);
}

TEST(Holes, TrianglesFillARegionAndNothingElse) {
    const Line outer{{0, 0}, {4, 0}, {4, 3}, {2, 1.5}, {0, 3}};
    for (const Line& hole : {Line{{0.5, 0.5}, {1, 0.5}, {1, 1}, {0.5, 1}},
                             Line{{0.3, 0.2}, {3.6, 0.2}, {3.6, 1}, {2, 0.6}, {0.3, 1}}}) {
        Line points = outer;
        points.insert(points.end(), hole.begin(), hole.end());
        std::vector<std::vector<std::uint32_t>> loops(2);
        for (std::uint32_t i = 0; i < points.size(); ++i)
            loops[i < outer.size() ? 0 : 1].push_back(i);
        const auto regions = regionsOfLoops(loops, points);
        ASSERT_EQ(regions.size(), 1u);
        ASSERT_EQ(regions[0].holes.size(), 1u);
        double area = 0;
        for (const auto& [a, b, c] : trianglesOf(regions[0], points)) {
            area += areaWithin({points[a], points[b], points[c]});
            const Point middle = (points[a] + points[b] + points[c]) / 3;
            EXPECT_TRUE(inside(outer, middle) && !inside(hole, middle));
        }
        EXPECT_NEAR(area, areaWithin(outer) - areaWithin(hole), 1e-9);
        EXPECT_NEAR(area, areaOf(regions[0], points), 1e-9);
    }
}

TEST(Holes, WhatIsDrawnInsideOfTheSelectedPolygonIsItsHole) {
    Workbench bench;
    drawRing(bench, 3, square({0, 3}, 0.5));
    Document& document = bench.document();
    EXPECT_EQ(document.undoLabel(), "Cut a hole");
    ASSERT_EQ(document.scene().bodies.size(), 2u);
    const BodyId ring = polygonOf(bench);
    EXPECT_NEAR(static_cast<double>(document.world().mass(ring)), 4 * (4 - 1), 0.1);
    EXPECT_NEAR(document.world().centreOfMass(ring).y(), 3, 1e-4);
    const auto bounds = document.world().bounds(ring);
    EXPECT_NEAR(bounds.high.x() - bounds.low.x(), 2, 1e-3) << "outside it is as large as before";
    // A click into the hole means nothing, one into the rest the body.
    EXPECT_FALSE(bench.bodyUnder({.position = {0, 3}, .reach = 0.01}));
    EXPECT_EQ(bench.bodyUnder({.position = {0.75, 3}, .reach = 0.01}), ring);
    document.undo();
    EXPECT_EQ(document.scene().bodies.size(), 2u);
    EXPECT_NEAR(static_cast<double>(document.world().mass(polygonOf(bench))), 16, 1e-3);
    document.redo();
    // A second one beside the first, and one across its rim, which becomes a polygon of its own.
    bench.select({polygonOf(bench)});
    draw(bench, {{0.6, 2.2}, {0.8, 2.2}, {0.7, 2.4}});
    EXPECT_EQ(document.undoLabel(), "Cut a hole");
    bench.select({polygonOf(bench)});
    draw(bench, square({1, 3}, 0.2));
    EXPECT_EQ(document.undoLabel(), "Add polygon");
}

TEST(Holes, TheInertiaIsThatOfThePlate) {
    Workbench bench;
    drawRing(bench, 3, {{-0.5, 2.5}, {0.5, 2.5}, {0.5, 3.5}, {0, 3.1}, {-0.5, 3.5}});
    const auto& document = bench.document();
    const auto plan = document.plan().blueprint("polygon");
    const double mass = static_cast<double>(plan.mass());
    Point centre(0, 0);
    for (const auto& p : plan.particles)
        centre += static_cast<double>(p.mass) / mass * p.position.cast<double>();
    double inertia = 0;
    for (const auto& p : plan.particles)
        inertia += static_cast<double>(p.mass) * (p.position.cast<double>() - centre).squaredNorm();
    // Of many small squares.
    const Line hole{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {0, 0.1}, {-0.5, 0.5}};
    double wanted = 0, count = 0;
    Point middle(0, 0);
    std::vector<Point> inner;
    for (double x = -0.995; x < 1; x += 0.01)
        for (double y = -0.995; y < 1; y += 0.01)
            if (!inside(hole, {x, y})) inner.emplace_back(x, y);
    for (const Point& p : inner) middle += p / static_cast<double>(inner.size());
    for (const Point& p : inner) wanted += (p - middle).squaredNorm();
    count = static_cast<double>(inner.size());
    EXPECT_NEAR(inertia / mass, wanted / count, 0.03 * wanted / count);
}

TEST(Holes, AreSeenByThePhysics) {
    // A ball in the hole stays there, one on top stays on top, and a peg bears the whole.
    Workbench bench;
    drawRing(bench, 1.1, square({0, 1.1}, 0.5));
    Document& document = bench.document();
    document.edit("Add balls", [&] {
        sulfur::shapes::BallOptions ball;
        ball.radius = sulfur::Real(0.2);
        document.add("ball", ball, {.position = {0, 1.2}});
        document.add("ball", ball, {.position = {0, 2.6}});
    });
    for (int i = 0; i < 2000; ++i) bench.tick();
    const auto& world = document.world();
    EXPECT_NEAR(world.centreOfMass(document.bodyOf("ball")).y(), 0.05 + 0.5 + 0.2, 0.05);
    EXPECT_NEAR(world.centreOfMass(document.bodyOf("ball2")).y(), 0.05 + 2 + 0.2, 0.05);
    EXPECT_LT(world.meanVelocity(polygonOf(bench)).norm(), 0.05f);
}

TEST(Holes, ARingHangsOnAPeg) {
    Workbench bench;
    Document& document = bench.document();
    drawRing(bench, 3, {{-0.5, 2.5}, {0.5, 2.5}, {0.5, 3.2}, {0, 3.5}, {-0.5, 3.2}});
    document.edit("Add peg", [&] {
        sulfur::shapes::GroundOptions peg;
        peg.points = {{-0.1f, 0}, {0.1f, 0}};
        document.add("peg", peg, {.position = {0, 3.2}});
    });
    for (int i = 0; i < 3000; ++i) bench.tick();
    EXPECT_GT(document.world().centreOfMass(polygonOf(bench)).y(), 2.4);
}

TEST(Holes, ABoxCanHaveOneAndIsDensityStays) {
    Workbench bench;
    Document& document = bench.document();
    document.edit("Add box", [&] {
        document.add("box", sulfur::shapes::BoxOptions{.size = {2, 1}, .mass = 8},
                     {.position = {0, 3}, .angle = 0.5});
    });
    bench.select({document.bodyOf("box")});
    const auto before = common(document, bench.selection(), *numberProperty("density")).value;
    draw(bench, square({0, 3}, 0.15));
    EXPECT_EQ(document.undoLabel(), "Cut a hole");
    const auto after = common(document, bench.selection(), *numberProperty("density")).value;
    ASSERT_TRUE(before);
    ASSERT_TRUE(after) << "it stays selected";
    EXPECT_NEAR(*after, *before, 0.05 * *before);
    EXPECT_NEAR(document.world().pose(document.bodyOf("box")).angle, 0.5, 1e-5);
}

TEST(Holes, SurviveStretchingAndFiles) {
    Workbench bench;
    drawRing(bench, 3, square({0, 3}, 0.5));
    bench.select({polygonOf(bench)});
    bench.scale(1.5);
    const std::string text = bench.document().text();
    Workbench other;
    other.document().adopt(sulfur::scene::parse(text, "a test"));
    EXPECT_EQ(other.document().text(), text);
    const auto plate = plateOf(other.document().plan().dressed("polygon"));
    ASSERT_TRUE(plate);
    EXPECT_EQ(plate->holes.size(), 1u);
    EXPECT_NEAR(areaWithin(plate->holes[0]), 2.25, 0.02);
}

}  // namespace
}  // namespace sulfurchamber
