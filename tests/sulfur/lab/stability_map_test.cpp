// The maps of stability, against the laws that they must follow.
#include <gtest/gtest.h>

#include "entry_of.hpp"
#include "stability/stability_map.hpp"

namespace {

using namespace sulfur::lab;

TEST(HangingLimit, FollowsTheLaws) {
    for (const double rate : {60.0, 500.0, 10000.0}) {
        const double h = 1 / rate, b = 0.1;
        const RopeConstants rope{.particles = 10, .airFriction = 0, .damping = b};
        EXPECT_NEAR(*hangingLimit(rope, entryOf("euler"), rate, 1e10).limit * h / b, 1, 0.03);
        EXPECT_NEAR(*hangingLimit(rope, entryOf("suvat"), rate, 1e10).limit * h / (2 * b), 1, 0.03);
        const double nsv = 0.05 / (h * h) - 2 * b / h;
        EXPECT_NEAR(*hangingLimit(rope, entryOf("nsv"), rate, 1e10).limit / nsv, 1, 0.05);
        EXPECT_NEAR(*hangingLimit(rope, entryOf("verlet"), rate, 1e10).limit / nsv, 1, 0.05);
    }
}

TEST(HangingLimit, IsNeverForUndampedEulerAndNoneForImplicitEuler) {
    const RopeConstants rope{.particles = 10, .airFriction = 0, .damping = 0};
    const auto euler = hangingLimit(rope, entryOf("euler"), 500, 1e10);
    EXPECT_FALSE(euler.any);
    EXPECT_FALSE(euler.limit);
    const auto implicit = hangingLimit(rope, entryOf("implicit"), 500, 1e10);
    EXPECT_TRUE(implicit.any);
    EXPECT_FALSE(implicit.limit);
}

TEST(StabilityMap, HasACellForEveryRateAndDamping) {
    const StabilityMapOptions options{.rates = 3, .dampings = 4, .highest = 1e6};
    const auto map = measureStabilityMap(entryOf("nsv"), options);
    ASSERT_EQ(map.cells.size(), 12u);
    EXPECT_EQ(map.dampings.front(), 0);
    EXPECT_NEAR(map.rates.front(), 60, 1e-9);
    EXPECT_NEAR(map.rates.back(), 10000, 1e-6);
    EXPECT_EQ(map.cells[4].rate, map.rates[1]);
    EXPECT_EQ(map.cells[4].damping, map.dampings[1]);
    const auto svg = asSvg(map);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_NE(svg.find("no limit"), std::string::npos);
}

}  // namespace
