#include "polygon.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace {

using namespace atlax;
using namespace atlax::detail;

float triangulatedArea(const std::vector<Vec2>& points) {
    float area = 0;
    for (const auto& t : triangulate(points)) {
        const float part = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]) / 2;
        EXPECT_GE(part, 0) << "no triangle is turned over";
        area += part;
    }
    return area;
}

TEST(Polygon, convexBecomesAFan) {
    const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    EXPECT_EQ(triangulate(square).size(), 2u);
    EXPECT_FLOAT_EQ(triangulatedArea(square), 4);
}

TEST(Polygon, concaveKeepsItsArea) {
    const std::vector<Vec2> comb{{0, 0}, {7, 0}, {7, 4}, {6, 4}, {6, 1}, {5, 1}, {5, 4}, {4, 4},
                                 {4, 1}, {3, 1}, {3, 4}, {2, 4}, {2, 1}, {1, 1}, {1, 4}, {0, 4}};
    EXPECT_EQ(triangulate(comb).size(), comb.size() - 2);
    EXPECT_FLOAT_EQ(triangulatedArea(comb), doubleArea(comb) / 2);
}

TEST(Polygon, spiralKeepsItsArea) {
    std::vector<Vec2> spiral;
    for (int i = 0; i < 60; ++i) {
        const float a = static_cast<float>(i) * 0.2f;
        spiral.push_back(Vec2{std::cos(a), std::sin(a)} * (1 + 0.3f * a));
    }
    for (int i = 59; i >= 0; --i) {
        const float a = static_cast<float>(i) * 0.2f;
        spiral.push_back(Vec2{std::cos(a), std::sin(a)} * (0.8f + 0.3f * a));
    }
    if (doubleArea(spiral) < 0) std::reverse(spiral.begin(), spiral.end());
    EXPECT_NEAR(triangulatedArea(spiral), doubleArea(spiral) / 2, 1e-3f);
}

TEST(Polygon, crossingsComeToAnEnd) {
    std::vector<Vec2> star;
    for (int i = 0; i < 11; ++i) {
        const float a = static_cast<float>(i * 5) * 6.2831853f / 11;
        star.push_back({std::cos(a), std::sin(a)});
    }
    EXPECT_EQ(triangulate(star).size(), 9u);
    EXPECT_EQ(triangulate(std::vector<Vec2>(50, Vec2{1, 1})).size(), 48u);
    EXPECT_TRUE(triangulate(std::vector<Vec2>{{0, 0}, {1, 1}}).empty());
}

TEST(Polygon, repeatsAndNonsenseAreRemoved) {
    std::vector<Vec2> points{{0, 0}, {0, 0}, {1, 0}, {std::nanf(""), 0}, {1, 0}, {1, 1}, {0, 0}};
    removeRepeats(points);
    EXPECT_EQ(points, (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}}));
    std::vector<Vec2> none;
    removeRepeats(none);
    EXPECT_TRUE(none.empty());
}

}  // namespace
