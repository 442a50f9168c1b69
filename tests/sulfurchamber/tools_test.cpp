#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

void drag(Workbench& bench, Point from, Point to, bool shift = false) {
    bench.press({.position = from, .shift = shift});
    bench.move({.position = (from + to) / 2, .shift = shift});
    bench.release({.position = to, .shift = shift});
}

void click(Workbench& bench, Point at, bool shift = false) {
    drag(bench, at, at, shift);
}

std::size_t bodyCount(const Workbench& bench) {
    return bench.document().world().bodies().size();
}

BodyId newest(const Workbench& bench) {
    return bench.document().world().bodies().back();
}

TEST(Tools, NamesLeadBackToTools) {
    for (const ToolKind tool : allTools()) EXPECT_EQ(toolFromName(toolName(tool)), tool);
    EXPECT_FALSE(toolFromName("hammer"));
}

TEST(Tools, EveryToolHasAHintAndSurvivesStrayEvents) {
    for (const ToolKind tool : allTools()) {
        Workbench bench;
        bench.setTool(tool);
        EXPECT_FALSE(bench.hint().empty());
        const auto before = bench.document().world().hash();
        bench.move({.position = {1, 5}});
        bench.release({.position = {1, 5}});
        bench.cancel();
        bench.press({.position = {1, 5}});
        bench.cancel();
        bench.release({.position = {2, 6}});
        EXPECT_EQ(bench.document().world().hash(), before) << toolName(tool);
    }
}

TEST(Tools, WhatIsDrawnSaysHowLargeItIs) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    bench.press({.position = {0, 1}});
    bench.move({.position = {1.2, 1.5}});
    EXPECT_EQ(bench.hint(), "1.20 m wide, 0.50 m high, 2.40 kg");
    bench.setTool(ToolKind::ground);
    bench.press({.position = {0, 1}});
    bench.move({.position = {2, 3}});
    EXPECT_EQ(bench.hint(), "2.83 m, 45.0\xC2\xB0");
}

TEST(Tools, AClickDropsABoxThatFallsOntoTheFloor) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    click(bench, {1, 2});
    ASSERT_EQ(bodyCount(bench), 2u);
    const BodyId box = newest(bench);
    EXPECT_NEAR(bench.document().world().centreOfMass(box).y(), 2, 1e-5);
    bench.document().play();
    for (int i = 0; i < 1000; ++i) bench.tick();
    EXPECT_NEAR(bench.document().world().centreOfMass(box).y(), 0.05 + 0.25, 0.02);
}

TEST(Tools, ADragSaysHowLargeTheBoxIs) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    drag(bench, {0, 1}, {3, 2});
    const auto& world = bench.document().world();
    double low = 1e9;
    double high = -1e9;
    for (const auto particle : world.particles(newest(bench))) {
        low = std::min(low, world.position(particle).x());
        high = std::max(high, world.position(particle).x());
    }
    EXPECT_NEAR(high - low, 3 - 2 * 0.02, 1e-4);
    EXPECT_NEAR(static_cast<double>(world.mass(newest(bench))), 12, 1e-4);
}

std::vector<Point> placesOf(const sulfur::World& world, BodyId body) {
    std::vector<Point> places;
    for (const auto particle : world.particles(body)) places.push_back(world.position(particle));
    return places;
}

/// The largest change of a distance, as a share of the size.
double changeOfShape(const std::vector<Point>& before, const std::vector<Point>& after) {
    double most = 0, size = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double was = (before[i] - before[j]).norm();
            size = std::max(size, was);
            most = std::max(most, std::abs((after[i] - after[j]).norm() - was));
        }
    return most / size;
}

/// A jelly of the tool, whose shape is known.
struct Jelly {
    Jelly(Workbench& workbench, const Point& low, const Point& size) : bench(workbench) {
        bench.setTool(ToolKind::jelly);
        drag(bench, low, low + size);
        body = newest(bench);
        before = placesOf(bench.document().world(), body);
    }
    double change() const {
        return changeOfShape(before, placesOf(bench.document().world(), body));
    }

    Workbench& bench;
    BodyId body;
    std::vector<Point> before;
};

const std::vector<Point>& jellySizes() {
    static const std::vector<Point> sizes{Point(0.1, 0.1), Point(0.1, 0.05), Point(0.4, 0.3),
                                          Point(0.8, 0.8), Point(2, 1),      Point(5, 4),
                                          Point(0.2, 0.6), Point(0.3, 3),    Point(2.5, 0.15),
                                          Point(5, 0.5),   Point(0.1, 1),    Point(0.15, 2.5)};
    return sizes;
}

void tickFor(Workbench& bench, double seconds) {
    const double ticks = seconds * bench.document().world().settings().tickRate;
    for (int i = 0; i < ticks; ++i) bench.tick();
}

TEST(Tools, AJellyOfAnySizeHasItsShapeAgainAfterAFall) {
    for (const Point& size : jellySizes()) {
        Workbench bench;
        const Jelly jelly(bench, {0, 10}, size);
        bench.document().play();
        tickFor(bench, 8);
        EXPECT_LT(jelly.change(), 0.02) << size.transpose();
    }
}

// How a strip buckles is a matter of chance.
TEST(Tools, AJellyOfAnySizeHasItsShapeAgainAfterACrateOnIt) {
    for (const Point& size : jellySizes())
        for (int i = -4; i <= 4; ++i) {
            Workbench bench;
            const Jelly jelly(bench, {-size.x() / 2, 0.05}, size);
            BodyId crate;
            bench.document().edit("Crate", [&] {
                crate = bench.document().add(
                    "crate", sulfur::shapes::BoxOptions{.size = {0.5f, 0.5f}, .mass = 50},
                    {.position = {0.005 * i, size.y() + 0.5}});
            });
            bench.document().play();
            tickFor(bench, 3);
            bench.select({crate});
            bench.deleteSelection();
            tickFor(bench, 5);
            EXPECT_LT(jelly.change(), 0.02) << size.transpose() << ", " << i;
        }
}

TEST(Tools, AJellyOfAnySizeHasItsShapeAgainAfterItWasPulledAbout) {
    for (const Point& size : jellySizes()) {
        Workbench bench;
        const Jelly jelly(bench, {-size.x() / 2, 0.05}, size);
        bench.setTool(ToolKind::select);
        bench.document().play();
        bench.press({.position = bench.document().world().centreOfMass(jelly.body)});
        for (const Point& to : {Point(5, 4), Point(-5, 6), Point(5, 0.5), Point(-5, 1)}) {
            bench.move({.position = to});
            tickFor(bench, 0.4);
        }
        bench.move({.position = {0, 1}});  // let go at once it would fly off, and turn for ever
        tickFor(bench, 2);
        bench.release({.position = {0, 1}});
        tickFor(bench, 5);
        EXPECT_LT(jelly.change(), 0.02) << size.transpose();
    }
}

TEST(Tools, SnappingRoundsToTheGrid) {
    Workbench bench;
    bench.setTool(ToolKind::ball);
    bench.setSnap(0.5);
    click(bench, {1.13, 2.68});
    const Point at = bench.document().world().centreOfMass(newest(bench));
    EXPECT_NEAR(at.x(), 1.0, 1e-6);
    EXPECT_NEAR(at.y(), 2.5, 1e-6);
}

TEST(Tools, ARopeTiesItselfToTheBoxBelow) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    click(bench, {0, 2});
    const auto& world = bench.document().world();
    const Point corner = world.position(world.particles(newest(bench))[2]);
    bench.setTool(ToolKind::rope);
    drag(bench, {corner.x(), 4}, corner);
    EXPECT_EQ(world.connections().size(), 1u);
    bench.document().play();
    for (int i = 0; i < 1500; ++i) bench.tick();
    EXPECT_GT(world.centreOfMass(world.bodies()[1]).y(), 1.0) << "the pinned rope holds the box";
}

/// Between two boxes it hangs a little; one that is short has a single link, which cannot.
TEST(Tools, ARopeBetweenTwoBoxesHasSlackIfItCan) {
    for (const double apart : {0.17, 0.2, 0.5, 3.0}) {
        Workbench bench;
        const auto& world = bench.document().world();
        bench.setTool(ToolKind::ball);
        click(bench, {0, 5});
        const Point left = world.centreOfMass(newest(bench));
        click(bench, {apart, 5});
        const Point right = world.centreOfMass(newest(bench));
        bench.setTool(ToolKind::rope);
        drag(bench, left, right);
        EXPECT_EQ(world.connections().size(), 2u) << apart;
        const BodyId rope = newest(bench);
        double length = 0;
        for (const auto joint : world.joints(rope))
            length += static_cast<double>(world.info(joint).restLength);
        const auto ends = world.particles(rope);
        const double way = (world.position(ends.back()) - world.position(ends.front())).norm();
        const double slack = world.joints(rope).size() > 1 ? 0.02 : 0;
        EXPECT_NEAR(length, (1 + slack) * way, 1e-3 * way) << apart;
    }
}

/// It is let go level, swings and rests in some seconds, as what people walk on does.
TEST(Tools, ARopeBridgeComesToRest) {
    for (const double span : {4.0, 6.0, 12.0}) {
        Workbench bench;
        const auto& world = bench.document().world();
        bench.setTool(ToolKind::rope);
        drag(bench, {-span / 2, 6}, {span / 2, 6}, true);
        const BodyId rope = newest(bench);
        const int second = world.settings().tickRate;
        double fastest = 0, lowest = 6;
        for (int tick = 0; tick < 12 * second; ++tick) {
            bench.tick();
            for (const auto particle : world.particles(rope)) {
                lowest = std::min(lowest, world.position(particle).y());
                if (tick >= 6 * second)
                    fastest =
                        std::max(fastest, static_cast<double>(world.velocity(particle).norm()));
            }
        }
        EXPECT_LT(fastest, 0.05) << span;
        EXPECT_TRUE(world.asleep(rope)) << span;
        EXPECT_LT(lowest, 6 - 0.08 * span) << "it hangs";
    }
}

/// Crates in its middle and beside it: those beside it sway slowly, with a period of up to 9 s.
TEST(Tools, ARopeBridgeWithCratesSleepsWithinFiveSeconds) {
    for (const int crates : {1, 2, 3, 4, 5})
        for (const double aside : {0.0, 0.2}) {
            Workbench bench;
            const auto& world = bench.document().world();
            bench.setTool(ToolKind::ground);
            drag(bench, {-6, 3}, {-3, 3});
            drag(bench, {3, 3}, {6, 3});
            bench.setTool(ToolKind::rope);
            drag(bench, {-3, 3}, {3, 3});
            bench.setTool(ToolKind::box);
            for (int i = 0; i < crates; ++i)
                click(bench, {aside + 0.75 * (i - 0.5 * (crates - 1)), 3.6});
            tickFor(bench, 5);
            for (const BodyId body : world.bodies())
                if (world.kind(body) == sulfur::BodyKind::dynamic) {
                    EXPECT_TRUE(world.asleep(body)) << crates << world.name(body) << aside;
                    EXPECT_GT(world.centreOfMass(body).y(), 2) << "it bears them";
                }
        }
}

TEST(Tools, PinTogglesAndCutDivides) {
    Workbench bench;
    bench.setTool(ToolKind::rope);
    drag(bench, {0, 5}, {0, 3});
    const auto& world = bench.document().world();
    const BodyId rope = newest(bench);
    const std::size_t links = world.joints(rope).size();
    bench.setTool(ToolKind::cut);
    drag(bench, {-1, 4.02}, {1, 4.02});
    std::size_t left = 0;
    for (const BodyId body : world.bodies())
        if (world.kind(body) == sulfur::BodyKind::dynamic) left += world.joints(body).size();
    EXPECT_EQ(left, links - 1);
    bench.setTool(ToolKind::pin);
    const auto last = world.particles(rope).front();
    EXPECT_TRUE(world.info(last).pinned);
    click(bench, world.position(last));
    EXPECT_FALSE(world.info(last).pinned);
    click(bench, world.position(last));
    EXPECT_TRUE(world.info(last).pinned);
}

TEST(Tools, EraseRemovesAndEscapeBringsBack) {
    Workbench bench;
    bench.setTool(ToolKind::ball);
    click(bench, {0, 2});
    click(bench, {3, 2});
    bench.setTool(ToolKind::erase);
    bench.press({.position = {0, 2}});
    EXPECT_EQ(bodyCount(bench), 2u);
    bench.cancel();
    EXPECT_EQ(bodyCount(bench), 3u);
    drag(bench, {0, 2}, {3, 2});
    EXPECT_EQ(bodyCount(bench), 1u);
    bench.document().undo();
    EXPECT_EQ(bodyCount(bench), 3u) << "one drag is one step";
}

TEST(Tools, SelectMovesWhileTimeStandsStill) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    click(bench, {0, 2});
    bench.setTool(ToolKind::select);
    drag(bench, {0, 2}, {1.5, 2.5});
    const BodyId box = newest(bench);
    EXPECT_TRUE(bench.selected(box));
    const Point at = bench.document().world().centreOfMass(box);
    EXPECT_NEAR(at.x(), 1.5, 1e-5);
    EXPECT_NEAR(at.y(), 2.5, 1e-5);
    bench.document().undo();
    EXPECT_NEAR(bench.document().world().centreOfMass(box).x(), 0, 1e-5);
}

TEST(Tools, TheSpringCarriesThingsOfAnyMassToThePointer) {
    for (const double size : {0.2, 0.6, 3.0}) {
        Workbench bench;
        bench.setTool(ToolKind::box);
        drag(bench, {-size / 2, 1}, {size / 2, 1 + size});
        bench.setTool(ToolKind::select);
        bench.document().play();
        bench.press({.position = {0, 1 + size / 2}});
        bench.move({.position = {2, 4}});
        for (int i = 0; i < 1500; ++i) bench.tick();
        const Point at = bench.document().world().centreOfMass(newest(bench));
        EXPECT_NEAR(at.x(), 2, 0.15) << size;
        EXPECT_NEAR(at.y(), 4, 0.25) << size;
        EXPECT_EQ(bench.preview().kind, Preview::Kind::spring);
        bench.release({.position = {2, 4}});
        EXPECT_EQ(bench.preview().kind, Preview::Kind::none);
    }
}

TEST(Tools, TheSpringHoldsALongRopeWithoutExploding) {
    Workbench bench;
    bench.setTool(ToolKind::rope);
    drag(bench, {0, 6}, {0, 2});
    bench.setTool(ToolKind::select);
    bench.document().play();
    bench.press({.position = {0, 2}});
    bench.move({.position = {3, 5}});
    for (int i = 0; i < 1500; ++i) {
        bench.tick();
        ASSERT_LT(static_cast<double>(bench.document().world().meanVelocity(newest(bench)).norm()),
                  60);
    }
    EXPECT_EQ(bench.document().world().validate(), "");
}

TEST(Tools, AFrameSelectsAndDeleteIsUndone) {
    Workbench bench;
    bench.setTool(ToolKind::ball);
    for (const double x : {0.0, 1.0, 5.0}) click(bench, {x, 2});
    bench.setTool(ToolKind::select);
    drag(bench, {-1, 1}, {2, 3});
    EXPECT_EQ(bench.selection().size(), 2u);
    click(bench, {5, 2}, true);
    EXPECT_EQ(bench.selection().size(), 3u);
    click(bench, {1, 2});
    EXPECT_EQ(bench.selection().size(), 1u) << "a click means this one of several";
    bench.selectAll();
    bench.toggle(bench.document().world().bodies()[0]);
    bench.deleteSelection();
    EXPECT_EQ(bodyCount(bench), 1u);
    EXPECT_TRUE(bench.selection().empty());
    bench.document().undo();
    EXPECT_EQ(bodyCount(bench), 4u);
}

TEST(Tools, CopiedBodiesArriveWithTheirConnectionsInAnotherWindow) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    click(bench, {0, 2});
    const auto& world = bench.document().world();
    bench.setTool(ToolKind::rope);
    drag(bench, {0.23, 4}, world.position(world.particles(newest(bench))[2]));
    bench.select({world.bodies()[1], world.bodies()[2]});
    const std::string text = bench.copy();
    Workbench other;
    other.paste(text, {1, 0});
    EXPECT_EQ(bodyCount(other), 3u);
    EXPECT_EQ(other.document().world().connections().size(), 1u);
    EXPECT_EQ(other.selection().size(), 2u);
    EXPECT_NEAR(other.document().world().centreOfMass(other.document().world().bodies()[1]).x(), 1,
                1e-4);
    EXPECT_THROW(other.paste("no scene at all", {0, 0}), sulfur::scene::ReadError);
    EXPECT_EQ(bodyCount(other), 3u);
    other.duplicate();
    EXPECT_EQ(bodyCount(other), 5u);
}

TEST(Tools, RainFallsAtItsRateAndIsOneStep) {
    Workbench bench;
    const auto before = bench.document().world().hash();
    bench.setRain(10);
    bench.document().play();
    for (int i = 0; i < 1000; ++i) bench.tick();
    EXPECT_EQ(bodyCount(bench), 1u + 20u);
    EXPECT_EQ(bench.document().world().validate(), "");
    bench.setRain(0);
    bench.document().undo();
    EXPECT_EQ(bodyCount(bench), 1u);
    bench.document().reset();
    EXPECT_EQ(bench.document().world().hash(), before);
}

TEST(Tools, DroppedBoxesDoNotOverlap) {
    Workbench bench;
    bench.dropBoxes(30);
    const auto& world = bench.document().world();
    ASSERT_EQ(bodyCount(bench), 31u);
    for (std::size_t i = 1; i < 31; ++i)
        for (std::size_t j = i + 1; j < 31; ++j)
            EXPECT_GT(
                (world.centreOfMass(world.bodies()[i]) - world.centreOfMass(world.bodies()[j]))
                    .norm(),
                0.5);
}

TEST(Tools, TheRulerMeasuresWhileItIsDrawn) {
    Workbench bench;
    const std::string before = bench.document().text();
    bench.setTool(ToolKind::measure);
    EXPECT_EQ(bench.preview().kind, Preview::Kind::none);
    bench.press({.position = {1, 1}});
    bench.move({.position = {4, 5}});
    EXPECT_EQ(bench.preview().kind, Preview::Kind::ruler);
    EXPECT_DOUBLE_EQ(bench.preview().size, 5);
    EXPECT_NE(bench.hint().find("5.000 m at 53.1 degrees: 3.000 m to the right, 4.000 m up"),
              std::string::npos)
        << bench.hint();
    // Its ends go to particles.
    bench.cancel();
    const auto floor = bench.document().world().bodies()[0];
    const Point end =
        bench.document().world().position(bench.document().world().particles(floor)[0]);
    bench.press({.position = end + Point(0.05, 0.02), .reach = 0.2});
    bench.move({.position = end + Point(0, 2)});
    EXPECT_EQ(bench.preview().from, end);
    EXPECT_DOUBLE_EQ(bench.preview().size, 2);
    bench.cancel();
    EXPECT_EQ(bench.preview().kind, Preview::Kind::none);
    EXPECT_EQ(bench.document().text(), before);
    EXPECT_FALSE(bench.document().canUndo());
}

}  // namespace
}  // namespace sulfurchamber
