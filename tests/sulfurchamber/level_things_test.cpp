// Editing what a level file holds beside its scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "model/level_hand.hpp"
#include "model/level_pieces.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

std::filesystem::path levelFile(const std::string& name) {
    return std::filesystem::path(QUAOAR_LEVELS) / (name + ".json");
}

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
}

std::vector<std::filesystem::path> allLevels() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(QUAOAR_LEVELS))
        if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

LevelThing only(const Document& document, LevelKind kind, std::size_t index = 0) {
    for (const LevelThing& thing : levelThings(document))
        if (thing.kind == kind && thing.index == index) return thing;
    ADD_FAILURE() << "no such thing";
    return {};
}

Pointer at(const Point& place, double reach = 0.1) {
    return {.position = place, .reach = reach};
}

void drag(Workbench& bench, const Point& from, const Point& to) {
    bench.press(at(from));
    bench.move(at((from + to) / 2));
    bench.move(at(to));
    bench.release(at(to));
}

// Each level of the game: all that it holds is seen, and each of it can be moved and put back.
TEST(LevelThings, AllLevelsAreSeenAndKeepTheirBytes) {
    const auto files = allLevels();
    ASSERT_EQ(files.size(), 26u);
    std::set<LevelKind> seen;
    for (const auto& file : files) {
        Document document;
        document.open(file);
        const std::string before = document.text();
        EXPECT_EQ(before, bytesOf(file)) << file;
        const auto things = levelThings(document);
        document.edit("set all to what they are", [&] {
            for (const LevelThing& thing : things) {
                seen.insert(thing.kind);
                EXPECT_TRUE(contains(document, thing));
                EXPECT_FALSE(titleOf(document, thing).empty());
                for (const LevelField& field : levelFields()) {
                    if (field.kind != thing.kind) continue;
                    const auto text = fieldText(document, thing, field);
                    if (text && !text->empty()) setField(document, thing, field, *text);
                }
            }
        });
        for (const double way : {0.25, -0.25})
            document.edit("move all", [&] {
                for (const LevelThing& thing : things) moveThing(document, thing, {way, way});
            });
        while (document.canUndo()) document.undo();
        EXPECT_EQ(document.text(), before) << file;
    }
    EXPECT_EQ(seen.size(), levelKinds().size());
}

TEST(LevelThings, MovingOneTouchesItsNumbersOnly) {
    Document document;
    document.open(levelFile("09-frost-slug"));
    const std::string before = document.text();
    document.edit("Move", [&] { moveThing(document, only(document, LevelKind::hint, 1), {1, 0}); });
    std::string wanted = before;
    wanted.replace(wanted.find("[10.2, 1.35]"), 12, "[11.2, 1.35]");
    EXPECT_EQ(document.text(), wanted);
}

TEST(LevelThings, ABodyThatMovesTouchesItsPlaceOnly) {
    Document document;
    document.open(levelFile("01-cold-wake"));
    const std::string before = bytesOf(levelFile("01-cold-wake"));
    document.edit("Move", [&] {
        const sulfur::BodyId bolt = document.bodyOf("bolt-2");
        document.translate({&bolt, 1}, {1, 0});
    });
    std::string wanted = before;
    wanted.replace(wanted.find("[12.7, 2.78]"), 12, "[13.7, 2.78]");
    EXPECT_EQ(document.text(), wanted);
    document.edit("Delete", [&] {
        const sulfur::BodyId bolt = document.bodyOf("bolt-2");
        document.remove({&bolt, 1});
        document.add("box", sulfur::shapes::BoxOptions{}, {.position = {5, 2}, .angle = 0});
    });
    EXPECT_NE(document.text().find("\"id\": \"box\""), std::string::npos);
    document.undo();
    document.undo();
    EXPECT_EQ(document.text(), before);
}

TEST(LevelThings, FieldsRefuseWithWhatIsAllowed) {
    Document document;
    document.open(levelFile("09-frost-slug"));
    const std::string before = document.text();
    const LevelThing exit = only(document, LevelKind::exit);
    const auto refusal = [&](const LevelThing& thing, const char* path, const char* text) {
        try {
            document.edit("x",
                          [&] { setField(document, thing, *levelField(thing.kind, path), text); });
        } catch (const std::exception& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal(exit, "radius", "11"), "Exit, Radius: allowed is a number from 0.1 to 10 m");
    EXPECT_EQ(refusal(exit, "radius", "wide"),
              "Exit, Radius: allowed is a number from 0.1 to 10 m");
    EXPECT_EQ(refusal(only(document, LevelKind::rules), "number", "1.5"),
              "Level, Number: allowed is a whole number from 1 to 999");
    EXPECT_EQ(refusal(only(document, LevelKind::trigger), "mode", "maybe"),
              "Switch, Mode: allowed is one of: hold, toggle, once");
    EXPECT_EQ(refusal(only(document, LevelKind::mover), "path", "3"),
              "Mover, Way: allowed is places such as 3 4, 5 6 in metres");
    EXPECT_EQ(refusal(only(document, LevelKind::theme), "ice", "blue"),
              "Theme, Ground: allowed is a colour such as #1F3A5F");
    EXPECT_EQ(document.text(), before);
    EXPECT_FALSE(document.canUndo());
}

TEST(LevelThings, PartsComeAndGoWithTheirFields) {
    Document document;
    document.adopt(newLevel());
    LevelThing zone;
    document.edit("zone", [&] {
        zone = placePiece(document, LevelPiece::wind, {1, 1}, {3, 2}, {});
    });
    const LevelField& drag = *levelField(LevelKind::zone, "wind.drag");
    const LevelField& on = *levelField(LevelKind::zone, "pulse.on");
    EXPECT_EQ(fieldText(document, zone, drag), "4");
    EXPECT_FALSE(fieldText(document, zone, on));
    document.edit("pulse", [&] {
        setField(document, zone, *levelField(LevelKind::zone, "pulse"), "yes");
        setField(document, zone, *levelField(LevelKind::zone, "wind"), "no");
    });
    EXPECT_EQ(fieldText(document, zone, on), "1.5");
    EXPECT_FALSE(fieldText(document, zone, drag));
}

TEST(LevelThings, AListThatIsEmptyGoes) {
    Document document;
    document.open(levelFile("09-frost-slug"));
    document.edit("x", [&] { removeThings(document, {only(document, LevelKind::trigger)}); });
    EXPECT_EQ(document.levelText().find("switches"), std::string::npos);
    document.undo();
    document.edit("x", [&] {
        removeThings(document,
                     {only(document, LevelKind::hint, 0), only(document, LevelKind::hint, 2)});
    });
    EXPECT_EQ(titleOf(document, only(document, LevelKind::hint)),
              "Hint \xE2\x80\x9CHook it, reel, let go in tim\xE2\x80\xA6\xE2\x80\x9D");
}

TEST(LevelThings, WhatIsSaidOfABodyFollowsItsNameAndGoesWithIt) {
    Document document;
    document.open(levelFile("09-frost-slug"));
    document.edit("Rename", [&] { document.rename(document.bodyOf("slug-1"), "snail"); });
    EXPECT_EQ(bodyOf(document, only(document, LevelKind::monster)), "snail");
    EXPECT_TRUE(contains(document, {LevelKind::surface, 0, "snail"}));
    const sulfur::BodyId body = document.bodyOf("snail");
    document.edit("Delete", [&] { document.remove({&body, 1}); });
    EXPECT_NE(bodyOf(document, only(document, LevelKind::monster)), "snail");
    EXPECT_FALSE(contains(document, {LevelKind::surface, 0, "snail"}));
    document.undo();
    EXPECT_TRUE(contains(document, {LevelKind::surface, 0, "snail"}));
}

// --- by the mouse ----------------------------------------------------------------------------

TEST(LevelHand, SelectsMovesAndResizes) {
    Workbench bench;
    Document& document = bench.document();
    document.adopt(newLevel());
    const std::string before = document.text();
    drag(bench, {11, 0.6}, {10, 0.8});
    const LevelThing exit = only(document, LevelKind::exit);
    EXPECT_EQ(bench.things(), std::vector<LevelThing>{exit});
    EXPECT_NEAR((shapeOf(document, exit).at - Point(10, 0.8)).norm(), 0, 1e-9);
    EXPECT_EQ(document.undoLabel(), "Move Exit");
    drag(bench, {10.6, 0.8}, {10.9, 0.8});
    EXPECT_NEAR(shapeOf(document, exit).radius, 0.9, 1e-9);
    EXPECT_EQ(document.historyPlace(), 2u);
    document.undo();
    document.undo();
    EXPECT_EQ(document.text(), before);
}

TEST(LevelHand, EscapePutsBack) {
    Workbench bench;
    Document& document = bench.document();
    document.adopt(newLevel());
    const std::string before = document.text();
    bench.press(at({1, 0.3}));
    bench.move(at({3, 2}));
    EXPECT_NE(document.levelText(), "");
    bench.cancel();
    EXPECT_EQ(document.text(), before);
    EXPECT_FALSE(document.canUndo());
}

TEST(LevelHand, BordersGiveWayToBodiesAndMarksDoNot) {
    Workbench bench;
    Document& document = bench.document();
    document.adopt(newLevel());
    document.edit("zone", [&] { placePiece(document, LevelPiece::liquid, {0, 0}, {4, 1}, {}); });
    bench.press(at({2.5, 0.05}));  // on the ground's surface, and on the zone's lower border
    bench.release(at({2.5, 0.05}));
    EXPECT_TRUE(bench.things().empty());
    EXPECT_EQ(bench.selection().size(), 1u);
    bench.press(at({2.5, 1}));
    bench.release(at({2.5, 1}));
    ASSERT_EQ(bench.things().size(), 1u);
    EXPECT_EQ(bench.things()[0].kind, LevelKind::zone);
    EXPECT_TRUE(bench.selection().empty());
    drag(bench, {4, 1}, {5, 1.5});
    const Bounds box = shapeOf(document, bench.things()[0]).box;
    EXPECT_EQ(box.high, Point(5, 1.5));
    EXPECT_EQ(box.low, Point(0, 0));
}

TEST(LevelHand, DeletesDuplicatesAndNudges) {
    Workbench bench;
    Document& document = bench.document();
    document.adopt(newLevel());
    bench.selectThings({only(document, LevelKind::hint)});
    bench.duplicate();
    ASSERT_EQ(bench.things().size(), 1u);
    EXPECT_EQ(bench.things()[0].index, 1u);
    EXPECT_EQ(shapeOf(document, bench.things()[0]).at, Point(2.5, 1.9));
    bench.nudge({0, 0.1});
    EXPECT_EQ(shapeOf(document, bench.things()[0]).at, Point(2.5, 2));
    bench.deleteSelection();
    EXPECT_TRUE(bench.things().empty());
    EXPECT_EQ(JsonText(document.levelText()).size({"hints"}), 1u);
    bench.selectThings({only(document, LevelKind::spawn)});
    EXPECT_THROW(bench.deleteSelection(), std::runtime_error);
    document.undo();
    bench.documentChanged();
    EXPECT_EQ(JsonText(document.levelText()).size({"hints"}), 2u);
}

TEST(LevelHand, AMoverIsLedByTheEndsOfItsWay) {
    Workbench bench;
    Document& document = bench.document();
    document.open(levelFile("09-frost-slug"));
    const LevelThing mover = only(document, LevelKind::mover);
    bench.selectThings({mover});
    drag(bench, {23.75, 2.7}, {23.75, 3});
    EXPECT_EQ(shapeOf(document, mover).way.back(), Point(23.75, 3));
    const LevelThing monster = only(document, LevelKind::monster);
    bench.selectThings({monster});
    const Point left = shapeOf(document, monster).handles[0];
    drag(bench, left, {6, left.y()});
    EXPECT_EQ(JsonText(document.levelText()).number(pathOf(pathOf(monster), "between.0")), 6);
}

// --- from the palette ------------------------------------------------------------------------

TEST(LevelPieces, EachIsPlacedInOneStepThatUndoTakesBack) {
    for (const LevelPieceInfo& info : levelPieces()) {
        Workbench bench;
        Document& document = bench.document();
        document.adopt(newLevel());
        document.edit("box", [&] {
            document.add("box", sulfur::shapes::BoxOptions{.size = {0.4f, 0.4f}},
                         {.position = {3, 1}, .angle = 0});
        });
        const std::string before = document.text();
        bench.setPlacing(info.piece);
        EXPECT_FALSE(bench.hint().empty());
        drag(bench, {3, 1}, {4, 1.6});
        EXPECT_EQ(document.historyPlace(), 2u) << info.name;
        EXPECT_NE(document.text(), before) << info.name;
        ASSERT_EQ(bench.things().size(), 1u) << info.name;
        EXPECT_TRUE(contains(document, bench.things()[0])) << info.name;
        document.undo();
        EXPECT_EQ(document.text(), before) << info.name;
    }
}

TEST(LevelPieces, AMoverMakesItsBodyKinematic) {
    Workbench bench;
    Document& document = bench.document();
    document.adopt(newLevel());
    document.edit("box", [&] {
        document.add("box", sulfur::shapes::BoxOptions{.size = {0.4f, 0.4f}},
                     {.position = {3, 1}, .angle = 0});
    });
    bench.setPlacing(LevelPiece::mover);
    drag(bench, {3.1, 1}, {3.1, 2.5});
    EXPECT_EQ(document.plan().blueprint("box").kind, sulfur::BodyKind::kinematic);
    EXPECT_EQ(fieldText(document, bench.things()[0], *levelField(LevelKind::mover, "path")),
              "3 2.5");
    EXPECT_THROW(drag(bench, {3.1, 1}, {3.1, 2.5}), std::runtime_error);
    EXPECT_THROW(drag(bench, {8, 1.5}, {8, 2}), std::runtime_error);
    EXPECT_EQ(document.historyPlace(), 2u);
}

TEST(LevelPieces, GroundIsDrawnCornerByCorner) {
    Workbench bench;
    Document& document = bench.document();
    document.adopt(newLevel());
    bench.setPlacing(LevelPiece::ground);
    for (const Point& corner : {Point(2, 1), Point(2, 2), Point(3, 2)}) {
        bench.press(at(corner));
        bench.release(at(corner));
    }
    bench.finish();
    ASSERT_EQ(document.scene().bodies.size(), 3u);
    EXPECT_EQ(bench.things(), (std::vector<LevelThing>{{LevelKind::surface, 0, "ground2"}}));
    const auto blueprint = document.plan().blueprint("ground2");
    EXPECT_EQ(blueprint.kind, sulfur::BodyKind::fixed);
    EXPECT_EQ(blueprint.joints.size(), 3u);
}

TEST(LevelPieces, ASceneBecomesALevel) {
    Document document;
    EXPECT_FALSE(isLevel(document));
    EXPECT_THROW(placePiece(document, LevelPiece::hint, {0, 0}, {0, 0}, {}), std::runtime_error);
    document.edit("Make a level", [&] { makeLevel(document); });
    EXPECT_TRUE(isLevel(document));
    EXPECT_EQ(document.scene().settings.tickRate, 500);
    EXPECT_EQ(levelThings(document).size(), 7u);
}

}  // namespace
}  // namespace sulfurchamber
