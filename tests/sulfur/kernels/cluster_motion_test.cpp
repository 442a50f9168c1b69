// The kernels that turn rigid components give the bits of the plain functions, whatever
// instructions they use.
#include "kernels/cluster_motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <sulfur/sulfur.hpp>
#include <utility>

#include "core/trigonometry.hpp"
#include "helpers.hpp"
#include "model/clusters.hpp"

namespace sulfur {

namespace {

using detail::clusterBlock;
using Numbers = std::array<double, clusterBlock>;

std::uint64_t bitsOf(double value) {
    return std::bit_cast<std::uint64_t>(value);
}

/// Angles of all sizes and signs, borders between quarters and both zeros among them.
Numbers angles(int round) {
    Numbers list{0,    -0.0, 1e-300, -1e-9, 0.785398, -0.785399, 1.5707963267948966,
                 -3.2, 5,    1e4,    -7e4};
    test::Random random(static_cast<std::uint64_t>(round + 1));
    for (std::size_t k = 11; k < list.size(); ++k)
        list[k] = std::ldexp(static_cast<double>(random.bits() % 2001) / 1000 - 1,
                             static_cast<int>(random.bits() % 24) - 6);
    return list;
}

class ClusterMotion : public testing::TestWithParam<detail::Instructions> {
protected:
    void SetUp() override { detail::useKernelsUpTo(GetParam()); }
    void TearDown() override { detail::useKernelsUpTo(detail::Instructions::avx512); }
};

TEST_P(ClusterMotion, TurnsHeadingsAsUnitVectorDoes) {
    for (int round = 0; round < 200; ++round) {
        const Numbers angle = angles(round);
        Numbers x, y;
        for (std::size_t k = 0; k < clusterBlock; ++k) {
            const Point start = detail::unitVector(0.3 * static_cast<double>(k) - 4);
            x[k] = start[0];
            y[k] = start[1];
        }
        const Numbers oldX = x, oldY = y;
        detail::clusterKernels().turn(angle.data(), x.data(), y.data(), clusterBlock);
        for (std::size_t k = 0; k < clusterBlock; ++k) {
            Point expected(oldX[k], oldY[k]);
            if (angle[k] != 0)
                expected = detail::turned(detail::unitVector(angle[k]), expected).normalized();
            EXPECT_EQ(bitsOf(x[k]), bitsOf(expected[0])) << angle[k];
            EXPECT_EQ(bitsOf(y[k]), bitsOf(expected[1])) << angle[k];
        }
    }
}

TEST_P(ClusterMotion, GivesSinesAsUnitVectorDoes) {
    for (int round = 0; round < 200; ++round) {
        const Numbers half = angles(round);
        std::array<Real, clusterBlock> sine, versine;
        detail::clusterKernels().sines(half.data(), sine.data(), versine.data(), clusterBlock);
        for (std::size_t k = 0; k < clusterBlock; ++k) {
            const Point unit = detail::unitVector(half[k]);
            const Real expected = static_cast<Real>(2 * unit[0] * unit[1]);
            EXPECT_EQ(sine[k], expected) << half[k];
            EXPECT_EQ(std::signbit(sine[k]), std::signbit(expected)) << half[k];
            EXPECT_EQ(versine[k], static_cast<Real>(2 * unit[1] * unit[1])) << half[k];
        }
    }
}

/// Two triangles in one body whose particles come by turns, so that no members of one are
/// neighbours, and a third whose are.
Blueprint triangles() {
    Blueprint plan;
    for (int i = 0; i < 6; ++i) {
        const Point corner = detail::unitVector(2.1 * (i / 2));
        plan.particles.push_back({.position = corner.cast<Real>() + Vec2(Real(3 * (i % 2)), 0)});
    }
    for (int i = 0; i < 3; ++i)
        plan.particles.push_back(
            {.position = Vec2(6, 0) + detail::unitVector(2.1 * i).cast<Real>()});
    for (unsigned i = 0; i < 2; ++i)
        for (const auto& [a, b] : {std::pair(0u, 2u), std::pair(2u, 4u), std::pair(4u, 0u)})
            plan.joints.push_back({.a = a + i, .b = b + i});
    for (const auto& [a, b] : {std::pair(6u, 7u), std::pair(7u, 8u), std::pair(8u, 6u)})
        plan.joints.push_back({.a = a, .b = b});
    return plan;
}

/// More clusters than go in a block, spinning at many rates.
std::uint64_t hashAfterSpinning() {
    World world({.gravity = {0, 0}, .sleeping = false});
    for (int i = 0; i < 15; ++i) {
        const Body body = world.add(triangles(), {.position = {10.0 * i, 0}});
        world.setVelocity(body[0], Vec2(Real(i), Real(0.5)));
        world.setVelocity(body[3], Vec2(Real(-2 * i), 1));
        world.setVelocity(body[8], Vec2(Real(30 * i), 0));
    }
    for (int i = 0; i < 300; ++i) world.step();
    EXPECT_EQ(world.validate(), "");
    EXPECT_EQ(world.statistics().clusters, 45u);
    return world.hash();
}

TEST_P(ClusterMotion, SameBitsWithAnyInstructions) {
    const std::uint64_t hash = hashAfterSpinning();
    detail::useKernelsUpTo(detail::Instructions::baseline);
    EXPECT_EQ(hash, hashAfterSpinning());
}

INSTANTIATE_TEST_SUITE_P(Kernels, ClusterMotion,
                         testing::Values(detail::Instructions::baseline,
                                         detail::Instructions::avx512));

}  // namespace

}  // namespace sulfur
