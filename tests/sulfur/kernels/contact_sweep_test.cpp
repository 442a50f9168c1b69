#include "kernels/contact_sweep.hpp"

#include <cmath>

#include "helpers.hpp"

namespace sulfur {
namespace {

using detail::ContactBlock;
using detail::Mover;
using detail::SweepReal;

/// A particle of 1 kg that falls by 1 cm on a floor that is 4 mm below it, in one lane.
struct Falling {
    Falling() {
        movers[1] = {.x = SweepReal(0.002), .y = SweepReal(-0.01), .mass = 1};
        block.particle[lane] = 1;
        block.shareA[lane] = 1;
        block.normalY[lane] = 1;
        block.start[lane] = SweepReal(0.004);
        block.normalMass[lane] = block.tangentMass[lane] = 1;
    }

    static constexpr int lane = 3;
    Mover movers[2] = {};
    ContactBlock block = {};
};

class ContactSweep : public testing::TestWithParam<const detail::ContactKernels*> {};

TEST_P(ContactSweep, StopsAtTheSurface) {
    Falling f;
    GetParam()->solveTwo(f.movers, &f.block, 1);
    EXPECT_NEAR(f.movers[1].y, -0.004, 1e-9);
    EXPECT_NEAR(f.movers[1].x, 0.002, 1e-9) << "without friction";
    EXPECT_NEAR(f.block.normalLambda[f.lane], 0.006, 1e-9);
    EXPECT_EQ(f.movers[0].y, 0) << "the floor";
}

TEST_P(ContactSweep, SticksOrSlides) {
    Falling sticks;
    sticks.block.friction[sticks.lane] = 1;
    GetParam()->solveTwo(sticks.movers, &sticks.block, 1);
    EXPECT_NEAR(sticks.movers[1].x, 0, 1e-9);
    Falling slides;
    slides.block.friction[slides.lane] = SweepReal(0.1);
    GetParam()->solveTwo(slides.movers, &slides.block, 1);
    EXPECT_NEAR(slides.movers[1].x, 0.002 - 0.1 * 0.006, 1e-9);
}

TEST_P(ContactSweep, NeverPulls) {
    Falling f;
    f.movers[1].y = SweepReal(0.01);
    GetParam()->solveTwo(f.movers, &f.block, 1);
    EXPECT_EQ(f.block.normalLambda[f.lane], 0);
    EXPECT_EQ(f.movers[1].y, SweepReal(0.01));
}

TEST_P(ContactSweep, TurnsWhatIsPushedBesideItsCentre) {
    Falling f;
    f.movers[1].inertia = 6;
    f.block.armX[f.lane] = SweepReal(0.5);
    f.block.normalMass[f.lane] = SweepReal(1 / (1 + 6 * 0.25));
    GetParam()->solveTwo(f.movers, &f.block, 1);
    const double turn = 6 * 0.5 * static_cast<double>(f.block.normalLambda[f.lane]);
    EXPECT_NEAR(static_cast<double>(f.movers[1].turn), turn, 1e-8);
    EXPECT_NEAR(static_cast<double>(f.movers[1].sine), std::sin(turn), 1e-8);
    EXPECT_NEAR(static_cast<double>(f.movers[1].versine), 1 - std::cos(turn), 1e-8);
    const double gap = 0.004 + static_cast<double>(f.movers[1].y) + 0.5 * std::sin(turn);
    EXPECT_NEAR(gap, 0, 1e-6);
}

/// As what was led through others by metres gets in the sweeps that part them.
TEST_P(ContactSweep, HundredsOfLargeTurnsStayBounded) {
    Falling f;
    f.movers[1].inertia = 6;
    f.block.armX[f.lane] = SweepReal(0.5);
    f.block.normalLambda[f.lane] = 1;
    for (int i = 0; i < 500; ++i) GetParam()->warmTwo(f.movers, &f.block, 1);
    EXPECT_NEAR(static_cast<double>(f.movers[1].turn), 1500, 1e-3);
    EXPECT_LE(std::hypot(f.movers[1].sine, 1 - f.movers[1].versine), 1.001);
}

TEST_P(ContactSweep, SharesBetweenTheEndsOfACapsule) {
    Falling f;
    Mover movers[4] = {{}, f.movers[1], {.mass = 1}, {.mass = 1}};
    f.block.a[f.lane] = 2;
    f.block.b[f.lane] = 3;
    f.block.shareA[f.lane] = SweepReal(0.75);
    f.block.shareB[f.lane] = SweepReal(0.25);
    f.block.normalMass[f.lane] = SweepReal(1 / (1 + 0.75 * 0.75 + 0.25 * 0.25));
    GetParam()->solveThree(movers, &f.block, 1);
    const double of2 = static_cast<double>(movers[2].y), of3 = static_cast<double>(movers[3].y);
    EXPECT_NEAR(of2, 3 * of3, 1e-9);
    EXPECT_NEAR(static_cast<double>(movers[1].y) - 0.75 * of2 - 0.25 * of3, -0.004, 1e-8);
    const double momentum = static_cast<double>(movers[1].y) + of2 + of3;
    EXPECT_NEAR(momentum, -0.01, 1e-9);
}

TEST_P(ContactSweep, FindsErrors) {
    Falling f;
    const auto any = [&](double most) {
        return GetParam()->anyErrorTwo(f.movers, &f.block, 1, static_cast<SweepReal>(most));
    };
    EXPECT_TRUE(any(0.005));
    EXPECT_FALSE(any(0.007));
    GetParam()->solveTwo(f.movers, &f.block, 1);
    EXPECT_FALSE(any(1e-6));
    // What still pushes but should not is an error too.
    f.movers[1].y += SweepReal(0.001);
    EXPECT_TRUE(any(1e-4));
}

TEST_P(ContactSweep, FindsWhatIsTooDeep) {
    Falling f;
    const auto any = [&](double deepest) {
        f.block.deepest[f.lane] = static_cast<SweepReal>(deepest);
        return GetParam()->anyDeepTwo(f.movers, &f.block, 1);
    };
    EXPECT_TRUE(any(-0.005));
    EXPECT_FALSE(any(-0.007));
    GetParam()->solveTwo(f.movers, &f.block, 1);
    EXPECT_FALSE(any(-1e-6));
}

TEST_P(ContactSweep, LeadsApartWithoutChangingDisplacements) {
    Falling f;
    Mover shifts[2] = {{}, {.mass = 1}};
    f.block.wanted[f.lane] = SweepReal(1e-3);
    f.block.recovers = 1;
    GetParam()->recoverTwo(shifts, &f.block, 1);
    EXPECT_NEAR(shifts[1].y, 1e-3, 1e-9);
    f.block.wanted[f.lane] = SweepReal(-1e-3);
    f.block.recoveryLambda[f.lane] = 0;
    shifts[1].y = 0;
    GetParam()->recoverTwo(shifts, &f.block, 1);
    EXPECT_NEAR(shifts[1].y, -1e-3, 1e-9) << "closes what stands open";
}

const std::vector<const detail::ContactKernels*>& runnable() {
    static const std::vector<const detail::ContactKernels*> kernels = [] {
        std::vector<const detail::ContactKernels*> all{&detail::baselineContacts};
        if (&detail::contactKernels() != all[0]) all.push_back(&detail::contactKernels());
        return all;
    }();
    return kernels;
}
INSTANTIATE_TEST_SUITE_P(Kernels, ContactSweep, testing::ValuesIn(runnable()));

TEST(ContactSweepDispatch, BaselineGivesTheSameBits) {
    const auto play = [](bool baseline) {
        detail::useKernelsUpTo(baseline ? detail::Instructions::baseline
                                        : detail::widestInstructions());
        World world;
        world.add(shapes::ground({.points = {{-6, 6}, {-6, 0}, {6, 0}, {6, 6}}}));
        for (int i = 0; i < 40; ++i) {
            const Pose pose{{-4.5 + 1.2 * (i % 8), 1 + 1.3 * (i / 8)}, 0.3 * i};
            if (i % 3 == 0)
                world.add(shapes::jelly({.size = {1, 1}, .stiffness = Real(2e4)}), pose);
            else
                world.add(shapes::box({.size = {Real(0.9), Real(0.8)}}), pose);
        }
        test::run(world, 1);
        detail::useKernelsUpTo(detail::widestInstructions());
        return world.hash();
    };
    EXPECT_EQ(play(true), play(false));
}

}  // namespace
}  // namespace sulfur
