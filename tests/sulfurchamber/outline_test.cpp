// The tree of all that a scene has, and its search.
#include <gtest/gtest.h>

#include <chrono>

#include "model/outliner.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;

void build(Workbench& bench, int count) {
    Document& document = bench.document();
    document.edit("Build", [&] {
        for (int i = 0; i < count; ++i)
            document.add("box", sulfur::shapes::BoxOptions{.size = {0.5, 0.5}},
                         {.position = {0.6 * (i % 60), 1 + 0.6 * (i / 60)}});
    });
}

std::vector<std::string> namesOf(const std::vector<OutlineRow>& rows) {
    std::vector<std::string> names;
    for (const OutlineRow& row : rows)
        names.push_back(std::string(static_cast<std::size_t>(row.depth), ' ') + row.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(Outline, ListsBodiesInTheirGroups) {
    Workbench bench;
    build(bench, 3);
    Document& document = bench.document();
    bench.select({document.bodyOf("box"), document.bodyOf("box3")});
    groupSelection(bench);
    Outliner outliner;
    EXPECT_EQ(namesOf(outliner.rows(bench)), (Names{"floor", "group 1", " box", " box3", "box2"}));
    const std::uint64_t version = outliner.version();
    outliner.rows(bench);
    EXPECT_EQ(outliner.version(), version) << "nothing has changed";
    const OutlineRow group = outliner.rows(bench)[1];
    EXPECT_EQ(group.bodies.size(), 2u);
    EXPECT_FALSE(group.hidden);
    setHidden(bench, group.bodies, true);
    EXPECT_TRUE(outliner.rows(bench)[1].hidden);
    EXPECT_TRUE(outliner.rows(bench)[2].hidden);
    EXPECT_FALSE(outliner.rows(bench)[4].hidden);
    outliner.toggle("group 1");
    EXPECT_EQ(namesOf(outliner.rows(bench)), (Names{"floor", "group 1", "box2"}));
}

TEST(Outline, SearchFindsNamesAndOpensTheirGroups) {
    Workbench bench;
    build(bench, 3);
    Document& document = bench.document();
    bench.select({document.bodyOf("box"), document.bodyOf("box3")});
    groupSelection(bench);
    Outliner outliner;
    outliner.toggle("group 1");
    outliner.setSearch("BOX3");
    EXPECT_EQ(namesOf(outliner.rows(bench)), (Names{"group 1", " box3"}));
    outliner.setSearch("group");
    EXPECT_EQ(namesOf(outliner.rows(bench)), (Names{"group 1", " box", " box3"}))
        << "all of what is found";
    outliner.setSearch("nothing of this name");
    EXPECT_TRUE(outliner.rows(bench).empty());
    outliner.setSearch("");
    EXPECT_EQ(outliner.rows(bench).size(), 3u);
}

TEST(Outline, RenamesBodiesAndGroups) {
    Workbench bench;
    build(bench, 2);
    Document& document = bench.document();
    bench.select({document.bodyOf("box"), document.bodyOf("box2")});
    groupSelection(bench);
    Outliner outliner;
    rename(bench, outliner.rows(bench)[1], "tower");
    rename(bench, outliner.rows(bench)[2], "top");
    EXPECT_EQ(namesOf(outliner.rows(bench)), (Names{"floor", "tower", " top", " box2"}));
    EXPECT_THROW(rename(bench, outliner.rows(bench)[3], "top"), std::runtime_error);
    document.undo();
    document.undo();
    EXPECT_EQ(namesOf(outliner.rows(bench)), (Names{"floor", "group 1", " box", " box2"}));
}

TEST(Outline, ListsMechanismsFieldsAndPieces) {
    Workbench bench;
    build(bench, 2);
    Document& document = bench.document();
    document.edit("Add", [&] {
        sulfur::scene::SceneMechanism hinge;
        hinge.spec = sulfur::scene::Hinge{"box", "box2", {0.3, 1}, {}};
        document.planForEditing().mechanisms.push_back(hinge);
        document.planForEditing().fields.push_back({sulfur::WindField{}, {}});
    });
    Outliner outliner;
    const auto rows = outliner.rows(bench);
    EXPECT_EQ(namesOf(rows), (Names{"floor", "box", "box2", "Hinge: box, box2", "Wind"}));
    EXPECT_EQ(rows[3].kind, OutlineRow::Kind::mechanism);
    EXPECT_EQ(rows[3].bodies.size(), 2u);
    ASSERT_TRUE(boundsOf(bench, rows[3]));
    EXPECT_NEAR(boundsOf(bench, rows[3])->size().x(), 1.1, 1e-4);
    EXPECT_FALSE(boundsOf(bench, rows[4]));
}

TEST(Outline, StaysQuickWithTwoThousandBodies) {
    Workbench bench;
    build(bench, 2000);
    Outliner outliner;
    outliner.rows(bench);
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < 20; ++i) {
        outliner.setSearch(i % 2 == 0 ? "box1" : "");
        outliner.rows(bench);
    }
    const std::chrono::duration<double> each = (std::chrono::steady_clock::now() - begin) / 20;
    EXPECT_EQ(outliner.rows(bench).size(), 2001u);
    EXPECT_LT(each.count(), 0.25) << "a search of each letter that is typed";
}

}  // namespace
}  // namespace sulfurchamber
