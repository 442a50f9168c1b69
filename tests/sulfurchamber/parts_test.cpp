// Single particles and joints: chosen by a second click, changed, moved and taken away.
#include <gtest/gtest.h>

#include <cmath>

#include "model/fitting_properties.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

void click(Workbench& bench, const Point& at, int clicks = 1) {
    const Pointer pointer{.position = at, .reach = 0.05, .clicks = clicks};
    bench.press(pointer);
    bench.release(pointer);
}
void takePart(Workbench& bench, const Point& at) {
    click(bench, at);
    click(bench, at, 2);
}
void drag(Workbench& bench, const Point& from, const Point& to, bool shift = false) {
    bench.press({.position = from, .reach = 0.05, .shift = shift});
    bench.move({.position = to, .reach = 0.05, .shift = shift});
    bench.release({.position = to, .reach = 0.05, .shift = shift});
}
double valueOf(const Workbench& bench, std::string_view key) {
    const Fitting fitting = bench.document().fitting(*bench.fitting());
    const FittingProperty* property = fittingProperty(key, fitting);
    return property == nullptr ? std::nan("") : *property->get(fitting);
}
void setValue(Workbench& bench, std::string_view key, double value) {
    auto& document = bench.document();
    const auto ref = *bench.fitting();
    const FittingProperty* property = fittingProperty(key, document.fitting(ref));
    ASSERT_NE(property, nullptr) << key;
    document.edit("Change", [&] { setFittingProperty(document, ref, *property, value); });
}

/// Three particles in a row, 1 m apart and 2 m above the floor, with two rigid joints.
class Parts : public ::testing::Test {
protected:
    Parts() {
        bench_.setTool(ToolKind::particle);
        for (const double x : {-1.0, 0.0, 1.0}) click(bench_, {x, 2});
        bench_.setTool(ToolKind::joint);
        drag(bench_, {-1, 2}, {0, 2});
        drag(bench_, {0, 2}, {1, 2});
        bench_.setTool(ToolKind::select);
        EXPECT_EQ(plan().particles.size(), 3u);
        EXPECT_EQ(plan().joints.size(), 2u);
    }
    sulfur::Blueprint plan() const {
        return bench_.document().plan().blueprint(bench_.document().scene().bodies.back().id);
    }
    BodyId body() const {
        return bench_.document().bodyOf(bench_.document().scene().bodies.back().id);
    }
    Workbench bench_;
};

TEST_F(Parts, AClickTakesTheBodyAndASecondOneAPartOfIt) {
    click(bench_, {0.5, 2});
    EXPECT_EQ(bench_.selection(), std::vector{body()});
    EXPECT_FALSE(bench_.fitting());
    click(bench_, {0.5, 2}, 2);
    ASSERT_TRUE(bench_.fitting());
    EXPECT_EQ(bench_.fitting()->kind, FittingRef::Kind::joint);
    EXPECT_TRUE(bench_.selection().empty());
    EXPECT_EQ(kindName(bench_.document().fitting(*bench_.fitting())), "Joint");
    takePart(bench_, {1, 2});
    ASSERT_TRUE(bench_.fitting());
    EXPECT_EQ(bench_.fitting()->kind, FittingRef::Kind::particle);
    EXPECT_EQ(bench_.document().placesOf(*bench_.fitting()).at(0), Point(1, 2));
    click(bench_, {3, 3});
    EXPECT_FALSE(bench_.fitting());
}

TEST_F(Parts, AJointHasNumbersOfItsOwn) {
    takePart(bench_, {0.5, 2});
    EXPECT_TRUE(std::isinf(valueOf(bench_, "joint-stiffness"))) << "rigid";
    setValue(bench_, "joint-stiffness", 250);
    setValue(bench_, "joint-damping", 3);
    setValue(bench_, "strength", 80);
    setValue(bench_, "joint-radius", 0.03);
    int changed = 0;
    for (const auto& joint : plan().joints) changed += joint.stiffness == 250 ? 1 : 0;
    EXPECT_EQ(changed, 1) << "the other one stays";
    EXPECT_EQ(valueOf(bench_, "joint-damping"), 3);
    EXPECT_EQ(valueOf(bench_, "strength"), 80);
    const auto& world = bench_.document().world();
    int live = 0;
    for (const auto joint : world.joints(body())) live += world.info(joint).stiffness == 250;
    EXPECT_EQ(live, 1);
    const std::string before = bench_.document().text();
    for (int i = 0; i < 4; ++i) bench_.document().undo();
    EXPECT_TRUE(std::isinf(valueOf(bench_, "joint-stiffness")));
    for (int i = 0; i < 4; ++i) bench_.document().redo();
    EXPECT_EQ(bench_.document().text(), before);
}

TEST_F(Parts, AParticleIsMovedByTheMouseAndByNumber) {
    takePart(bench_, {1, 2});
    drag(bench_, {1, 2}, {1.5, 2.5});
    const auto places = bench_.document().placesOf(*bench_.fitting());
    EXPECT_NEAR((places.at(0) - Point(1.5, 2.5)).norm(), 0, 1e-6);
    setValue(bench_, "particle-mass", 4);
    setValue(bench_, "particle-pinned", 1);
    setValue(bench_, "particle-x", valueOf(bench_, "particle-x") - 0.25);
    EXPECT_NEAR(bench_.document().placesOf(*bench_.fitting()).at(0).x(), 1.25, 1e-6);
    const auto& world = bench_.document().world();
    const auto last = world.particles(body()).back();
    EXPECT_EQ(world.info(last).mass, 4);
    EXPECT_TRUE(world.info(last).pinned);
    for (int i = 0; i < 500; ++i) bench_.tick();
    EXPECT_EQ(world.validate(), "");
    EXPECT_NEAR(world.position(world.particles(body()).back()).x(), 1.25, 1e-4) << "it is pinned";
    EXPECT_THROW(drag(bench_, {1.25, 2.5}, {1, 2}), std::runtime_error) << "time has run";
}

TEST_F(Parts, DeletingTakesOneAndWhatHoldsOnToIt) {
    takePart(bench_, {0.5, 2});
    bench_.deleteSelection();
    EXPECT_EQ(plan().joints.size(), 1u);
    EXPECT_EQ(plan().particles.size(), 3u);
    bench_.document().undo();
    takePart(bench_, {0, 2});
    bench_.deleteSelection();
    EXPECT_EQ(plan().particles.size(), 2u);
    EXPECT_TRUE(plan().joints.empty());
    EXPECT_FALSE(bench_.fitting());
    bench_.document().undo();
    takePart(bench_, {-1, 2});
    bench_.deleteSelection();
    ASSERT_EQ(plan().joints.size(), 1u);
    EXPECT_EQ(plan().joints[0].a + plan().joints[0].b, 1u) << "places have moved up";
    EXPECT_EQ(bench_.document().world().validate(), "");
}

TEST_F(Parts, WhatHasBecomeAnotherPartIsChosenNoMore) {
    takePart(bench_, {-0.5, 2});
    ASSERT_TRUE(bench_.fitting());
    auto& document = bench_.document();
    document.edit("Erase", [&] { document.remove(document.world().joints(body())[0]); });
    EXPECT_EQ(plan().joints.size(), 1u);
    EXPECT_FALSE(bench_.fitting()) << "another joint has its place";
    bench_.undo();
    EXPECT_EQ(plan().joints.size(), 2u);
}

/// A click on the free part of what joins two bodies chooses it.
TEST(PartsBetween, AJointOfTwoBodiesHasNumbersAndGoesAlone) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    drag(bench, {-2, 2}, {-1, 3});
    drag(bench, {1, 2}, {2, 3});
    auto& document = bench.document();
    bench.setTool(ToolKind::joint);
    drag(bench, {-1.02, 2.02}, {1.02, 2.02}, true);
    ASSERT_EQ(document.scene().connections.size(), 1u);
    bench.setTool(ToolKind::select);
    click(bench, {0, 2.02});
    ASSERT_TRUE(bench.fitting());
    EXPECT_EQ(bench.fitting()->kind, FittingRef::Kind::connection);
    EXPECT_EQ(valueOf(bench, "joint-stiffness"), 600);
    setValue(bench, "joint-stiffness", 900);
    const auto& world = document.world();
    ASSERT_EQ(world.connections().size(), 1u);
    EXPECT_EQ(world.info(world.connections()[0]).stiffness, 900);
    document.undo();
    EXPECT_EQ(valueOf(bench, "joint-stiffness"), 600);
    bench.deleteSelection();
    EXPECT_TRUE(document.scene().connections.empty());
    EXPECT_EQ(document.scene().bodies.size(), 3u);
}

}  // namespace
}  // namespace sulfurchamber
