#include "core/trigonometry.hpp"

#include "helpers.hpp"

namespace sulfur {
namespace {

TEST(Trigonometry, AgreesWithTheLibraryWithinRounding) {
    for (int i = -20000; i <= 20000; ++i) {
        const double angle = i * 0.01137;
        const Point u = detail::unitVector(angle);
        EXPECT_NEAR(u[0], std::cos(angle), 4e-15) << angle;
        EXPECT_NEAR(u[1], std::sin(angle), 4e-15) << angle;
    }
}

TEST(Trigonometry, QuarterTurnsAreExact) {
    EXPECT_EQ(detail::unitVector(0), Point(1, 0));
    EXPECT_NEAR(detail::unitVector(detail::fullTurn / 4)[0], 0, 1e-16);
    EXPECT_EQ(detail::unitVector(detail::fullTurn / 4)[1], 1);
}

TEST(Trigonometry, AnglesAgreeWithTheLibraryWithinRounding) {
    for (int i = -20000; i <= 20000; ++i) {
        const double angle = i * (detail::fullTurn / 40000), size = std::pow(10, i % 100);
        const Point v(size * std::cos(angle), size * std::sin(angle));
        EXPECT_NEAR(detail::angleOf(v), std::atan2(v[1], v[0]), 1e-15) << angle;
    }
    EXPECT_EQ(detail::angleOf({3, 0}), 0);
    EXPECT_EQ(detail::angleOf({-3, 0}), detail::fullTurn / 2);
    EXPECT_EQ(detail::angleOf({0, -3}), -detail::fullTurn / 4);
}

TEST(Trigonometry, TurningBackUndoesTurning) {
    const Point heading = detail::unitVector(2.3), v(4, -7);
    EXPECT_LT((detail::turnedBack(heading, detail::turned(heading, v)) - v).norm(), 1e-14);
}

}  // namespace
}  // namespace sulfur
