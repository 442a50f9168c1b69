#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "model/document.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::Real;

sulfur::BodyId addBox(Document& document, Point at) {
    document.edit("Add box",
                  [&] { document.add("box", sulfur::shapes::BoxOptions{}, {.position = at}); });
    return document.world().bodies().back();
}

std::filesystem::path scratch(const std::string& name) {
    return std::filesystem::path(testing::TempDir()) / ("sulfurchamber_" + name);
}

TEST(Document, BeginsWithAnUnmodifiedFloor) {
    const Document document;
    EXPECT_EQ(document.world().bodies().size(), 1u);
    EXPECT_FALSE(document.modified());
    EXPECT_FALSE(document.canUndo());
    EXPECT_FALSE(document.canReset());
    EXPECT_EQ(document.name(), "Untitled");
}

TEST(Document, UndoAndRedoRestoreTheStateToTheBit) {
    Document document;
    const auto before = document.world().hash();
    addBox(document, {0, 3});
    const auto after = document.world().hash();
    EXPECT_NE(before, after);
    EXPECT_TRUE(document.modified());
    document.undo();
    EXPECT_EQ(document.world().hash(), before);
    EXPECT_FALSE(document.modified());
    document.redo();
    EXPECT_EQ(document.world().hash(), after);
    EXPECT_TRUE(document.modified());
}

TEST(Document, UndoGoesBackBehindTimeThatHasPassed) {
    Document document;
    const auto before = document.world().hash();
    addBox(document, {0, 3});
    for (int i = 0; i < 50; ++i) document.tick();
    document.undo();
    EXPECT_EQ(document.world().hash(), before);
}

TEST(Document, ResetReturnsToTheStateBeforePlayAndCanBeUndone) {
    Document document;
    const auto box = addBox(document, {0, 3});
    const auto before = document.world().hash();
    document.play();
    for (int i = 0; i < 100; ++i) document.tick();
    const auto played = document.world().hash();
    EXPECT_LT(document.world().centreOfMass(box).y(), 2.95);
    ASSERT_TRUE(document.canReset());
    document.reset();
    EXPECT_EQ(document.world().hash(), before);
    EXPECT_FALSE(document.playing());
    EXPECT_FALSE(document.canReset());
    document.undo();
    EXPECT_EQ(document.world().hash(), played);
    EXPECT_TRUE(document.canReset());
}

TEST(Document, AFailedEditLeavesNothingBehind) {
    Document document;
    const auto before = document.world().hash();
    const std::string text = document.text();
    EXPECT_THROW(document.edit("Fail",
                               [&] {
                                   document.add("box", sulfur::shapes::BoxOptions{}, {});
                                   throw std::runtime_error("on purpose");
                               }),
                 std::runtime_error);
    EXPECT_EQ(document.text(), text);
    EXPECT_EQ(document.world().hash(), before);
    EXPECT_FALSE(document.canUndo());
    EXPECT_FALSE(document.modified());
}

TEST(Document, ElasticityScalesElasticJointsAndGivesBackEveryBit) {
    Document document;
    document.edit("Add", [&] {
        document.add("jelly", sulfur::shapes::JellyOptions{.stiffness = Real(333.3)},
                     {.position = {0, 2}});
    });
    const auto jelly = document.world().bodies().back();
    const auto box = addBox(document, {3, 2});
    const auto joint = document.world().joints(jelly)[0];
    const Real before = document.world().info(joint).stiffness;
    Constants constants = document.constants();
    for (const double factor : {0.1, 7.3, 2.0}) {
        constants.elasticity = factor;
        document.setConstants(constants);
        EXPECT_NEAR(document.world().info(joint).stiffness / before, factor, 1e-5 * factor);
    }
    EXPECT_FALSE(std::isfinite(document.world().info(document.world().joints(box)[0]).stiffness));
    constants.elasticity = 1;
    document.setConstants(constants);
    EXPECT_EQ(document.world().info(joint).stiffness, before);
}

TEST(Document, FrictionComesBackFromZero) {
    Document document;
    const auto box = addBox(document, {0, 1});
    const auto before = document.world().material(box);
    Constants constants = document.constants();
    constants.friction = 0;
    document.setConstants(constants);
    EXPECT_EQ(document.world().material(box).kineticFriction, 0);
    constants.friction = 1;
    document.setConstants(constants);
    EXPECT_EQ(document.world().material(box), before);
}

TEST(Document, ConstantsAreClampedAndUndoneTogether) {
    Document document;
    Constants constants = document.constants();
    constants.gravity = 1e9;
    constants.airFriction = -5;
    document.setConstants(constants);
    EXPECT_EQ(document.constants().gravity, ConstantLimits::gravity);
    EXPECT_EQ(document.constants().airFriction, 0);
    EXPECT_NEAR(static_cast<double>(document.world().gravity().y()), -ConstantLimits::gravity,
                1e-6);
    document.undo();
    EXPECT_NEAR(document.constants().gravity, 9.81, 1e-6);
    EXPECT_NEAR(static_cast<double>(document.world().gravity().y()), -9.81, 1e-6);
}

TEST(Document, WhatIsSavedIsThePlanAndNotTheMoment) {
    Document document;
    addBox(document, {0, 3});
    document.edit("Add rope", [&] {
        document.add("rope", sulfur::shapes::RopeOptions{.pinFirst = true}, {.position = {2, 4}});
    });
    const auto file = scratch("plan.json");
    document.save(file);
    const std::string before = document.text();
    for (int i = 0; i < 137; ++i) document.tick();
    EXPECT_FALSE(document.modified()) << "playing is no edit";
    document.save(file);
    EXPECT_EQ(document.file(), file);
    Document again;
    again.open(file);
    EXPECT_EQ(again.text(), before);
    EXPECT_EQ(again.scene().prefab("rope")->generator.index(),
              sulfur::scene::Generator(sulfur::shapes::RopeOptions{}).index())
        << "recipes stay recipes";
    std::filesystem::remove(file);
}

TEST(Document, AMomentIsSavedAsASceneOfItsOwn) {
    Document document;
    const auto box = addBox(document, {0, 3});
    for (int i = 0; i < 137; ++i) document.tick();
    const auto file = scratch("moment.json");
    document.saveMoment(file);
    EXPECT_TRUE(document.file().empty()) << "what is open stays what it is";
    EXPECT_TRUE(document.modified());
    Document again;
    again.open(file);
    const auto then = again.world().bodies().back();
    EXPECT_EQ(again.world().centreOfMass(then), document.world().centreOfMass(box));
    EXPECT_LT(again.world().centreOfMass(then).y(), 2.9);
    std::filesystem::remove(file);
}

TEST(Document, TheWorldThatPlaysIsTheOneThatIsSaved) {
    Document document;
    addBox(document, {0, 1});
    addBox(document, {0.3, 2.2});
    document.edit("Remove", [&] { document.remove({&document.world().bodies()[1], 1}); });
    addBox(document, {0.1, 1});
    const auto file = scratch("played.json");
    document.save(file);
    Document again;
    again.open(file);
    for (int i = 0; i < 600; ++i) {
        document.tick();
        again.tick();
    }
    EXPECT_EQ(again.world().hash(), document.world().hash());
    std::filesystem::remove(file);
}

TEST(Document, ABrokenFileChangesNothing) {
    Document document;
    addBox(document, {0, 3});
    const auto before = document.world().hash();
    const auto file = scratch("broken.json");
    std::ofstream(file) << "{\"format\": \"sulfur-scene\", \"version\": 1, \"bodies\": [NaN]}";
    EXPECT_THROW(document.open(file), sulfur::scene::ReadError);
    EXPECT_THROW(document.open(scratch("missing.json")), sulfur::scene::ReadError);
    EXPECT_EQ(document.world().hash(), before);
    EXPECT_TRUE(document.modified());
    EXPECT_TRUE(document.canUndo());
    EXPECT_TRUE(document.file().empty());
    std::filesystem::remove(file);
}

TEST(Document, SavingWhereNothingCanBeWrittenSaysSo) {
    Document document;
    addBox(document, {0, 3});
    EXPECT_THROW(document.save("/dev/null/scene.json"), std::runtime_error);
    EXPECT_TRUE(document.modified());
    EXPECT_TRUE(document.file().empty());
}

}  // namespace
}  // namespace sulfurchamber
