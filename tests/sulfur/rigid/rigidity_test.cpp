#include "rigid/rigidity.hpp"

#include <gtest/gtest.h>

#include "core/slots.hpp"
#include "helpers.hpp"

namespace sulfur::detail {
namespace {

using Labels = std::vector<std::uint32_t>;

const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const std::vector<Bar> sides{{0, 1}, {1, 2}, {2, 3}, {3, 0}};

TEST(Rigidity, AnUnbracedSquareIsNot) {
    EXPECT_EQ(findRigidSets(square, sides), Labels(4, none));
}

TEST(Rigidity, OneDiagonalIsEnough) {
    auto bars = sides;
    bars.push_back({0, 2});
    EXPECT_EQ(findRigidSets(square, bars), Labels(5, 0));
    bars.push_back({1, 3});
    EXPECT_EQ(findRigidSets(square, bars), Labels(6, 0));
}

TEST(Rigidity, AStraightOrFlatOneIsNot) {
    EXPECT_EQ(findRigidSets({{0, 0}, {1, 0}, {2, 0}}, {{0, 1}, {1, 2}}), Labels(2, none));
    // The bars of a flat triangle hold their lengths, yet its middle can move aside.
    EXPECT_EQ(findRigidSets({{0, 0}, {1, 0}, {2, 0}}, {{0, 1}, {1, 2}, {0, 2}}), Labels(3, none));
}

TEST(Rigidity, TwoTrianglesThatShareACornerAreTwo) {
    const auto label = findRigidSets({{0, 0}, {-1, 1}, {-1, -1}, {1, 1}, {1, -1}},
                                     {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}});
    EXPECT_EQ(label, (Labels{0, 0, 0, 1, 1, 1}));
}

TEST(Rigidity, WhatHangsOnARigidSetIsNoPartOfIt) {
    const auto label = findRigidSets({{0, 0}, {1, 0}, {0, 1}, {2, 0}, {3, 0}},
                                     {{0, 1}, {1, 2}, {2, 0}, {1, 3}, {3, 4}});
    EXPECT_EQ(label, (Labels{0, 0, 0, none, none}));
}

/// Three rigid bars that join two triangles make one of them, unless they meet in a point.
TEST(Rigidity, ThreeBarsBetweenTwoTriangles) {
    const std::vector<Point> places{{0, 0}, {1, 0}, {0.5, 1}, {0, 3}, {1, 3}, {0.5, 2}};
    std::vector<Bar> bars{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 3}};
    EXPECT_EQ(findRigidSets(places, bars), Labels(9, 0));
    bars.pop_back();
    EXPECT_EQ(findRigidSets(places, bars), (Labels{0, 0, 0, 1, 1, 1, none, none}));
}

/// K(3,3) has no triangle, yet it is rigid, unless its points lie on a conic.
TEST(Rigidity, TheCompleteBipartiteGraphOfThreeAndThree) {
    std::vector<Bar> bars;
    for (std::uint32_t a = 0; a < 3; ++a)
        for (std::uint32_t b = 3; b < 6; ++b) bars.push_back({a, b});
    EXPECT_EQ(findRigidSets({{0, 0}, {2, 0.3}, {4, -0.2}, {0.2, 2}, {2.5, 1.5}, {4, 3}}, bars),
              Labels(9, 0));
    std::vector<Point> circle;
    for (const double angle : {0.1, 0.9, 2.0, 3.0, 4.1, 5.5})
        circle.emplace_back(std::cos(angle), std::sin(angle));
    EXPECT_EQ(findRigidSets(circle, bars), Labels(9, none));
}

TEST(Rigidity, ALongTrussIsOne) {
    std::vector<Point> places;
    std::vector<Bar> bars;
    for (std::uint32_t i = 0; i < 200; ++i) {
        places.emplace_back(i / 2, i % 2);
        if (i >= 1) bars.push_back({i - 1, i});
        if (i >= 2) bars.push_back({i - 2, i});
    }
    EXPECT_EQ(findRigidSets(places, bars), Labels(bars.size(), 0));
}

}  // namespace
}  // namespace sulfur::detail
