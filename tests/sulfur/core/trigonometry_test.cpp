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

}  // namespace
}  // namespace sulfur
