// PenPath data, transforms and curves of drawings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "model/path_data.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

Outline lines(const std::string& data, double tolerance = 0.001) {
    const PenPath path = readPathData(data);
    EXPECT_EQ(path.size(), 1u) << data;
    return path.empty() ? Outline{} : flattened(path[0], tolerance);
}

void expectPoints(const Outline& is, const Outline& wanted) {
    ASSERT_EQ(is.size(), wanted.size());
    for (std::size_t i = 0; i < is.size(); ++i)
        EXPECT_NEAR((is[i] - wanted[i]).norm(), 0, 1e-9) << i;
}

TEST(PathData, LinesAreAbsoluteAndRelative) {
    const Outline square{{1, 2}, {4, 2}, {4, 6}, {1, 6}};
    expectPoints(lines("M1 2 L4 2 L4 6 L1 6 Z"), square);
    expectPoints(lines("m1 2 3 0 0 4-3 0z"), square);
    expectPoints(lines("M1,2H4V6H1Z"), square);
    expectPoints(lines("m 1 2 h 3 v 4 h -3 z"), square);
    expectPoints(lines("M1 2 4 2 4 6 1 6 1 2Z"), square);  // ends where it began
}

TEST(PathData, NumbersNeedNoSpace) {
    expectPoints(lines("M.5.5L1.5.5 1.5-.5"), {{0.5, 0.5}, {1.5, 0.5}, {1.5, -0.5}});
    expectPoints(lines("M1e1+2L-1E-1 0 5 5"), {{10, 2}, {-0.1, 0}, {5, 5}});
}

// A curve is missed by no more than the tolerance, which is not wasted either.
TEST(PathData, CurvesStayWithinTheTolerance) {
    for (const double tolerance : {0.1, 0.01, 0.001}) {
        const Outline line = lines("M0 0 C0 10 10 10 10 0", tolerance);
        double worst = 0;
        for (int i = 0; i <= 1000; ++i) {
            const double t = i / 1000.0;
            const Point at(30 * (1 - t) * t * t + 10 * t * t * t,
                           30 * (1 - t) * (1 - t) * t + 30 * (1 - t) * t * t);
            double least = 1e9;
            for (std::size_t k = 0; k + 1 < line.size(); ++k) {
                const Point way = line[k + 1] - line[k];
                const double s = std::clamp((at - line[k]).dot(way) / way.squaredNorm(), 0.0, 1.0);
                least = std::min(least, (line[k] + s * way - at).norm());
            }
            worst = std::max(worst, least);
        }
        EXPECT_LE(worst, tolerance);
        EXPECT_GT(worst, tolerance / 30);
    }
}

TEST(PathData, SmoothCurvesMirrorTheControlPoint) {
    const PenPath whole = readPathData("M0 0 C1 2 3 2 4 0 S7 -2 8 0");
    ASSERT_EQ(whole[0].curves.size(), 2u);
    EXPECT_EQ(whole[0].curves[1].first, Point(5, -2));
    const PenPath alone = readPathData("M0 0 L4 0 S7 -2 8 0");
    EXPECT_EQ(alone[0].curves[1].first, Point(4, 0));
    // Of a quadratic one both thirds of the way to the control point.
    const PenPath quadratic = readPathData("M0 0 Q3 3 6 0 T12 0");
    EXPECT_NEAR((quadratic[0].curves[0].first - Point(2, 2)).norm(), 0, 1e-12);
    EXPECT_NEAR((quadratic[0].curves[1].first - Point(8, -2)).norm(), 0, 1e-12);
}

TEST(PathData, ArcsAreCircles) {
    // Three quarters of a circle about (5, 5), and the quarter that is left, in both senses.
    for (const auto& [flags, size] : {std::pair("1 1", 1.5), std::pair("0 0", 0.5)}) {
        const PenPath path = readPathData("M10 5 A5 5 0 " + std::string(flags) + " 5 0");
        const Outline line = flattened(path[0], 1e-4);
        double length = 0;
        const Point centre = size > 1 ? Point(5, 5) : Point(5, 5);
        for (std::size_t i = 0; i < line.size(); ++i) {
            EXPECT_NEAR((line[i] - centre).norm(), 5, 2e-4);
            if (i > 0) length += (line[i] - line[i - 1]).norm();
        }
        EXPECT_NEAR(length, size * std::numbers::pi * 5, 0.01);
        EXPECT_EQ(line.back(), Point(5, 0));
    }
    // Radii that are too small grow until the arc reaches its end; flags need no space.
    const Outline half = lines("M0 0a1 1 0 0110 0", 1e-4);
    for (const Point& point : half) EXPECT_NEAR((point - Point(5, 0)).norm(), 5, 1e-3);
    expectPoints(lines("M0 0A0 1 0 0 1 3 4L1 1"), {{0, 0}, {3, 4}, {1, 1}});
}

TEST(PathData, TransformsFollowEachOther) {
    const auto at = [](const char* text) { return Point(readTransform(text) * Point(1, 0)); };
    EXPECT_EQ(at("translate(2)"), Point(3, 0));
    EXPECT_EQ(at(" translate( 2 , 3 ) "), Point(3, 3));
    EXPECT_EQ(at("scale(2) translate(1 1)"), Point(4, 2));
    EXPECT_EQ(at("matrix(1 2 3 4 5 6)"), Point(6, 8));
    EXPECT_NEAR((at("rotate(90)") - Point(0, 1)).norm(), 0, 1e-12);
    EXPECT_NEAR((at("rotate(90 1 1)") - Point(2, 1)).norm(), 0, 1e-12);
    EXPECT_NEAR((at("skewY(45)") - Point(1, 1)).norm(), 0, 1e-12);
    EXPECT_EQ(at("skewX(45)"), Point(1, 0));
    EXPECT_EQ(at(""), Point(1, 0));
}

std::string problemOf(const std::string& data) {
    try {
        readPathData(data);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(PathData, ProblemsAreToldWithTheirPlace) {
    EXPECT_EQ(problemOf("L1 1"), "character 2: a path begins with M or m");
    EXPECT_EQ(problemOf("M1 1 L2"), "character 8: a number is missing");
    EXPECT_EQ(problemOf("M1 1 X2 2"),
              "character 7: \"X\" is no command; allowed are M L H V C S Q T A Z");
    EXPECT_EQ(problemOf("M1 1Z2 2"), "character 6: a command is missing");
    EXPECT_EQ(problemOf("M0 0A1 1 0 2 0 1 1"), "character 12: an arc's flag must be 0 or 1");
    EXPECT_NE(problemOf("M1e300 0").find("larger than 1e9"), std::string::npos);
    EXPECT_NE(problemOf("Mnan 0").find("character"), std::string::npos);
    EXPECT_EQ(problemOf(""), "");
    EXPECT_THROW(readTransform("rotate(1"), std::runtime_error);
    EXPECT_THROW(readTransform("turn(1)"), std::runtime_error);
    EXPECT_THROW(readNumbers("1 2 x"), std::runtime_error);
}

TEST(PathData, HostilePathsAreBounded) {
    std::string many = "M0 0";
    for (int i = 0; i < 100'001; ++i) many += "h1";
    EXPECT_NE(problemOf(many).find("more than 100000 parts"), std::string::npos);
    // However fine: a curve has an end.
    EXPECT_LE(lines("M0 0 C0 1e9 1e9 1e9 1e9 0", 1e-12).size(), 65'537u);
}

}  // namespace
}  // namespace sulfurchamber
