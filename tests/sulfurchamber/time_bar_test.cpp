// Where things stand on the time bar.
#include <gtest/gtest.h>

#include "model/workbench.hpp"
#include "view/time_bar_layout.hpp"

namespace sulfurchamber {
namespace {

constexpr double width = 400;

TimeBarLayout layoutOf(const Document& document) {
    return {document.timeline(), static_cast<double>(document.world().tickDuration()), width};
}

void letPass(Workbench& bench, int ticks) {
    for (int i = 0; i < ticks; ++i) bench.tick();
}

TEST(TimeBar, IsEmptyBeforeTimeHasPassed) {
    Workbench bench;
    EXPECT_TRUE(layoutOf(bench.document()).empty());
    EXPECT_TRUE(layoutOf(bench.document()).lanes().empty());
}

TEST(TimeBar, HasASecondAtLeast) {
    Workbench bench;
    letPass(bench, 250);  // of 500 a second
    const auto layout = layoutOf(bench.document());
    EXPECT_DOUBLE_EQ(layout.from(), 0);
    EXPECT_DOUBLE_EQ(layout.to(), width / 2);
    EXPECT_DOUBLE_EQ(*layout.now(), width / 2);
    EXPECT_EQ(layout.momentAt(width / 4).tick, 125u);
    EXPECT_EQ(layout.momentAt(width).tick, 250u);  // no further than was recorded
    EXPECT_EQ(layout.momentAt(-9).tick, 0u);
    EXPECT_EQ(layout.textAt(width / 4, 3), "0.25 s");
}

TEST(TimeBar, ShowsMarksAndTellsThemUnderThePointer) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    bench.press({.position = {0, 1}});
    bench.release({.position = {0.5, 1.5}});
    letPass(bench, 1000);
    bench.document().edit("Nudge", [&] {
        const auto bodies = bench.document().world().bodies();
        bench.document().translate({&bodies[1], 1}, {0, 1});
    });
    const auto layout = layoutOf(bench.document());
    ASSERT_EQ(layout.spots().size(), 2u);
    EXPECT_EQ(layout.spots()[0].mark.kind, Mark::Kind::contact);
    EXPECT_EQ(layout.textAt(layout.spots()[0].x, 3).substr(6), ", 1 first contact");
    EXPECT_EQ(layout.textAt(width, 3), "2.00 s, Nudge");
}

TEST(TimeBar, OtherFuturesHaveLanesFromWhereTheyParted) {
    Workbench bench;
    Document& document = bench.document();
    letPass(bench, 1000);
    const std::uint32_t first = document.timeline().line();
    for (const std::uint64_t tick : {200u, 400u, 300u, 350u}) {
        document.goTo({first, tick});
        letPass(bench, 300);
    }
    const auto layout = layoutOf(document);
    EXPECT_DOUBLE_EQ(layout.to(), width * 650 / 1000);
    ASSERT_EQ(layout.lanes().size(), 4u);
    for (const auto& lane : layout.lanes()) {
        EXPECT_LT(lane.row, TimeBarLayout::mostRows);
        for (const auto& other : layout.lanes())
            if (lane.branch != other.branch && lane.row == other.row && lane.row < 2) {
                EXPECT_TRUE(lane.to < other.from || other.to < lane.from);
            }
    }
    const auto& old = layout.lanes()[0];
    EXPECT_EQ(old.branch, first);
    EXPECT_DOUBLE_EQ(old.to, width);
    const auto there = layout.otherAt(width - 1, old.row, 3);
    ASSERT_TRUE(there);
    EXPECT_EQ(there->branch, first);
    EXPECT_NEAR(static_cast<double>(there->tick), 998, 2);
    EXPECT_FALSE(layout.otherAt(width / 8, 0, 3));
    EXPECT_FALSE(layout.otherAt(width - 1, 7, 3));
}

}  // namespace
}  // namespace sulfurchamber
