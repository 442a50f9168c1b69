// The paper's Table 4 in the sandbox: it runs beside the window, and is told with the paper's.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "model/table4.hpp"

namespace sulfurchamber {
namespace {

void waitForEnd(const Table4& table) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::minutes(3);
    while (table.running() && std::chrono::steady_clock::now() < until)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ASSERT_FALSE(table.running());
}

TEST(Table4, HasTheFiguresOfThePaper) {
    const auto machines = table4Machines();
    ASSERT_EQ(machines.size(), 3u);
    EXPECT_EQ(std::vector<int>(table4Rates().begin(), table4Rates().end()),
              (std::vector<int>{20, 40, 60, 80, 100, 150, 200}));
    EXPECT_EQ(machines[2].percent, (std::vector<double>{5, 10, 20, 25, 35, 50, 75}));
}

TEST(Table4, RunsBesideAndCountsItsOwnTimeOnly) {
    Table4 table;
    EXPECT_EQ(table.progress(), 0);
    table.start({20, 60}, 1.5);
    EXPECT_TRUE(table.running());
    waitForEnd(table);
    EXPECT_EQ(table.progress(), 1);
    const auto cells = table.cells();
    ASSERT_EQ(cells.size(), 2u);
    EXPECT_EQ(cells[0].rate, 20);
    EXPECT_EQ(cells[0].boxes, 30u);
    EXPECT_EQ(cells[1].boxes, 90u);
    EXPECT_GT(cells[0].percent, 0);
    EXPECT_GT(cells[1].percent, cells[0].percent) << "three times as many boxes";
}

TEST(Table4, StopsWithinATickAndBeginsAnew) {
    Table4 table;
    table.start({200, 200, 200}, 60);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const auto before = std::chrono::steady_clock::now();
    table.stop();
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(5));
    EXPECT_FALSE(table.running());
    EXPECT_LT(table.progress(), 1);
    EXPECT_TRUE(table.cells().empty());
    table.start({20}, 0.1);
    waitForEnd(table);
    EXPECT_EQ(table.cells().size(), 1u);
    // What is destroyed while it runs, ends.
    table.start({200}, 60);
}

TEST(Table4, IsATableForASpreadsheet) {
    const std::vector<Table4Cell> cells{{20, 1.5, 200}, {60, 12.25, 600}};
    EXPECT_EQ(table4Csv(cells),
              "share of processor time (%) by boxes a second,20,40,60,80,100,150,200\n"
              "\"paper: Athlon64 3200, Windows XP\",12.0,30.0,45.0,65.0,83.0,100.0,100.0\n"
              "\"paper: Core2Duo T7700, Windows 7\",10.0,22.0,42.0,55.0,72.0,95.0,100.0\n"
              "\"paper: Core-i7 930, Ubuntu\",5.00,10.0,20.0,25.0,35.0,50.0,75.0\n"
              "this machine,1.50,,12.2,,,,\n");
}

}  // namespace
}  // namespace sulfurchamber
