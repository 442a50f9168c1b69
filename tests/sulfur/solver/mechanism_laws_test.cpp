// What springs, motors, friction and limits of a chain do at the end of a step, whoever pushes
// whom.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mechanism_ends.hpp"

namespace sulfur {
namespace {

using test::boxAt, test::fixedAt;

/// A chain of boxes in which nothing touches; each of its hinges has a drive of its own.
struct DrivenChain {
    std::vector<Body> boxes;
    std::vector<MechanismId> hinges;
};

enum class Drives { friction, limits, motors, springs, mixed };

Drive driveFor(Drives kind, test::Random& random) {
    if (kind == Drives::mixed) kind = Drives(random.below(4));
    Drive drive;
    const auto real = [&](double low, double high) {
        return static_cast<Real>(random.uniform(low, high));
    };
    // Friction that holds, that slips, and in between.
    drive.motorMax = static_cast<Real>(std::pow(10, random.uniform(-2, 1.5)));
    if (kind == Drives::motors || kind == Drives::springs) drive.motorSpeed = real(-8, 8);
    if (kind == Drives::limits) {
        drive.lower = real(-0.3, -0.01);
        drive.upper = real(0.01, 0.3);
    }
    if (kind == Drives::springs) {
        drive.stiffness = real(0.1, 50);
        drive.damping = real(0, 1);
        drive.rest = real(-1, 1);
    }
    return drive;
}

DrivenChain chainOf(World& world, Drives kind, test::Random& random) {
    DrivenChain chain;
    const std::size_t count = 2 + random.below(12);
    double x = 0;
    const Body nail = fixedAt(world, {0, 0});
    for (std::size_t i = 0; i < count; ++i) {
        const double length = random.uniform(0.4, 1);
        chain.boxes.push_back(boxAt(world, {x + length / 2, 0},
                                    {static_cast<Real>(length), Real(0.1)},
                                    static_cast<Real>(random.uniform(0.3, 3))));
        const Body& box = chain.boxes.back();
        world.setFilter(box, {.mask = 0});
        box.setSleepingAllowed(false);
        box.setVelocity({0, 0}, static_cast<Real>(random.uniform(-20, 20)));
        chain.hinges.push_back(world.hinge(i == 0 ? nail : chain.boxes[i - 1], box, {x, 0},
                                           {.drive = driveFor(kind, random)}));
        x += length;
    }
    return chain;
}

/// By how much hinges break their law, and what they do.
struct Verdict {
    double wrong = 0;   // N m, of motor and limits
    double beyond = 0;  // rad, of a limit
    double away = 0;    // rad, from a limit that pushes
    int slips = 0, sticks = 0, pushed = 0;

    void add(const Verdict& other) {
        wrong = std::max(wrong, other.wrong);
        beyond = std::max(beyond, other.beyond);
        away = std::max(away, other.away);
        slips += other.slips;
        sticks += other.sticks;
        pushed += other.pushed;
    }
};

/// `start`: its angle when the step of `h` seconds began.
Verdict verdictOn(const MechanismInfo& now, double start, double h) {
    constexpr double creep = 1e-3;  // rad/s, of what a motor holds
    const auto d = [](Real value) { return static_cast<double>(value); };
    const Drive& drive = now.drive;
    const double end = start + h * now.speed, slip = now.speed - d(drive.motorSpeed);
    const double spring =
        -d(drive.stiffness) * (end - d(drive.rest)) - d(drive.damping) * now.speed;
    const double given = d(now.force) - spring, most = d(drive.motorMax);
    // What was beyond a limit when the step began stays there.
    const double lower = std::min(d(drive.lower), start), upper = std::max(d(drive.upper), start);
    // A motor that slips gives all against that; limits only push back.
    const double least = (slip < -creep ? most : -most) - (now.atUpper ? d(infinite) : 0);
    const double largest = (slip > creep ? -most : most) + (now.atLower ? d(infinite) : 0);
    Verdict verdict;
    verdict.wrong = std::max({given - largest, least - given, 0.0});
    verdict.beyond = std::max({end - upper, lower - end, 0.0});
    verdict.away = std::max(now.atLower ? end - lower : 0, now.atUpper ? upper - end : 0);
    verdict.pushed = now.atLower || now.atUpper;
    verdict.slips = std::abs(slip) > creep;
    verdict.sticks = verdict.slips == 0 && verdict.pushed == 0;
    return verdict;
}

/// One step of a chain; `wrong` is there a share of the largest torque in it.
Verdict stepAndJudge(World& world, const DrivenChain& chain) {
    std::vector<double> start;
    for (const MechanismId hinge : chain.hinges) start.push_back(world.info(hinge).value);
    world.step();
    Verdict all;
    double largest = 0;
    for (std::size_t k = 0; k < start.size(); ++k) {
        const MechanismInfo now = world.info(chain.hinges[k]);
        all.add(verdictOn(now, start[k], static_cast<double>(world.tickDuration())));
        largest = std::max(largest, std::abs(static_cast<double>(now.force)));
    }
    all.wrong /= largest;
    return all;
}

class MechanismLaws : public testing::TestWithParam<Drives> {};

// Blows at the beginning bring many of a chain to their limits at once, so that what holds one of
// them depends on what holds the others.
TEST_P(MechanismLaws, HoldForEachHingeOfAChainAtTheEndOfAStep) {
    Verdict all;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        test::Random random(seed);
        World world;
        const DrivenChain chain = chainOf(world, GetParam(), random);
        for (int i = 0; i < 60; ++i) {
            const Verdict verdict = stepAndJudge(world, chain);
            ASSERT_LT(verdict.wrong, 1e-4) << "chain " << seed << ", step " << i;
            ASSERT_LT(verdict.beyond, 1e-5) << "chain " << seed << ", step " << i;
            ASSERT_LT(verdict.away, 1e-5) << "chain " << seed << ", step " << i;
            all.add(verdict);
        }
    }
    EXPECT_GT(all.slips, 1000);
    EXPECT_GT(all.sticks, 1000);
    const bool hasLimits = GetParam() == Drives::limits || GetParam() == Drives::mixed;
    EXPECT_EQ(all.pushed > 500, hasLimits) << all.pushed;
}

INSTANTIATE_TEST_SUITE_P(OfAll, MechanismLaws,
                         testing::Values(Drives::friction, Drives::limits, Drives::motors,
                                         Drives::springs, Drives::mixed));

/// Springs so weak that their compliance is no number leave motion as it is.
TEST(WeakSprings, OfAChainLeaveItAsItIs) {
    const auto spinAfter = [](Real stiffness) {
        World world({.gravity = Vec2(0, 0)});
        const Body nail = fixedAt(world, {0, 0});
        const Body inner = boxAt(world, {0.5, 0}, {1, Real(0.1)}, 1);
        const Body outer = boxAt(world, {1.5, 0}, {1, Real(0.1)}, 1);
        world.hinge(nail, inner, {0, 0}, {.drive = {.stiffness = stiffness}});
        world.hinge(inner, outer, {1, 0}, {.drive = {.stiffness = stiffness}});
        outer.setVelocity({0, 1}, 1);
        test::run(world, 1);
        return outer.angularVelocity();
    };
    const Real weakest = std::numeric_limits<Real>::denorm_min();
    EXPECT_EQ(spinAfter(weakest), spinAfter(0));
}

}  // namespace
}  // namespace sulfur
