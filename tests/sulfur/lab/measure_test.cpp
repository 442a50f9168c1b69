// The instruments of the battery and its references, on motions that are known.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "battery/measure.hpp"
#include "battery/scenes.hpp"
#include "references/chain.hpp"

namespace {

using namespace sulfur;
using namespace sulfur::lab;

TEST(Row, PassesOnlyANumberWithinItsBound) {
    EXPECT_TRUE(atMost("", 1, 1).passed);
    EXPECT_FALSE(atMost("", 1.1, 1).passed);
    EXPECT_FALSE(atMost("", std::numeric_limits<double>::quiet_NaN(), 1).passed);
    EXPECT_TRUE(std::isnan(worst(1, std::numeric_limits<double>::quiet_NaN())));
    EXPECT_TRUE(std::isnan(worst(std::numeric_limits<double>::quiet_NaN(), 1)));
}

TEST(Crossings, MeanPeriodOfASine) {
    Crossings crossings;
    for (int i = 0; i < 5000; ++i) crossings.add(0.01 * i, std::sin(2.5 * 0.01 * i + 1));
    EXPECT_NEAR(crossings.period(), 2 * std::numbers::pi / 2.5, 1e-5);
    EXPECT_TRUE(std::isnan(Crossings().period()));
}

std::vector<double> decaying(double factor, double angle) {
    std::vector<double> samples;
    for (int n = 0; n < 60; ++n) samples.push_back(std::pow(factor, n) * std::cos(angle * n + 0.4));
    return samples;
}

TEST(Oscillation, FindsFactorAndAngle) {
    for (const double angle : {0.02, 1.0, 3.0}) {
        const auto found = fitOscillation(decaying(0.93, angle), 1e-9);
        ASSERT_TRUE(found.measured);
        EXPECT_NEAR(found.factor, 0.93, 1e-9);
        EXPECT_NEAR(found.angle, angle, 1e-9);
    }
}

TEST(Oscillation, SaysWhenThereIsNothingToSee) {
    EXPECT_FALSE(fitOscillation(std::vector<double>(50, 0.0), 1e-9).measured);
    EXPECT_FALSE(fitOscillation(decaying(0.5, 1), 10).measured);
}

TEST(Motion, OfASpinningBody) {
    World world(still({}, 0));
    const Body body = world.add(lattice({.columns = 2, .rows = 2, .cell = 2, .mass = 0.5}));
    spin(world, body, 3);
    const auto motion = motionOf(world, body.particles());
    EXPECT_NEAR(motion.angularMomentum, 2 * 2 * 3, 1e-5);  // m r^2 omega with r^2 = 2
    EXPECT_NEAR(motion.spinKinetic, 2 * 2 * 9 / 2.0, 1e-5);
    EXPECT_NEAR(motion.momentum.norm(), 0, 1e-6);
}

TEST(EnergyMeter, SeesNoneLostInAFreeFall) {
    World world(still({}, standardGravity));
    Blueprint stone = ghost("stone");
    stone.particles.push_back({});
    const Body body = world.add(stone);
    EnergyMeter meter;
    for (int i = 0; i < 500; ++i) {
        world.step();
        if (const auto energy = meter.add(world, body)) {
            ASSERT_NEAR(*energy, 0, 1e-3);
        }
    }
}

TEST(ChainReference, SwingsWithThePeriodOfTheEllipticIntegral) {
    ChainReference chain({{1}, {1}}, {{Vec(1, 0)}, {Vec(0, 0)}});
    Crossings crossings;
    for (int i = 0; i < 20000; ++i) {
        chain.step(1e-3);
        crossings.add(1e-3 * (i + 1), chain.state().x[0].x());
    }
    const double theory = 4 * std::comp_ellint_1(std::sin(std::numbers::pi / 4)) / std::sqrt(9.81);
    EXPECT_NEAR(crossings.period() / theory, 1, 1e-6);
}

TEST(ChainReference, KeepsLengthsAndEnergyOfARope) {
    ChainPlan plan{std::vector<double>(10, 0.1), std::vector<double>(10, 0.05)};
    plan.masses.back() = 5;
    State start;
    for (int i = 1; i <= 10; ++i) {
        start.x.emplace_back(0.1 * i, 0);
        start.v.emplace_back(0, 0);
    }
    ChainReference chain(plan, start);
    for (int i = 0; i < 50000; ++i) chain.step(1e-5);
    double energy = 0;
    for (std::size_t i = 0; i < 10; ++i) {
        const Vec before = i == 0 ? Vec(0, 0) : chain.state().x[i - 1];
        EXPECT_NEAR((chain.state().x[i] - before).norm(), 0.1, 1e-9);
        energy += plan.masses[i] *
                  (chain.state().v[i].squaredNorm() / 2 + plan.gravity * chain.state().x[i].y());
    }
    EXPECT_LT(chain.state().x.back().y(), -0.5);
    EXPECT_NEAR(energy, 0, 1e-7);
}

TEST(ChainReference, ConvergesAsPromised) {
    const ChainPlan plan{{1, 1}, {1, 1}};
    const State start{{Vec(1, 0), Vec(2, 0)}, {Vec(0, 0), Vec(0, 0)}};
    const auto path = convergedPath(plan, start, 0.1, 10, 1e-8);
    EXPECT_EQ(path.states.size(), 11u);
    EXPECT_LT(path.error, 1e-8);
    const auto finer = convergedPath(plan, start, 0.1, 10, 1e-11);
    EXPECT_LT((path.states.back().x[1] - finer.states.back().x[1]).norm(), 2e-8);
}

}  // namespace
