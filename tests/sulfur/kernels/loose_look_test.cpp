// The kernels that look from a corner see what plain functions see, and give the same bits whatever
// instructions they use.
#include "kernels/loose_look.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sulfur/sulfur.hpp>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

using detail::CornerLanes;
using detail::CornerWay;
using detail::Instructions;
using detail::mostOfChunk;

constexpr Real nothing = detail::lookedAway;

CornerWay somewhere(test::Random& random, double speed) {
    const auto in = [&](double most) { return static_cast<Real>(random.uniform(-most, most)); };
    return {in(1), in(1), in(speed), in(speed)};
}
void put(CornerLanes& lanes, std::size_t k, const CornerWay& c) {
    lanes.x[k] = c.x;
    lanes.y[k] = c.y;
    lanes.wayX[k] = c.wayX;
    lanes.wayY[k] = c.wayY;
}

struct Crowd {
    explicit Crowd(test::Random& random) : spokes(3) {
        corner = somewhere(random, 0.1);
        sides.count = corners.count = 1 + static_cast<std::uint32_t>(random.below(mostOfChunk));
        may = static_cast<std::uint32_t>(random.below(1u << 31));
        may &= static_cast<std::uint32_t>((std::uint64_t{1} << sides.count) - 1);
        for (std::size_t k = 0; k < sides.count; ++k) {
            const CornerWay a = somewhere(random, 0.1);
            put(sides.a, k, a);
            // Some sides have no length.
            put(sides.b, k, random.below(8) == 0 ? a : somewhere(random, 0.1));
            sides.radius[k] = corners.radius[k] = static_cast<Real>(random.uniform(0.01, 0.3));
            sides.outward[k] = static_cast<Real>(random.below(3)) - 1;
            put(corners.at, k, a);
            for (CornerLanes& s : spokes)
                put(s, k, random.below(4) == 0 ? a : somewhere(random, 0));
        }
        corners.spokes = spokes.data();
        corners.mostSpokes = 3;
    }

    double distanceFrom(std::size_t k) const {
        const Point a(double(sides.a.x[k]), double(sides.a.y[k]));
        const Point along = Point(double(sides.b.x[k]), double(sides.b.y[k])) - a;
        const Point from = Point(double(corner.x), double(corner.y)) - a;
        const double t = std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0);
        return (from - t * along).norm();
    }
    bool counts(std::size_t k) const {
        const bool sized = sides.a.x[k] != sides.b.x[k] || sides.a.y[k] != sides.b.y[k];
        return sized && (may >> k & 1) != 0;
    }

    CornerWay corner;
    detail::SideLanes sides;
    std::vector<CornerLanes> spokes;
    detail::SpokedCorners corners;
    std::uint32_t may = 0;
};

class LooseLookKernels : public testing::TestWithParam<Instructions> {
protected:
    void SetUp() override { detail::useKernelsUpTo(GetParam()); }
    void TearDown() override { detail::useKernelsUpTo(Instructions::avx512); }
};

TEST_P(LooseLookKernels, SeeTheNearestSideAndTheGap) {
    test::Random random(3);
    for (int round = 0; round < 300; ++round) {
        const Crowd crowd(random);
        const Real radius = Real(0.1);
        detail::SidesSeen seen;
        detail::lookKernels().sides(crowd.corner, radius, crowd.sides, crowd.may, seen);
        double least = 1e9, gap = double(nothing);
        for (std::size_t k = 0; k < crowd.sides.count; ++k) {
            if (!crowd.counts(k)) continue;
            const double far = crowd.distanceFrom(k);
            least = std::min(least, far);
            gap = std::min(gap, far - double(radius) - double(crowd.sides.radius[k]));
        }
        EXPECT_NEAR(double(seen.gap), gap, 1e-5 * std::max(1.0, std::abs(gap)));
        if (least > 1e8) {
            EXPECT_EQ(seen.nearest, mostOfChunk);
        } else {
            ASSERT_LT(seen.nearest, crowd.sides.count);
            EXPECT_NEAR(crowd.distanceFrom(seen.nearest), least, 1e-5);
            EXPECT_GE(seen.spare, seen.gap);
        }
        for (std::size_t k = 0; k < crowd.sides.count; ++k)
            EXPECT_TRUE(crowd.counts(k) || (seen.before >> k & 1) == 0);
    }
}

/// A corner a tenth above a side of one metre, at a share of its length.
detail::SidesSeen seenAbove(Real share) {
    detail::SideLanes side;
    side.count = 1;
    put(side.a, 0, {0, 0, 0, 0});
    put(side.b, 0, {1, 0, 0, 0});
    side.radius[0] = Real(0.1);
    side.outward[0] = -1;  // to the left of the way from a to b
    detail::SidesSeen seen;
    detail::lookKernels().sides({share, Real(0.25), 0, Real(-0.1)}, Real(0.1), side, 1, seen);
    return seen;
}

TEST_P(LooseLookKernels, TellWhatIsBeforeASideFromWhatIsBeside) {
    const auto before = seenAbove(Real(0.5)), beside = seenAbove(Real(1.2));
    EXPECT_EQ(before.before, 1u);
    EXPECT_NEAR(double(before.height[0]), 0.25, 1e-6);
    EXPECT_NEAR(double(before.gap), 0.05, 1e-6);
    EXPECT_EQ(before.enter, nothing);
    EXPECT_EQ(beside.before, 0u);
    EXPECT_NEAR(double(beside.enter), 0.2, 1e-4);
}

TEST_P(LooseLookKernels, TellWhatIsBeforeACornerFromWhatIsBeforeItsCapsules) {
    detail::SpokedCorners own, other;
    std::vector<CornerLanes> ownSpokes(1), otherSpokes(1);
    own.count = other.count = 1;
    own.mostSpokes = other.mostSpokes = 1;
    own.radius[0] = other.radius[0] = Real(0.1);
    put(other.at, 0, {Real(0.25), 0, 0, 0});
    put(otherSpokes[0], 0, {2, 0, 0, 0});  // leads away
    own.spokes = ownSpokes.data();
    other.spokes = otherSpokes.data();
    for (const Real end : {Real(-1), Real(1)}) {
        put(ownSpokes[0], 0, {end, 0, 0, 0});
        detail::CornersSeen seen;
        detail::lookKernels().corners(own, 0, other, 1, seen);
        EXPECT_EQ(seen.near, 1u);
        EXPECT_EQ(seen.before, end < 0 ? 1u : 0u);
        EXPECT_NEAR(double(seen.gap), 0.05, 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, LooseLookKernels,
                         testing::Values(Instructions::baseline, Instructions::avx512));

TEST(LooseLooksInLanes, SameBitsWithAnyInstructions) {
    test::Random random(5);
    for (int round = 0; round < 300; ++round) {
        const Crowd crowd(random);
        std::vector<detail::SidesSeen> sides(2);
        std::vector<detail::CornersSeen> corners(2);
        for (const std::size_t i : {0u, 1u}) {
            detail::useKernelsUpTo(i == 0 ? Instructions::baseline : Instructions::avx512);
            detail::lookKernels().sides(crowd.corner, Real(0.1), crowd.sides, crowd.may, sides[i]);
            detail::lookKernels().corners(crowd.corners, 0, crowd.corners, crowd.may, corners[i]);
        }
        EXPECT_EQ(sides[0].gap, sides[1].gap);
        EXPECT_EQ(sides[0].spare, sides[1].spare);
        EXPECT_EQ(sides[0].enter, sides[1].enter);
        EXPECT_EQ(sides[0].nearest, sides[1].nearest);
        EXPECT_EQ(sides[0].before, sides[1].before);
        EXPECT_EQ(corners[0].gap, corners[1].gap);
        EXPECT_EQ(corners[0].spare, corners[1].spare);
        EXPECT_EQ(corners[0].near, corners[1].near);
        EXPECT_EQ(corners[0].before, corners[1].before);
        for (std::size_t k = 0; k < crowd.sides.count; ++k) {
            if (crowd.counts(k)) {
                EXPECT_EQ(sides[0].far[k], sides[1].far[k]);
                EXPECT_EQ(sides[0].height[k], sides[1].height[k]);
                EXPECT_EQ(sides[0].outward[k], sides[1].outward[k]);
            }
            EXPECT_TRUE((corners[0].near >> k & 1) == 0 ||
                        corners[0].enter[k] == corners[1].enter[k]);
        }
    }
}

}  // namespace
}  // namespace sulfur
