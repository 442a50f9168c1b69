// Where the pictures of the library stand.
#include <gtest/gtest.h>

#include "view/picture_grid_layout.hpp"

namespace sulfurchamber {
namespace {

const std::vector<std::string> groups{"A", "A", "A", "A", "B", "B"};

TEST(PictureGrid, PutsPicturesUnderTheirHeadings) {
    const auto layout = PictureGridLayout::of(groups, {.width = 320});
    ASSERT_EQ(layout.cells.size(), 6u);
    ASSERT_EQ(layout.headings.size(), 2u);
    EXPECT_EQ(layout.headings[1].text, "B");
    EXPECT_LT(layout.headings[0].place.y, layout.cells[0].y);
    EXPECT_EQ(layout.cells[0].y, layout.cells[2].y);
    EXPECT_GT(layout.cells[3].y, layout.cells[0].y);
    EXPECT_EQ(layout.cells[3].x, layout.cells[0].x);
    EXPECT_GT(layout.cells[4].y, layout.headings[1].place.y);
    for (std::size_t i = 0; i < layout.cells.size(); ++i) {
        const GridRect& cell = layout.cells[i];
        EXPECT_LE(cell.x + cell.width, 320);
        EXPECT_LE(cell.y + cell.height, layout.height);
        EXPECT_EQ(layout.at(cell.x + cell.width / 2, cell.y + cell.height / 2), i);
    }
    EXPECT_FALSE(layout.at(-1, -1));
}

TEST(PictureGrid, FitsIntoNarrowAndWideWindows) {
    const auto narrow = PictureGridLayout::of(groups, {.width = 100});
    for (std::size_t i = 1; i < 6; ++i) EXPECT_GT(narrow.cells[i].y, narrow.cells[i - 1].y);
    const auto wide = PictureGridLayout::of(groups, {.width = 900});
    EXPECT_EQ(wide.cells[0].y, wide.cells[3].y);
    EXPECT_TRUE(PictureGridLayout::of({}, {}).cells.empty());
}

TEST(PictureGrid, KeysGoFromOneToTheNext) {
    const auto layout = PictureGridLayout::of(groups, {.width = 320});
    EXPECT_EQ(layout.moved(0, 1, 0), 1u);
    EXPECT_EQ(layout.moved(0, -1, 0), 0u);
    EXPECT_EQ(layout.moved(5, 1, 0), 5u);
    EXPECT_EQ(layout.moved(2, 0, 1), 3u) << "the next row is shorter";
    EXPECT_EQ(layout.moved(3, 0, 1), 4u);
    EXPECT_EQ(layout.moved(5, 0, -1), 3u);
    EXPECT_EQ(layout.moved(0, 0, -1), 0u);
}

}  // namespace
}  // namespace sulfurchamber
