#include "broadphase/grid.hpp"

#include <algorithm>
#include <set>

#include "broadphase/rasterise.hpp"
#include "../helpers.hpp"

namespace sulfur {
namespace {

using detail::Cell;

TEST(Grid, FindsWhatWasInsertedInOrder) {
    detail::Grid grid;
    for (std::uint32_t i = 0; i < 100; ++i)
        grid.insert({static_cast<std::int32_t>(i % 7) - 3, -static_cast<std::int32_t>(i % 3)}, i);
    grid.build();
    std::vector<std::uint32_t> found;
    grid.forEachIn({2, -1}, [&](std::uint32_t item) { found.push_back(item); });
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < 100; ++i)
        if (i % 7 == 5 && i % 3 == 1) expected.push_back(i);
    EXPECT_EQ(found, expected);
    EXPECT_FALSE(expected.empty());
    grid.forEachIn({50, 50}, [](std::uint32_t) { ADD_FAILURE(); });
}

TEST(Grid, PairsAreThoseOfOneCell) {
    detail::Grid grid;
    grid.insert({0, 0}, 1);
    grid.insert({0, 1}, 2);
    grid.insert({0, 0}, 3);
    grid.insert({0, 0}, 4);
    grid.build();
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    grid.forEachPair([&](std::uint32_t a, std::uint32_t b) { pairs.emplace(a, b); });
    const std::set<std::pair<std::uint32_t, std::uint32_t>> expected{{1, 3}, {1, 4}, {3, 4}};
    EXPECT_EQ(pairs, expected);
}

/// Distance of p from a segment.
double distanceTo(const Point& p, const Point& a, const Point& b) {
    const double square = (b - a).squaredNorm();
    const double share = square > 0 ? (p - a).dot(b - a) / square : 0;
    return (p - a - std::clamp(share, 0.0, 1.0) * (b - a)).norm();
}

/// Distance between two capsules' axes by brute force over closest ends; 0 when they cross.
double axisDistance(Point a, Point b, Point c, Point d) {
    const auto side = [](const Point& u, const Point& v, const Point& p) {
        return cross(v - u, p - u);
    };
    if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return 0;
    return std::min({distanceTo(a, c, d), distanceTo(b, c, d), distanceTo(c, a, b),
                     distanceTo(d, a, b)});
}

TEST(Rasterise, TouchingCapsulesAlwaysShareACell) {
    test::Random random(1);
    int touching = 0;
    for (int trial = 0; trial < 60000; ++trial) {
        const auto place = [&](const Point& near, double spread) {
            return Point(near[0] + random.uniform(-spread, spread),
                         near[1] + random.uniform(-spread, spread));
        };
        const double length = std::pow(10.0, random.uniform(-1.5, 0.8));
        const Point origin = place({0, 0}, 5);
        const Point a = place(origin, length), b = place(a, length);
        const Point c = place(origin, length), d = random.below(10) == 0 ? c : place(c, length);
        const double r = random.uniform(0, 0.6), s = random.uniform(0, 0.3);
        if (axisDistance(a, b, c, d) > r + s) continue;
        ++touching;
        std::set<Cell> cells;
        detail::rasteriseCapsule(a, b, r, [&](Cell cell) { cells.insert(cell); });
        bool shared = false;
        detail::rasteriseCapsule(c, d, s, [&](Cell cell) { shared |= cells.count(cell) > 0; });
        ASSERT_TRUE(shared) << "trial " << trial;
    }
    EXPECT_GT(touching, 5000);
}

TEST(Rasterise, EmitsNoCellTwiceAndStaysNear) {
    test::Random random(2);
    for (int trial = 0; trial < 2000; ++trial) {
        const Point a(random.uniform(-9, 9), random.uniform(-9, 9));
        const Point b(random.uniform(-9, 9), random.uniform(-9, 9));
        std::set<Cell> cells;
        detail::rasteriseCapsule(a, b, 0.3, [&](Cell cell) {
            EXPECT_TRUE(cells.insert(cell).second);
            const Point middle(cell.x + 0.5, cell.y + 0.5);
            EXPECT_LT(distanceTo(middle, a, b), 0.3 + 1.6);
        });
    }
}

}  // namespace
}  // namespace sulfur
