// Groups, locks, what is hidden, what is in front, and putting bodies in line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/transform.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

// Boxes of half a metre in a row, two metres apart.
void row(Workbench& bench, int count) {
    Document& document = bench.document();
    document.edit("Build", [&] {
        for (int i = 0; i < count; ++i)
            document.add("box", sulfur::shapes::BoxOptions{.size = {0.5, 0.5}},
                         {.position = {2.0 * i, 2 + 0.3 * i}});
    });
    bench.select({});
}

std::string nameOf(int i) {
    return i == 0 ? "box" : "box" + std::to_string(i + 1);
}
BodyId boxOf(const Workbench& bench, int i) {
    return bench.document().bodyOf(nameOf(i));
}
void choose(Workbench& bench, const std::vector<int>& which) {
    std::vector<BodyId> bodies;
    for (const int i : which) bodies.push_back(boxOf(bench, i));
    bench.select(bodies);
}
Point placeOf(const Workbench& bench, int i) {
    return bench.document().world().centreOfMass(boxOf(bench, i));
}
void click(Workbench& bench, const Point& at, Pointer keys = {}) {
    keys.position = at;
    bench.press(keys);
    bench.release(keys);
}

TEST(Arrange, AGroupIsSelectedByOneClickAndOneOfItWithAlt) {
    Workbench bench;
    row(bench, 3);
    choose(bench, {0, 1});
    ASSERT_TRUE(canGroup(bench));
    groupSelection(bench);
    EXPECT_EQ(bench.document().undoLabel(), "Group");
    bench.select({});
    click(bench, placeOf(bench, 0));
    EXPECT_EQ(bench.selection().size(), 2u);
    click(bench, placeOf(bench, 0), {.alt = true});
    EXPECT_EQ(bench.selection(), std::vector{boxOf(bench, 0)});
    click(bench, placeOf(bench, 1));
    EXPECT_EQ(bench.selection().size(), 2u);
    click(bench, placeOf(bench, 1), {.clicks = 2});
    EXPECT_EQ(bench.selection(), std::vector{boxOf(bench, 1)});
    // A frame around one of it means all of it.
    bench.press({.position = placeOf(bench, 0) - Point(0.5, 0.5)});
    bench.move({.position = placeOf(bench, 0) + Point(0.5, 0.5)});
    bench.release({.position = placeOf(bench, 0) + Point(0.5, 0.5)});
    EXPECT_EQ(bench.selection().size(), 2u);
    // They move as one.
    const Point gap = placeOf(bench, 1) - placeOf(bench, 0);
    const Point from = placeOf(bench, 0);
    bench.press({.position = from});
    bench.move({.position = from + Point(1, 1)});
    bench.release({.position = from + Point(1, 1)});
    EXPECT_LT((placeOf(bench, 1) - placeOf(bench, 0) - gap).norm(), 1e-5);
}

TEST(Arrange, GroupsLieInGroupsAndFilesKeepThem) {
    Workbench bench;
    row(bench, 4);
    choose(bench, {0, 1});
    groupSelection(bench);
    bench.select(bench.withGroup(boxOf(bench, 0)));
    bench.toggle(boxOf(bench, 2));
    groupSelection(bench);
    EXPECT_EQ(bench.withGroup(boxOf(bench, 2)).size(), 3u);
    const std::string text = bench.document().text();
    Workbench other;
    other.document().adopt(sulfur::scene::parse(text, "a test"));
    EXPECT_EQ(other.document().text(), text);
    EXPECT_EQ(other.withGroup(boxOf(other, 2)).size(), 3u);
    other.select(other.withGroup(boxOf(other, 2)));
    ungroupSelection(other);
    EXPECT_EQ(other.withGroup(boxOf(other, 2)).size(), 1u);
    EXPECT_EQ(other.withGroup(boxOf(other, 0)).size(), 2u) << "the inner group is left";
    other.document().undo();
    EXPECT_EQ(other.document().text(), text);
}

TEST(Arrange, CopiesAreAGroupOfTheirOwn) {
    Workbench bench;
    row(bench, 2);
    choose(bench, {0, 1});
    groupSelection(bench);
    bench.duplicate();
    EXPECT_EQ(bench.selection().size(), 2u);
    const BodyId copy = bench.selection().front();
    EXPECT_EQ(bench.withGroup(copy), bench.selection());
    EXPECT_EQ(bench.withGroup(boxOf(bench, 0)).size(), 2u);
}

TEST(Arrange, AltDragCopiesAsOneStep) {
    Workbench bench;
    row(bench, 1);
    const std::string before = bench.document().text();
    const Point from = placeOf(bench, 0);
    const auto keys = [](Point at) { return Pointer{.position = at, .alt = true}; };
    bench.press(keys(from));
    bench.move(keys(from + Point(0, 1)));
    bench.move(keys(from + Point(1, 2)));
    bench.release(keys(from + Point(1, 2)));
    ASSERT_EQ(bench.document().scene().bodies.size(), 3u);
    EXPECT_LT((placeOf(bench, 0) - from).norm(), 1e-5);
    EXPECT_LT((placeOf(bench, 1) - from - Point(1, 2)).norm(), 1e-4);
    EXPECT_EQ(bench.selection(), std::vector{boxOf(bench, 1)});
    bench.document().undo();
    EXPECT_EQ(bench.document().text(), before);
    // Escape while one drags leaves nothing behind.
    bench.press(keys(from));
    bench.move(keys(from + Point(0, 1)));
    bench.cancel();
    EXPECT_EQ(bench.document().text(), before);
}

TEST(Arrange, WhatIsLockedCannotBePickedOrErased) {
    Workbench bench;
    row(bench, 2);
    choose(bench, {0});
    setLocked(bench, bench.selection(), true);
    EXPECT_TRUE(bench.selection().empty());
    click(bench, placeOf(bench, 0));
    EXPECT_TRUE(bench.selection().empty());
    bench.selectAll();
    EXPECT_FALSE(bench.selected(boxOf(bench, 0)));
    bench.setTool(ToolKind::erase);
    click(bench, placeOf(bench, 0));
    EXPECT_TRUE(boxOf(bench, 0));
    bench.setTool(ToolKind::select);
    // While time runs the spring does not take it either.
    bench.document().play();
    const Point at = placeOf(bench, 0);
    bench.press({.position = at});
    bench.move({.position = at + Point(0, 3)});
    EXPECT_EQ(bench.preview().kind, Preview::Kind::band);
    bench.cancel();
    bench.document().pause();
    EXPECT_EQ(lockedCount(bench.document()), 1u);
    unlockAll(bench);
    EXPECT_EQ(lockedCount(bench.document()), 0u);
    click(bench, placeOf(bench, 0));
    EXPECT_TRUE(bench.selected(boxOf(bench, 0)));
}

TEST(Arrange, WhatIsHiddenStillMovesAndTheHintSaysSo) {
    Workbench bench;
    row(bench, 2);
    choose(bench, {0});
    setHidden(bench, bench.selection(), true);
    EXPECT_TRUE(bench.selection().empty());
    click(bench, placeOf(bench, 0));
    EXPECT_TRUE(bench.selection().empty());
    EXPECT_NE(bench.hint().find("1 body is hidden and still simulated"), std::string::npos);
    const double height = placeOf(bench, 0).y();
    for (int i = 0; i < 100; ++i) bench.tick();
    EXPECT_LT(placeOf(bench, 0).y(), height - 0.05);
    showAll(bench);
    EXPECT_EQ(bench.hint().find("hidden"), std::string::npos);
}

TEST(Arrange, WhatIsInFrontIsPickedFirst) {
    Workbench bench;
    Document& document = bench.document();
    document.edit("Build", [&] {
        for (int i = 0; i < 2; ++i)
            document.add("box", sulfur::shapes::BoxOptions{.size = {1, 1}}, {.position = {0, 3}});
    });
    click(bench, {0, 3});
    EXPECT_EQ(bench.selection(), std::vector{boxOf(bench, 1)});
    choose(bench, {0});
    orderSelection(bench, true);
    bench.select({});
    click(bench, {0, 3});
    EXPECT_EQ(bench.selection(), std::vector{boxOf(bench, 0)});
    orderSelection(bench, false);
    bench.select({});
    click(bench, {0, 3});
    EXPECT_EQ(bench.selection(), std::vector{boxOf(bench, 1)});
    EXPECT_EQ(marksOf(*document.scene().body("box")).order, -1);
}

TEST(Arrange, AlignsAllSixWays) {
    const auto aligned = [](Alignment alignment) {
        Workbench bench;
        row(bench, 3);
        choose(bench, {0, 1, 2});
        alignSelection(bench, alignment);
        EXPECT_EQ(bench.document().undoLabel(), "Align");
        return std::array{placeOf(bench, 0), placeOf(bench, 1), placeOf(bench, 2)};
    };
    const std::array<std::pair<Alignment, double>, 6> wanted{{{Alignment::left, 0},
                                                              {Alignment::centre, 2},
                                                              {Alignment::right, 4},
                                                              {Alignment::bottom, 2},
                                                              {Alignment::middle, 2.3},
                                                              {Alignment::top, 2.6}}};
    for (const auto& [alignment, place] : wanted) {
        const int axis = alignment <= Alignment::right ? 0 : 1;
        for (const Point& centre : aligned(alignment)) EXPECT_NEAR(centre[axis], place, 1e-4);
    }
}

TEST(Arrange, DistributesWithEqualGapsAndKeepsGroupsTogether) {
    Workbench bench;
    row(bench, 4);
    // Two of them are a group that is 2.5 m wide.
    choose(bench, {1, 2});
    groupSelection(bench);
    choose(bench, {0, 1, 2, 3});
    bench.document().edit("Move", [&] {
        const BodyId first = boxOf(bench, 0);
        bench.document().translate({&first, 1}, {-3, 0});
    });
    ASSERT_TRUE(canDistribute(bench));
    distributeSelection(bench, true);
    EXPECT_NEAR(placeOf(bench, 2).x() - placeOf(bench, 1).x(), 2, 1e-4);
    EXPECT_NEAR(placeOf(bench, 1).x() - placeOf(bench, 0).x(),
                placeOf(bench, 3).x() - placeOf(bench, 2).x(), 1e-4);
    EXPECT_NEAR(placeOf(bench, 0).x(), -3, 1e-4);
    EXPECT_NEAR(placeOf(bench, 3).x(), 6, 1e-4);
    distributeSelection(bench, false);
    EXPECT_NEAR(placeOf(bench, 1).y() - placeOf(bench, 0).y(),
                placeOf(bench, 3).y() - placeOf(bench, 2).y(), 1e-4);
    choose(bench, {1, 2});
    EXPECT_FALSE(canAlign(bench)) << "a group is one";
    EXPECT_FALSE(canDistribute(bench));
}

TEST(Arrange, DamagedMembersOfAFileCountAsNone) {
    sulfur::scene::Placement body;
    auto& extra = body.extra[""];
    sulfur::scene::setExtra(extra, "group", "7");
    sulfur::scene::setExtra(extra, "locked", "\"yes\"");
    sulfur::scene::setExtra(extra, "hidden", "[true]");
    sulfur::scene::setExtra(extra, "order", "1e99");
    EXPECT_EQ(marksOf(body), BodyMarks{});
}

TEST(Arrange, AllOfItIsUndoneToTheByte) {
    Workbench bench;
    row(bench, 4);
    const std::string before = bench.document().text();
    const std::size_t place = bench.document().historyPlace();
    choose(bench, {0, 1, 2});
    groupSelection(bench);
    choose(bench, {0, 1, 3});
    alignSelection(bench, Alignment::top);
    orderSelection(bench, true);
    renameGroup(bench, "group 1", "left ones");
    setHidden(bench, {{boxOf(bench, 3)}}, true);
    setLocked(bench, {{boxOf(bench, 2)}}, true);
    const std::string after = bench.document().text();
    EXPECT_NE(after.find("\"left ones\""), std::string::npos);
    EXPECT_THROW(renameGroup(bench, "left ones", "a/b"), std::runtime_error);
    EXPECT_EQ(bench.document().historyPlace(), place + 6);
    while (bench.document().historyPlace() > place) bench.document().undo();
    EXPECT_EQ(bench.document().text(), before);
    while (bench.document().canRedo()) bench.document().redo();
    EXPECT_EQ(bench.document().text(), after);
}

}  // namespace
}  // namespace sulfurchamber
