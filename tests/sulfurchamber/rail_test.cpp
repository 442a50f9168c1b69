// Sliders on lines of joints: which line a click finds, and what is drawn of it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/fitting_marks.hpp"
#include "model/properties.hpp"
#include "model/rail.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;
using sulfur::scene::Slider;

sulfur::Blueprint bentWire(const std::vector<Vec2>& corners, Real bend = 0, bool closed = false) {
    sulfur::Blueprint made;
    made.kind = sulfur::BodyKind::fixed;
    for (const Vec2& corner : corners) made.particles.push_back({.position = corner});
    const auto count = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t i = 0; i + (closed ? 0 : 1) < count; ++i)
        made.joints.push_back({.a = i, .b = (i + 1) % count, .radius = Real(0.02), .bend = bend});
    return made;
}

sulfur::Blueprint hoop() {
    constexpr int parts = 8;
    std::vector<Vec2> corners;
    for (int i = 0; i < parts; ++i) {
        const double angle = 2 * std::numbers::pi * i / parts;
        corners.emplace_back(static_cast<Real>(std::cos(angle)),
                             static_cast<Real>(std::sin(angle)));
    }
    return bentWire(corners, static_cast<Real>(2 * std::numbers::pi / parts), true);
}

/// A bent wire, a ball on its upper link, and what a person does.
struct Slide {
    Workbench bench;

    Slide() {
        sulfur::scene::Prefab prefab;
        prefab.blueprint = bentWire({{0, 3}, {2, 2}, {4, 2}});
        prefab.blueprint.name = "wire";
        document().edit("Wire", [&] { document().add(prefab, {}); });
        bench.setTool(ToolKind::ball);
        drag({0.6, 2.7}, {0.75, 2.7});
    }
    Document& document() { return bench.document(); }
    sulfur::World& world() { return document().world(); }
    void drag(Point from, Point to) {
        bench.press({.position = from, .reach = 0.05});
        bench.move({.position = to, .reach = 0.05});
        bench.release({.position = to, .reach = 0.05});
    }
    void slider(Point at) {
        bench.setTool(ToolKind::slider);
        drag(at, at);
    }
    void run(double seconds) {
        const int ticks = static_cast<int>(std::lround(seconds * world().settings().tickRate));
        for (int i = 0; i < ticks; ++i) bench.tick();
    }
    const auto& mechanisms() { return document().scene().mechanisms; }
    const Slider& made() { return std::get<Slider>(mechanisms().at(0).spec); }
    FittingMark mark() { return fittingMarks(document()).at(0); }
};

TEST(Rails, AClickPutsABodyOnALineThatItFollows) {
    Slide slide;
    slide.slider({0.6, 2.7});
    ASSERT_EQ(slide.mechanisms().size(), 1u);
    EXPECT_EQ(slide.made().a, "wire");
    EXPECT_EQ(slide.made().b, "ball");
    EXPECT_EQ(slide.made().rail, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_NEAR(slide.made().at.x(), 0.6, 1e-4);
    EXPECT_NEAR(slide.made().at.y(), 2.7, 1e-4);
    EXPECT_EQ(slide.document().undoLabel(), "Add slider");
    slide.run(1);
    const Point ball = slide.world().centreOfMass(slide.document().bodyOf("ball"));
    EXPECT_GT(ball.x(), 2.2) << "round the corner";
    EXPECT_NEAR(ball.y(), 2, 0.01) << "along the line";
    slide.document().undo();
    EXPECT_TRUE(slide.mechanisms().empty());
}

// It need not be hit in its middle, which then comes onto the line.
TEST(Rails, ADiscIsHeldAtItsMiddle) {
    Slide slide;
    slide.drag({2.9, 2.1}, {3.1, 2.1});
    slide.slider({2.9, 2.01});
    EXPECT_EQ(slide.made().at, Point(2.9, 2.1));
    slide.run(0.5);
    EXPECT_NEAR(slide.world().centreOfMass(slide.document().bodyOf("ball2")).y(), 2, 1e-3);
}

TEST(Rails, TheMarkFollowsTheLineAndIsHitThere) {
    Slide slide;
    slide.slider({0.6, 2.7});
    const FittingMark mark = slide.mark();
    ASSERT_EQ(mark.points.size(), 4u);
    EXPECT_EQ(mark.points[0], Point(0, 3));
    EXPECT_EQ(mark.points[1], Point(2, 2));
    EXPECT_EQ(mark.points[2], Point(4, 2));
    EXPECT_NEAR((mark.points[3] - Point(0.6, 2.7)).norm(), 0, 1e-4);
    EXPECT_TRUE(fittingAt(slide.document(), {3, 2}, 0.05)) << "its second link";
    EXPECT_FALSE(fittingAt(slide.document(), {2, 2.5}, 0.05)) << "between both ends";
}

// Whoever cuts a link of it cuts the rail.
TEST(Rails, ARemovedJointEndsTheRailOrTheSlider) {
    Slide slide;
    slide.slider({0.6, 2.7});
    const auto cut = [&](Point from, Point to) {
        slide.document().edit("Cut", [&] {
            const auto joints = slide.world().joints(slide.document().bodyOf("wire"));
            for (const auto joint : std::vector(joints.begin(), joints.end())) {
                const auto info = slide.world().info(joint);
                if (slide.world().position(info.a) == from && slide.world().position(info.b) == to)
                    slide.document().remove(joint);
            }
        });
    };
    cut({2, 2}, {4, 2});
    ASSERT_EQ(slide.mechanisms().size(), 1u);
    EXPECT_EQ(slide.made().rail, (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(slide.mark().points.size(), 3u);
    slide.document().undo();
    cut({0, 3}, {2, 2});
    EXPECT_TRUE(slide.mechanisms().empty());
    slide.document().undo();
    EXPECT_EQ(slide.made().rail.size(), 2u);
}

TEST(Rails, ARopeOfAnotherNumberOfLinksIsARailStill) {
    Slide slide;
    slide.bench.setTool(ToolKind::rope);
    slide.drag({-6, 4}, {-3, 4});
    slide.bench.setTool(ToolKind::ball);
    slide.drag({-5, 4}, {-4.8, 4});
    slide.slider({-5, 4});
    EXPECT_EQ(slide.made().a, "rope");
    const auto links = [&](double count) {
        const BodyId rope = slide.document().bodyOf("rope");
        slide.document().edit("Links", [&] {
            slide.document().change({&rope, 1}, [&](sulfur::scene::Prefab& prefab) {
                numberProperty("links")->set(prefab, count);
            });
        });
        return slide.world().joints(slide.document().bodyOf("rope")).size();
    };
    for (const double count : {12.0, 50.0}) {
        EXPECT_EQ(links(count), static_cast<std::size_t>(count));
        ASSERT_EQ(slide.made().rail.size(), static_cast<std::size_t>(count));
        EXPECT_EQ(slide.made().rail.back(), static_cast<std::uint32_t>(count) - 1);
        const auto& made = slide.document().made().at(0);
        EXPECT_EQ(slide.world().info(made.id).rail.size(), static_cast<std::size_t>(count));
    }
    // A part of a rope is not known again.
    slide.document().edit("Shorter", [&] {
        slide.document().refit(
            *slide.bench.fitting(),
            [](Fitting& one) {
                std::get<Slider>(std::get<sulfur::scene::SceneMechanism>(one).spec).rail.resize(30);
            },
            false);
    });
    links(20);
    EXPECT_TRUE(slide.mechanisms().empty());
}

TEST(Rails, WhereNoLineIsThatIsToldAndNothingChanges) {
    Slide slide;
    slide.bench.setTool(ToolKind::box);
    slide.drag({-4, 3}, {-3, 4});
    const std::string before = slide.document().text();
    EXPECT_THROW(slide.slider({-3.5, 3.5}), std::runtime_error);
    EXPECT_EQ(slide.document().text(), before);
}

TEST(Rails, OfTwoLinesTheLongerOneBears) {
    sulfur::World world;
    const BodyId shorter = world.add(bentWire({{0, -1}, {0, 1}})).id();
    const BodyId longer = world.add(bentWire({{-1, 0}, {1, 0}, {3, 0}})).id();
    const auto found = railsAt(world, {0, 0}, 0.1);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].body, longer);
    EXPECT_NEAR(found[0].length, 4, 1e-6);
    EXPECT_EQ(found[1].body, shorter);
    EXPECT_TRUE(railsAt(world, {0.5, 0.5}, 0.1).empty());
}

TEST(Rails, ALineEndsWhereItDivides) {
    sulfur::World world;
    sulfur::Blueprint plan = bentWire({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
    plan.particles.push_back({.position = {2, 1}});
    plan.joints.push_back({.a = 2, .b = 4, .radius = Real(0.02)});
    world.add(plan);
    const auto found = railsAt(world, {0.5, 0}, 0.1);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].links.size(), 2u);
    EXPECT_EQ(lineOf(world, found[0].links).back(), Point(2, 0));
}

TEST(Rails, AHoopOfArcsIsClosedAndRound) {
    sulfur::World world;
    const BodyId body = world.add(hoop()).id();
    const auto found = railsAt(world, {0, 1.01}, 0.05);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].links.size(), world.joints(body).size());
    const auto line = lineOf(world, found[0].links);
    EXPECT_NEAR((line.front() - line.back()).norm(), 0, 1e-6);
    for (const Point& point : line) EXPECT_NEAR(point.norm(), 1, 1e-5);
    EXPECT_NEAR(found[0].length, 2 * std::numbers::pi, 0.01);
    // Inwards as well.
    for (const Point& point : chordsOf({1, 0}, {0, 1}, -std::numbers::pi / 2))
        EXPECT_NEAR((point - Point(1, 1)).norm(), 1, 1e-9);
}

}  // namespace
}  // namespace sulfurchamber
