// Skins: what can wear a picture, where it lies, and where its file is.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <atlax/files.hpp>
#include <atlax/image.hpp>
#include <cmath>
#include <filesystem>
#include <string>

#include "model/skins.hpp"
#include "model/tool.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::scene::makePrefab;

TEST(Skins, LieOnSolidsSoftBodiesAndDiscsAlone) {
    EXPECT_TRUE(canWear(makePrefab("box", sulfur::shapes::BoxOptions{})));
    EXPECT_TRUE(canWear(makePrefab("jelly", sulfur::shapes::JellyOptions{})));
    EXPECT_TRUE(canWear(makePrefab("ball", sulfur::shapes::BallOptions{})));
    EXPECT_TRUE(canWear(
        makePrefab("polygon", sulfur::shapes::PolygonOptions{.points = {{0, 0}, {2, 0}, {1, 1}}})));
    EXPECT_FALSE(canWear(makePrefab("rope", sulfur::shapes::RopeOptions{})));
    auto rope = makePrefab("rope", sulfur::shapes::RopeOptions{});
    EXPECT_THROW(wear(rope, "a.png"), std::runtime_error);
    auto box = makePrefab("box", sulfur::shapes::BoxOptions{});
    EXPECT_THROW(wear(box, "../a.png"), std::runtime_error);
    EXPECT_EQ(skinOf(box), "");
    wear(box, "a.png");
    EXPECT_EQ(skinOf(box), "a.png");
    undress(box);
    EXPECT_EQ(skinOf(box), "");
}

TEST(Skins, ANewOneCoversTheBodyAndMappingsAreReadBack) {
    auto box = makePrefab("box", sulfur::shapes::BoxOptions{.size = {2, 1}, .radius = 0.02f});
    wear(box, "a.png");
    auto mapping = mappingOf(box);
    ASSERT_TRUE(mapping);
    EXPECT_NEAR(mapping->size.x(), 1.96, 1e-4);
    EXPECT_NEAR(mapping->size.y(), 0.96, 1e-4);
    EXPECT_NEAR(mapping->centre.norm(), 0, 1e-4);
    EXPECT_NEAR(mapping->angle, 0, 1e-5);
    for (const double angle : {0.0, 0.7, -2.5})
        for (const double height : {0.8, -0.8}) {
            const SkinMapping wanted{{0.3, -0.2}, {1.5, height}, angle};
            setMapping(box, wanted);
            EXPECT_FALSE(box.skinFitted);
            const auto now = mappingOf(box);
            ASSERT_TRUE(now);
            EXPECT_NEAR((now->centre - wanted.centre).norm(), 0, 1e-4);
            EXPECT_NEAR((now->size - wanted.size).norm(), 0, 1e-4);
            EXPECT_NEAR(std::remainder(now->angle - wanted.angle, 2 * 3.14159265), 0, 1e-4);
        }
    EXPECT_THROW(setMapping(box, {{0, 0}, {0.001, 1}, 0}), std::runtime_error);
    EXPECT_NEAR(mappingOf(box)->size.x(), 1.5, 1e-4);
}

TEST(Skins, AreOfferedWhereTheyCanBeWorn) {
    Document document;
    BodyId rope, box;
    document.edit("Build", [&] {
        rope = document.add("rope", sulfur::shapes::RopeOptions{}, {.position = {0, 2}});
        box = document.add("box", sulfur::shapes::BoxOptions{}, {.position = {3, 2}});
    });
    EXPECT_FALSE(canWear(document, rope));
    EXPECT_TRUE(canWear(document, box));
    EXPECT_THROW(wearAll(document, {&rope, 1}, "a.png"), std::runtime_error);
    const std::array both{rope, box};
    wearAll(document, both, "a.png");
    EXPECT_EQ(skinOf(document.plan().dressed("box")), "a.png");
    EXPECT_EQ(skinOf(document.plan().dressed("rope")), "");
}

TEST(Skins, AreOneUndoableStepAndStandInTheFile) {
    Document document;
    BodyId body;
    document.edit("Build", [&] {
        body = document.add("jelly", sulfur::shapes::JellyOptions{}, {.position = {0, 2}});
    });
    const std::string before = document.text();
    document.edit("Wear", [&] { wearAll(document, {&body, 1}, "skins/a.png"); });
    EXPECT_NE(document.text().find("\"skin\": {\"texture\": \"skins/a.png\"}"), std::string::npos);
    ASSERT_TRUE(document.world().skin(document.bodyOf("jelly")));
    const BodyId dressed = document.bodyOf("jelly");
    document.edit("Place", [&] {
        document.change({&dressed, 1}, [](auto& prefab) {
            setMapping(prefab, {{0.1, 0}, {2, 2}, 0.5});
        });
    });
    Document other;
    other.adopt(sulfur::scene::parse(document.text(), "test"));
    EXPECT_EQ(other.text(), document.text());
    EXPECT_NEAR(mappingOf(other.plan().dressed("jelly"))->angle, 0.5, 1e-4);
    document.undo();
    document.undo();
    EXPECT_EQ(document.text(), before);
    const BodyId floor = document.bodyOf("floor");
    EXPECT_THROW(document.edit("Wear",
                               [&] {
                                   wearAll(document, {&floor, 1}, "a.png");
                               }),
                 std::runtime_error);
}

TEST(Skins, HandlesMoveScaleAndTurnThePicture) {
    Workbench bench;
    Document& document = bench.document();
    document.edit("Build", [&] {
        auto prefab = makePrefab("box", sulfur::shapes::BoxOptions{.size = {2, 2}});
        wear(prefab, "a.png");
        setMapping(prefab, {{0, 0}, {1, 1}, 0});
        sulfur::scene::Placement placement;
        placement.pose.position = Point(3, 4);
        document.add(prefab, placement);
    });
    const auto mapping = [&] { return *mappingOf(document.plan().dressed("box")); };
    const auto drag = [&](const Point& from, const Point& to, bool shift = false) {
        bench.press({.position = from, .reach = 0.05, .shift = shift});
        bench.move({.position = (from + to) / 2, .reach = 0.05, .shift = shift});
        bench.release({.position = to, .reach = 0.05, .shift = shift});
    };
    bench.take(makeSkinTool(bench, document.bodyOf("box")));
    EXPECT_EQ(bench.preview().kind, Preview::Kind::skin);
    drag({3, 4}, {3.2, 4.1});
    EXPECT_NEAR((mapping().centre - Point(0.2, 0.1)).norm(), 0, 1e-4);
    drag({3.7, 4.6}, {3.95, 4.6});  // its upper right corner
    EXPECT_NEAR(mapping().size.x(), 1.5, 1e-3);
    EXPECT_NEAR(mapping().size.y(), 1, 1e-3);
    const Point knob = bench.preview().to;
    const Point middle(3.2, 4.1);
    drag(knob, middle + Point((knob - middle).norm(), 0));
    EXPECT_NEAR(mapping().angle, -3.14159265 / 2, 1e-3);
    EXPECT_EQ(document.historyPlace(), 4u);
    // Beside the picture the tool ends.
    drag({9, 9}, {9, 9});
    EXPECT_EQ(bench.preview().kind, Preview::Kind::none);
    document.undo();
    EXPECT_NEAR(mapping().angle, 0, 1e-4);
}

class SkinFiles : public testing::Test {
protected:
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() /
                 ("sulfur-skin-test-" + std::to_string(getpid()));
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder / "scene" / "art");
        atlax::Image red({4, 4}), blue({8, 8});
        atlax::savePng(red, folder / "cat.png");
        atlax::savePng(blue, folder / "scene" / "art" / "cat.png");
    }
    void TearDown() override { std::filesystem::remove_all(folder); }
    std::filesystem::path folder;
};

TEST_F(SkinFiles, StayRelativeToTheSceneOrAreCopied) {
    const SkinStore store(folder / "own", {SULFURCHAMBER_TEMPLATES});
    EXPECT_EQ(store.adopt(folder / "scene" / "art" / "cat.png", folder / "scene"), "art/cat.png");
    const std::string name = store.adopt(folder / "cat.png", folder / "scene");
    EXPECT_EQ(name, "skins/cat.png");
    EXPECT_EQ(store.adopt(folder / "cat.png", {}), name) << "the same picture is kept once";
    EXPECT_EQ(store.adopt(folder / "scene" / "art" / "cat.png", {}), "skins/cat-2.png");
    EXPECT_EQ(store.find(name, {}), folder / "own" / name);
    EXPECT_FALSE(store.find("skins/pip.svg", {}).empty());
    EXPECT_TRUE(store.find("no.png", {}).empty());

    Document document;
    document.edit("Build", [&] {
        auto prefab = makePrefab("box", sulfur::shapes::BoxOptions{});
        wear(prefab, name);
        document.add(prefab, {});
    });
    EXPECT_TRUE(store.copyBeside(document.scene(), folder / "scene").empty());
    EXPECT_EQ(store.find(name, folder / "scene"), folder / "scene" / name);
}

TEST_F(SkinFiles, WhatIsNoPictureIsRefused) {
    const SkinStore store(folder / "own", {});
    EXPECT_THROW(store.adopt(folder / "none.png", {}), std::runtime_error);
    EXPECT_THROW(store.adopt(folder / "cat.txt", {}), std::runtime_error);
    atlax::writeFileAtomic(folder / "bad.png", std::string_view("no picture"));
    EXPECT_THROW(store.adopt(folder / "bad.png", {}), std::runtime_error);
    EXPECT_FALSE(std::filesystem::exists(folder / "own"));
}

}  // namespace
}  // namespace sulfurchamber
