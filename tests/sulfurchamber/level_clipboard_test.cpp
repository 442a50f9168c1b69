// Things of a level are copied, cut, pasted and duplicated as bodies are.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "model/level_clipboard.hpp"
#include "model/level_pieces.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

std::vector<LevelThing> thingsOfKind(const Document& document, LevelKind kind) {
    std::vector<LevelThing> found;
    for (const LevelThing& thing : levelThings(document))
        if (thing.kind == kind) found.push_back(thing);
    return found;
}

std::string jsonOfThing(const Document& document, const LevelThing& thing) {
    return JsonText(document.levelText()).get(pathOf(thing)).value_or("");
}

// Whether what was done is one step that undo takes back and redo does again,
// to the byte.
void expectOneStep(Workbench& bench, const std::string& before) {
    const std::string after = bench.document().text();
    EXPECT_NE(after, before);
    bench.document().undo();
    bench.documentChanged();
    EXPECT_EQ(bench.document().text(), before);
    bench.document().redo();
    bench.documentChanged();
    EXPECT_EQ(bench.document().text(), after);
}

// A zone, a switch and a text.
void furnish(Workbench& bench) {
    bench.document().adopt(newLevel());
    bench.document().edit("x", [&] {
        addThing(bench.document(), LevelKind::zone,
                 R"({"id": "lake", "min": [1, 0], "max": [3, 1], "liquid": {"density": 900}})");
        addThing(bench.document(), LevelKind::trigger,
                 R"({"id": "plate", "position": [4, 0.5], "size": [1, 0.25], "signal": "on"})");
    });
}

TEST(LevelClipboard, ThingsGoToAnotherLevel) {
    Workbench from, to;
    furnish(from);
    to.document().adopt(newLevel());
    auto chosen = thingsOfKind(from.document(), LevelKind::zone);
    chosen.push_back(thingsOfKind(from.document(), LevelKind::trigger).front());
    from.selectThings(chosen);
    ASSERT_TRUE(from.canCopy());
    const std::string text = from.copy();
    const std::string before = to.document().text();
    to.paste(text, {10, 2});
    ASSERT_EQ(to.things().size(), 2u);
    EXPECT_TRUE(to.selection().empty());
    const LevelShape lake = shapeOf(to.document(), to.things()[0]);
    EXPECT_EQ(lake.label, "lake");
    EXPECT_EQ(lake.box.low, Point(11, 2));
    EXPECT_EQ(lake.box.high, Point(13, 3));
    const LevelShape plate = shapeOf(to.document(), to.things()[1]);
    EXPECT_EQ(plate.box.centre(), Point(14, 2.5));
    EXPECT_EQ(plate.box.size(), Point(1, 0.25));
    EXPECT_EQ(
        JsonText(to.document().levelText()).number({"zones", std::size_t{0}, "liquid", "density"}),
        900);
    EXPECT_EQ(to.document().undoLabel(), "Paste");
    expectOneStep(to, before);
    // There once more: the ids are taken.
    to.paste(text, {0, 0});
    EXPECT_EQ(shapeOf(to.document(), to.things()[0]).label, "lake-1");
    EXPECT_EQ(shapeOf(to.document(), to.things()[1]).label, "plate-1");
}

TEST(LevelClipboard, TheMiddleComesToTheMouse) {
    Workbench bench;
    furnish(bench);
    bench.selectThings(thingsOfKind(bench.document(), LevelKind::zone));
    bench.pasteAt(bench.copy(), {-5, 4});
    EXPECT_EQ(shapeOf(bench.document(), bench.things().at(0)).box.centre(), Point(-5, 4));
}

TEST(LevelClipboard, WhatIsSaidOfABodyComesWithIt) {
    Workbench bench;
    Document& document = bench.document();
    document.adopt(newLevel());
    bench.setPlacing(LevelPiece::monster);
    bench.press({.position = {3, 1}});
    bench.release({.position = {3, 1}});
    bench.setTool(ToolKind::select);
    const auto slug = thingsOfKind(document, LevelKind::monster);
    ASSERT_EQ(slug.size(), 1u);
    const std::string before = document.text(), body = bodyOf(document, slug[0]);
    // Chosen is what is said of it, or the body itself.
    for (const bool byThing : {true, false}) {
        if (byThing)
            bench.selectThings(slug);
        else
            bench.select({document.bodyOf(body)});
        bench.duplicate();
        EXPECT_EQ(document.undoLabel(), "Duplicate");
        const auto both = thingsOfKind(document, LevelKind::monster);
        ASSERT_EQ(both.size(), 2u);
        const std::string other = bodyOf(document, both[1]);
        EXPECT_NE(other, body);
        ASSERT_TRUE(document.bodyOf(other));
        EXPECT_EQ(bench.selection(), (std::vector{document.bodyOf(other)}));
        const Point shift =
            document.plan().body(other).pose.position - document.plan().body(body).pose.position;
        EXPECT_NEAR((shift - Point(0.5, 0.5)).norm(), 0, 1e-9);
        const JsonText level(document.levelText());
        const double left =
            level.number({"monsters", std::size_t{0}, "between", std::size_t{0}}).value();
        EXPECT_NEAR(level.number({"monsters", std::size_t{1}, "between", std::size_t{0}}).value(),
                    left + 0.5, 1e-3);
        EXPECT_EQ(level.boolean({"surfaces", other, "deadly"}), true);
        expectOneStep(bench, before);
        document.undo();
        bench.documentChanged();
    }
}

TEST(LevelClipboard, AWayMovesWithItsBody) {
    Workbench bench;
    Document& document = bench.document();
    document.adopt(newLevel());
    sulfur::BodyId lift;
    document.edit("x", [&] {
        lift = document.add("lift", sulfur::shapes::BoxOptions{}, {.position = {2, 1}});
        placePiece(document, LevelPiece::mover, {2, 1}, {2, 4}, lift);
    });
    bench.select({lift});
    bench.paste(bench.copy(), {6, 1});
    const auto movers = thingsOfKind(document, LevelKind::mover);
    ASSERT_EQ(movers.size(), 2u);
    EXPECT_EQ(shapeOf(document, movers[1]).way, (std::vector<Point>{{8, 2}, {8, 5}}));
}

TEST(LevelClipboard, CutTakesAwayWhatItCopies) {
    Workbench bench;
    Document& document = bench.document();
    furnish(bench);
    bench.setPlacing(LevelPiece::rock);
    bench.press({.position = {6, 5}});
    bench.release({.position = {6, 5}});
    bench.setTool(ToolKind::select);
    const std::string before = document.text();
    const std::size_t bodies = document.world().bodies().size();
    auto chosen = thingsOfKind(document, LevelKind::respawn);
    chosen.push_back(thingsOfKind(document, LevelKind::zone).front());
    chosen.push_back(thingsOfKind(document, LevelKind::spawn).front());
    bench.selectThings(chosen);
    const std::string text = bench.cut();
    EXPECT_TRUE(thingsOfKind(document, LevelKind::respawn).empty());
    EXPECT_TRUE(thingsOfKind(document, LevelKind::zone).empty());
    EXPECT_EQ(thingsOfKind(document, LevelKind::spawn).size(), 1u);
    EXPECT_EQ(document.world().bodies().size(), bodies - 1);
    expectOneStep(bench, before);
    bench.paste(text, {0, 0});
    EXPECT_EQ(thingsOfKind(document, LevelKind::respawn).size(), 1u);
    EXPECT_EQ(thingsOfKind(document, LevelKind::zone).size(), 1u);
    EXPECT_EQ(document.world().bodies().size(), bodies);
}

TEST(LevelClipboard, WhatALevelHasOnceStaysOne) {
    Workbench bench;
    furnish(bench);
    const std::string before = bench.document().text();
    for (const LevelThing& thing : levelThings(bench.document())) {
        bench.selectThings({thing});
        EXPECT_EQ(bench.canCopy(), isCopyable(bench.document(), thing));
        if (bench.canCopy()) continue;
        EXPECT_EQ(bench.copy(), "");
        EXPECT_EQ(bench.cut(), "");
        bench.duplicate();
        EXPECT_EQ(bench.document().text(), before);
    }
}

TEST(LevelClipboard, ASceneThatIsNoLevelTakesBodiesOnly) {
    Workbench level, scene;
    furnish(level);
    level.selectThings(thingsOfKind(level.document(), LevelKind::zone));
    const std::string before = scene.document().text();
    EXPECT_THROW(scene.paste(level.copy(), {0, 0}), std::runtime_error);
    EXPECT_EQ(scene.document().text(), before);
    level.select({level.document().world().bodies().front()});
    scene.paste(level.copy(), {0, 0});
    EXPECT_EQ(scene.document().levelText(), "");
    EXPECT_EQ(scene.selection().size(), 1u);
}

// Each piece of the palette, with all that it says.
TEST(LevelClipboard, EachPieceIsDuplicatedInOneStep) {
    for (const LevelPieceInfo& info : levelPieces()) {
        Workbench bench;
        Document& document = bench.document();
        document.adopt(newLevel());
        sulfur::BodyId box;
        document.edit("x", [&] {
            box = document.add("box", sulfur::shapes::BoxOptions{}, {.position = {3, 1}});
        });
        LevelThing made;
        document.edit("y", [&] {
            made = placePiece(document, info.piece, {3, 1}, {5, 3},
                              info.piece == LevelPiece::mover ? box : sulfur::BodyId{});
        });
        bench.selectThings({made});
        if (!bench.canCopy()) continue;
        const std::string before = document.text(), json = jsonOfThing(document, made);
        const std::size_t count = thingsOfKind(document, made.kind).size();
        bench.duplicate();
        EXPECT_EQ(thingsOfKind(document, made.kind).size(), count + 1) << info.name;
        EXPECT_EQ(jsonOfThing(document, made), json) << info.name;
        expectOneStep(bench, before);
    }
}

TEST(LevelClipboard, BadTextsChangeNothing) {
    Workbench bench;
    furnish(bench);
    const std::string before = bench.document().text();
    for (const char* level : {"5", "[]", R"({"zones": 5})", R"({"surfaces": {"nobody": {}}})",
                              R"({"monsters": [{"body": "nobody"}]})"}) {
        bench.pasteAt(
            std::string(R"({"format": "sulfur-scene", "version": 1, "level": )") + level + "}",
            {1, 1});
        EXPECT_EQ(bench.document().text(), before) << level;
        EXPECT_TRUE(bench.things().empty());
    }
    EXPECT_THROW(bench.paste("{\"level\": {}}", {0, 0}), sulfur::scene::ReadError);
    EXPECT_EQ(bench.document().text(), before);
}

}  // namespace
}  // namespace sulfurchamber
