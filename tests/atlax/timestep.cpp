#include <gtest/gtest.h>

#include <atlax/error.hpp>
#include <atlax/timestep.hpp>
#include <cstdint>

namespace {

using atlax::FixedTimestep;

constexpr std::int64_t second = 1'000'000'000;
constexpr std::int64_t day = 24 * 3600 * second;

/// Runs frames of irregular length until `end` and takes every tick.
void runUntil(FixedTimestep& step, std::int64_t end, std::int64_t frameNs) {
    std::int64_t now = 0;
    std::int64_t odd = 0;
    step.advance(0);
    while (now < end) {
        odd = (odd * 1103515245 + 12345) % 1000003;
        now = std::min(now + frameNs + odd, end);
        step.advance(now);
        while (step.takeTick()) {
        }
    }
}

class Rates : public testing::TestWithParam<int> {};

TEST_P(Rates, countExactlyOverDays) {
    FixedTimestep step(GetParam());
    // Frames of a fifth of a second and more keep this short; 10 kHz gets a tenth of the time.
    const std::int64_t span = GetParam() > 1000 ? day / 20 : 3 * day;
    runUntil(step, span, 200'000'000);
    EXPECT_EQ(step.ticks(), static_cast<std::uint64_t>(span / second * GetParam()));
    EXPECT_EQ(step.lostNs(), 0);
    EXPECT_DOUBLE_EQ(step.alpha(), 0);
}

INSTANTIATE_TEST_SUITE_P(Timestep, Rates, testing::Values(60, 144, 333, 500, 997, 10'000));

/// Frames of 1/7 s for a week, up to 10 kHz: not a single tick too many or too few.
TEST_P(Rates, doNotDriftOverAWeek) {
    FixedTimestep step(GetParam());
    atlax::FakeClock clock;
    step.advance(clock.now());
    constexpr std::int64_t frames = 7 * 24 * 3600 * std::int64_t{7};
    for (std::int64_t frame = 1; frame <= frames; ++frame) {
        clock.advance(frame * second / 7 - clock.now());
        step.advance(clock.now());
        step.takeTicks(2000);
    }
    EXPECT_EQ(step.ticks(), static_cast<std::uint64_t>(7 * day / second * GetParam()));
    EXPECT_EQ(step.due(), 0);
    EXPECT_EQ(step.alpha(), 0);
    EXPECT_EQ(step.lostNs(), 0);
}

/// Whatever is given up for a day, taken and lost time add up to the time that passed.
TEST_P(Rates, accountForAllTimeUnderOverload) {
    FixedTimestep step(GetParam());
    atlax::FakeClock clock;
    step.advance(clock.now());
    constexpr std::int64_t frameNs = 33'333'337;
    while (clock.now() < day) {
        clock.advance(frameNs);
        step.advance(clock.now());
        step.takeTicks(1);
        step.giveUp();
    }
    const double tickNs = 1e9 / GetParam();
    const double counted = static_cast<double>(step.ticks()) * tickNs + step.alpha() * tickNs +
                           static_cast<double>(step.lostNs());
    EXPECT_NEAR(counted, static_cast<double>(clock.now()), 2);
    EXPECT_GT(step.overload(), 0.4);
}

TEST(Timestep, ticksAreTakenInBulk) {
    FixedTimestep step(500);
    step.advance(0);
    step.advance(100'000'000);
    EXPECT_EQ(step.takeTicks(20), 20);
    EXPECT_EQ(step.takeTicks(-1), 0);
    EXPECT_EQ(step.takeTicks(1000), 30);
    EXPECT_EQ(step.ticks(), 50u);
    step.setPaused(true);
    step.singleTick();
    EXPECT_EQ(step.takeTicks(5), 1);
}

/// Overload in slow motion is told in real time.
TEST(Timestep, lostTimeIsRealTime) {
    FixedTimestep step(1000);
    step.setSpeedPermille(500);
    step.advance(0);
    step.advance(200'000'000);
    EXPECT_EQ(step.due(), 100);
    step.giveUp();
    EXPECT_EQ(step.lostNs(), 200'000'000);
}

TEST(Timestep, ticksCostNothingWhenFramesAreShorter) {
    FixedTimestep step(60);
    step.advance(0);
    step.advance(10'000'000);
    EXPECT_FALSE(step.takeTick());
    EXPECT_NEAR(step.alpha(), 0.6, 1e-12);
    step.advance(20'000'000);
    EXPECT_TRUE(step.takeTick());
    EXPECT_FALSE(step.takeTick());
    EXPECT_NEAR(step.alpha(), 0.2, 1e-12);
}

TEST(Timestep, firstCallOnlySetsTheStart) {
    FixedTimestep step(500);
    step.advance(123 * second);
    EXPECT_EQ(step.due(), 0);
    step.advance(123 * second + 2'000'000);
    EXPECT_EQ(step.due(), 1);
}

TEST(Timestep, timeThatGoesBackwardsCountsAsNone) {
    FixedTimestep step(500);
    step.advance(second);
    step.advance(second / 2);
    EXPECT_EQ(step.due(), 0);
    step.advance(second / 2 + 2'000'000);
    EXPECT_EQ(step.due(), 1);
}

TEST(Timestep, overloadSlowsTimeDownAndSaysByHowMuch) {
    FixedTimestep step(500);
    step.advance(0);
    // 100 ms frames hold 50 ticks, of which the program manages 30.
    for (int frame = 1; frame <= 50; ++frame) {
        step.advance(frame * (second / 10));
        for (int i = 0; i < 30; ++i) ASSERT_TRUE(step.takeTick());
        step.giveUp();
        EXPECT_EQ(step.due(), 0);
    }
    EXPECT_EQ(step.ticks(), 1500u);
    EXPECT_EQ(step.lostNs(), 2 * second);
    EXPECT_NEAR(step.overload(), 0.4, 0.05);
    // Once it keeps up again, the overload is gone.
    for (int frame = 51; frame <= 80; ++frame) {
        step.advance(frame * (second / 10));
        while (step.takeTick()) {
        }
    }
    EXPECT_EQ(step.overload(), 0);
    EXPECT_EQ(step.lostNs(), 2 * second);
}

TEST(Timestep, aSuspendedMachineLosesTimeInsteadOfCatchingUp) {
    FixedTimestep step(500);
    step.advance(0);
    step.advance(3600 * second);
    EXPECT_EQ(step.due(), FixedTimestep::maxAdvanceNs / 2'000'000);
    EXPECT_EQ(step.lostNs(), 3600 * second - FixedTimestep::maxAdvanceNs);
}

TEST(Timestep, pauseHoldsAndLosesNothing) {
    FixedTimestep step(500);
    step.advance(0);
    step.advance(3'000'000);
    EXPECT_TRUE(step.takeTick());
    const double alpha = step.alpha();
    step.setPaused(true);
    step.advance(100 * second);
    EXPECT_FALSE(step.takeTick());
    EXPECT_EQ(step.alpha(), alpha);
    EXPECT_EQ(step.lostNs(), 0);
    step.setPaused(false);
    step.advance(100 * second + 1'000'000);
    EXPECT_TRUE(step.takeTick());
    EXPECT_FALSE(step.takeTick());
}

TEST(Timestep, singleTicksInAPause) {
    FixedTimestep step(500);
    step.singleTick();
    EXPECT_FALSE(step.takeTick()) << "without a pause it does nothing";
    step.setPaused(true);
    step.singleTick();
    step.singleTick();
    EXPECT_EQ(step.due(), 2);
    EXPECT_TRUE(step.takeTick());
    EXPECT_TRUE(step.takeTick());
    EXPECT_FALSE(step.takeTick());
    step.singleTick();
    step.setPaused(false);
    EXPECT_FALSE(step.takeTick()) << "a change of the pause forgets them";
}

TEST(Timestep, slowMotionMakesFewerTicksOfTheSameLength) {
    FixedTimestep step(500);
    step.setSpeedPermille(250);
    runUntil(step, 3600 * second, 50'000'000);
    EXPECT_EQ(step.ticks(), 3600u * 125u);
    EXPECT_EQ(step.lostNs(), 0);
    EXPECT_DOUBLE_EQ(step.tickSeconds(), 0.002);
}

TEST(Timestep, rateMayChangeBetweenTicks) {
    FixedTimestep step(500);
    step.advance(0);
    step.advance(1'000'000);
    EXPECT_NEAR(step.alpha(), 0.5, 1e-12);
    step.setRateHz(1000);
    EXPECT_NEAR(step.alpha(), 0.5, 1e-12);
    step.advance(1'500'000);
    EXPECT_TRUE(step.takeTick());
    EXPECT_EQ(step.alpha(), 0);
}

TEST(Timestep, refusesRatesOutOfRange) {
    EXPECT_THROW(FixedTimestep(59), atlax::Error);
    EXPECT_THROW(FixedTimestep(10'001), atlax::Error);
    FixedTimestep step(60);
    EXPECT_THROW(step.setRateHz(0), atlax::Error);
    EXPECT_EQ(step.rateHz(), 60);
}

TEST(Timestep, extremesDoNotOverflow) {
    FixedTimestep step(10'000);
    step.setSpeedPermille(1'000'000);
    EXPECT_EQ(step.speedPermille(), 10'000);
    step.advance(0);
    step.advance(INT64_MAX / 2);
    EXPECT_EQ(step.due(), 25'000);
    step.giveUp();
    EXPECT_EQ(step.due(), 0);
}

}  // namespace
