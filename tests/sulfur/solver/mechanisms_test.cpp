// Hinges, sliders, wheels, welds, distances, pulleys and gears.
#include <array>
#include <cmath>
#include <vector>

#include "battery/random/momenta.hpp"
#include "mechanism_ends.hpp"

namespace sulfur {
namespace {

using test::boxAt, test::fixedAt;

constexpr double g = 9.81;

// --- drives ----------------------------------------------------------------------------------

TEST(Mechanisms, ALimitStopsADoorWithoutOvershoot) {
    for (const int rate : {60, 500, 2000}) {
        World world({.gravity = {0, 0}, .tickRate = rate});
        const Body door = boxAt(world, {0.5, 0});
        const MechanismId hinge =
            world.hinge(fixedAt(world, {0, 0}), door, {0, 0}, {.drive = {.lower = -1, .upper = 1}});
        door.setVelocity({0, 5}, 10);
        double most = 0;
        std::size_t reached = 0, left = 0;
        for (int i = 0; i < rate; ++i) {
            world.step();
            most = std::max(most, world.info(hinge).value);
            for (const LimitReached& event : world.events().limitsReached) {
                EXPECT_EQ(event.mechanism, hinge);
                EXPECT_TRUE(event.upper);
                ++reached;
            }
            left += world.events().limitsLeft.size();
        }
        EXPECT_NEAR(most, 1, 1e-4) << rate;
        EXPECT_LT(std::abs(world.info(hinge).speed), 0.01) << rate;
        EXPECT_EQ(reached, 1u) << rate;
        EXPECT_EQ(left, 1u) << rate;
    }
}

TEST(Mechanisms, AMotorTurnsALoadAsFastAsItIsToldTo) {
    for (const int rate : {60, 500}) {
        World world({.tickRate = rate});
        const Body arm = boxAt(world, {0.5, 0});
        const MechanismId hinge = world.hinge(fixedAt(world, {0, 0}), arm, {0, 0},
                                              {.drive = {.motorSpeed = 1, .motorMax = 100}});
        for (int i = 0; i < 3 * rate; ++i) {
            world.step();
            if (i < rate / 10) continue;
            const MechanismInfo info = world.info(hinge);
            ASSERT_NEAR(info.speed, 1, 1e-3) << rate << ' ' << i;
            // It bears the weight, where the step began.
            const double before =
                info.value - info.speed * static_cast<double>(world.tickDuration());
            ASSERT_NEAR(info.force, 0.5 * g * std::cos(before), 0.1) << rate << ' ' << i;
        }
    }
}

TEST(Mechanisms, AMotorGivesNoMoreThanItsLargestTorque) {
    World world({.gravity = {0, 0}});
    const Body arm = boxAt(world, {0.5, 0});
    const MechanismId hinge = world.hinge(fixedAt(world, {0, 0}), arm, {0, 0},
                                          {.drive = {.motorSpeed = 100, .motorMax = 2}});
    test::run(world, 0.2);
    const double inertia = static_cast<double>(arm.inertia()) + 0.25;  // Steiner
    EXPECT_NEAR(world.info(hinge).speed, 0.2 * 2 / inertia, 0.01 * 0.4 / inertia);
    EXPECT_NEAR(world.info(hinge).force, 2, 1e-6);
}

TEST(Mechanisms, AMotorGoesToItsTargetAndStays) {
    World world;
    const Body arm = boxAt(world, {0.5, 0});
    const MechanismId hinge =
        world.hinge(fixedAt(world, {0, 0}), arm, {0, 0},
                    {.drive = {.motorSpeed = 2, .motorMax = 50, .motorTarget = Real(1.2)}});
    test::run(world, 0.5);
    EXPECT_NEAR(world.info(hinge).value, 1, 0.02);
    test::run(world, 2);
    EXPECT_NEAR(world.info(hinge).value, 1.2, 1e-4);
    EXPECT_NEAR(world.info(hinge).force, 0.5 * g * std::cos(1.2), 0.01);
    EXPECT_TRUE(arm.mass() > 0 && world.asleep(arm));
}

TEST(Mechanisms, ASpringSwingsAtItsFrequency) {
    World world({.gravity = {0, 0}});
    const Body arm = boxAt(world, {0.5, 0});
    const double inertia = static_cast<double>(arm.inertia()) + 0.25;
    const MechanismId hinge = world.hinge(fixedAt(world, {0, 0}), arm, {0, 0},
                                          {.drive = {.stiffness = Real(40 * inertia)}});
    arm.setVelocity({0, 0.05}, 0.1);
    int turns = 0;
    double before = 0, last = 0;
    for (int i = 0; i < 1500; ++i) {
        world.step();
        const double value = world.info(hinge).value;
        if (before < 0 && value >= 0) {
            ++turns;
            last = world.time();
        }
        before = value;
    }
    ASSERT_EQ(turns, 3);
    EXPECT_NEAR(last / 3, 2 * 3.14159265 / std::sqrt(40), 0.01);
}

TEST(Mechanisms, WhatIsTooMuchBreaksADriveOrAPin) {
    for (const bool pin : {false, true}) {
        World world;
        const Body arm = boxAt(world, {0.5, 0});
        HingeOptions options;
        options.drive.lower = 0;
        (pin ? options.strength : options.drive.strength) = Real(pin ? 11 : 5.5);
        const MechanismId hinge = world.hinge(fixedAt(world, {0, 0}), arm, {0, 0}, options);
        test::run(world, 0.5);
        ASSERT_TRUE(world.contains(hinge));  // it bears 9.81 N, or 4.9 N m
        arm.applyImpulse({0, -1}, arm.centreOfMass());
        std::size_t broken = 0;
        for (int i = 0; i < 10; ++i) {
            world.step();
            for (const MechanismBroken& event : world.events().mechanismsBroken) {
                EXPECT_EQ(event.mechanism, hinge);
                EXPECT_GT(event.force, 5.5);
                ++broken;
            }
        }
        EXPECT_EQ(broken, 1u);
        EXPECT_FALSE(world.contains(hinge));
        EXPECT_TRUE(world.attachments().empty());
    }
}

// --- kinds -----------------------------------------------------------------------------------

TEST(Mechanisms, HingesBetweenParticlesHoldByPins) {
    World world;
    std::vector<Body> planks;
    const Body bank = fixedAt(world, {-0.5, 0});
    for (int i = 0; i < 20; ++i)
        planks.push_back(boxAt(world, {double(i), 0}, {Real(0.98), Real(0.2)}));
    world.hinge(bank, planks[0], {-0.5, 0});
    for (int i = 1; i < 20; ++i) world.hinge(planks[i - 1], planks[i], {i - 0.5, 0});
    const double energy = world.energy();
    for (int i = 0; i < 1500; ++i) {
        world.step();
        ASSERT_LT(world.energy(), energy + 0.5);
        for (int k = 1; k < 20; ++k) {
            const auto end = [&](const Body& body, double x) {
                const Pose pose = body.pose();
                return Point(pose.position + x * Point(std::cos(pose.angle), std::sin(pose.angle)));
            };
            ASSERT_LT((end(planks[k - 1], 0.5) - end(planks[k], -0.5)).norm(), 1e-5) << i;
        }
    }
}

TEST(Mechanisms, AWeldedCantileverBearsItsWeight) {
    for (const int rate : {60, 500}) {
        World world({.tickRate = rate});
        const Body bank = fixedAt(world, {-0.5, 0});
        std::vector<Body> parts;
        std::vector<MechanismId> welds;
        for (int i = 0; i < 8; ++i)
            parts.push_back(boxAt(world, {double(i), 0}, {Real(0.98), Real(0.2)}));
        welds.push_back(world.weld(bank, parts[0], {-0.5, 0}));
        for (int i = 1; i < 8; ++i)
            welds.push_back(world.weld(parts[i - 1], parts[i], {i - 0.5, 0}));
        for (int i = 0; i < rate; ++i) {
            world.step();
            ASSERT_NEAR(parts[7].centreOfMass().y(), 0, 1e-5) << rate << ' ' << i;
        }
        for (int i = 0; i < 8; ++i)  // what is beyond it, half as far away, with its pins
            EXPECT_NEAR(world.info(welds[i]).force, g * (8 - i) * (8 - i) / 2.0, 0.5) << i;
        EXPECT_TRUE(world.asleep(parts[0]));
    }
}

TEST(Mechanisms, ASliderStaysOnItsLineAndKeepsItsAngle) {
    World world;
    const Body rail = boxAt(world, {0, 0}, {4, Real(0.2)}, 10);
    rail.setPose({.position = {0, 0}, .angle = 0.5});
    world.setPinned(rail[0], true);
    world.setPinned(rail[1], true);
    const Point along(std::cos(0.5), std::sin(0.5)), start(0, 1);
    const Body bead = boxAt(world, start, {Real(0.3), Real(0.3)});
    const MechanismId slider =
        world.slider(rail, bead, start, along.cast<Real>(), {.turns = false});
    test::run(world, 0.5);
    const Point way = bead.centreOfMass() - start;
    EXPECT_NEAR(way.norm(), 0.5 * g * std::sin(0.5) * 0.25, 0.01);
    EXPECT_NEAR(way.x() * along.y() - way.y() * along.x(), 0, 1e-5);
    EXPECT_NEAR(bead.angle(), 0, 1e-5);
    EXPECT_NEAR(world.info(slider).value, way.dot(along), 1e-5);
    EXPECT_NEAR(static_cast<double>(world.info(slider).holding.norm()), g * std::cos(0.5), 0.05);
}

TEST(Mechanisms, AWheelDrivesItsCarAtTheSpeedOfItsMotor) {
    World world;
    world.add(shapes::floor({-5, 0}, {50, 0}));
    const Body car = boxAt(world, {0, 0.9}, {2, Real(0.5)}, 300);
    std::vector<WheelIds> wheels;
    for (const double x : {-0.8, 0.8}) {
        const Body wheel =
            world.add(shapes::ball({.radius = Real(0.35), .mass = 20}), {.position = {x, 0.35}});
        wheels.push_back(world.wheel(car, wheel, {x, 0.35}, {0, 1},
                                     {.spring = {.lower = Real(-0.3),
                                                 .upper = Real(0.3),
                                                 .stiffness = 15000,
                                                 .damping = 2000},
                                      .motor = {.motorSpeed = -10, .motorMax = 200}}));
    }
    test::run(world, 6);
    EXPECT_NEAR(car.meanVelocity().x(), 3.5, 0.01);
    for (const WheelIds& wheel : wheels) {
        EXPECT_NEAR(world.info(wheel.motor).speed, -10, 0.02);
        EXPECT_NEAR(world.info(wheel.spring).value, 150 * g / 15000, 2e-3);
    }
}

TEST(Mechanisms, ARopeOnlyPullsAndAWinchShortensIt) {
    World world;
    const Body beam = world.add(shapes::floor({-2, 3}, {2, 3}));
    const Body load = boxAt(world, {0, 0}, {Real(0.3), Real(0.3)}, 2);
    const MechanismId winch = world.distance(
        beam, {0, 3}, load, {0, 0.15}, {.drive = {.motorSpeed = Real(-0.5), .motorMax = 100}});
    test::run(world, 2);
    EXPECT_NEAR(world.info(winch).value, 1.85, 0.005);
    EXPECT_NEAR(world.info(winch).force, -2 * g, 1e-3);
    world.setDrive(winch, {.upper = 2});
    load.setVelocity({0, 1});
    test::run(world, 0.1);
    EXPECT_EQ(world.info(winch).force, 0);  // it is slack
    test::run(world, 6);
    EXPECT_NEAR(world.info(winch).value, 2, 1e-5);
    EXPECT_TRUE(world.info(winch).atUpper);
    EXPECT_TRUE(world.asleep(load));
}

TEST(Mechanisms, APulleyIsAtwoodsMachine) {
    for (const Real ratio : {Real(1), Real(2)}) {
        World world;
        const Body beam = world.add(shapes::floor({-2, 3}, {2, 3}));
        const Body light = boxAt(world, {-1, 0}, {Real(0.3), Real(0.3)}, 1),
                   heavy = boxAt(world, {1, 0}, {Real(0.3), Real(0.3)}, 3);
        const MechanismId rope = world.pulley(light, {-1, 0.15}, {-1, 3}, heavy, {1, 0.15}, {1, 3},
                                              beam, {.ratio = ratio});
        test::run(world, 0.5);
        // The light one rises by `ratio` times what the heavy one falls; its tension is T, that of
        // the other side ratio T.
        const double r = static_cast<double>(ratio), rise = g * r * (3 - r) / (3 + r * r);
        EXPECT_NEAR(light.meanVelocity().y(), rise * 0.499, 0.002);
        EXPECT_NEAR(world.info(rope).force, -(g + rise), 0.01);
        EXPECT_NEAR(world.info(rope).value, 2.85 * (1 + r), 1e-5);
    }
}

TEST(Mechanisms, GearsKeepTheirRatioForAThousandTurns) {
    World world({.gravity = {0, 0}});
    const Body first = world.add(shapes::ball({.radius = 1}), {.position = {0, 0}}),
               second = world.add(shapes::ball({.radius = Real(0.5)}), {.position = {3, 0}});
    const MechanismId motor = world.hinge(fixedAt(world, {0, 0}), first, {0, 0},
                                          {.drive = {.motorSpeed = 60, .motorMax = 500}}),
                      driven = world.hinge(fixedAt(world, {3, 0}), second, {3, 0});
    const MechanismId gear = world.gear(motor, driven, Real(0.5));
    while (world.info(motor).value < 1000 * 6.2831853) world.step();
    EXPECT_NEAR(world.info(motor).value + 0.5 * world.info(driven).value, 0, 1e-6);
    EXPECT_NEAR(world.info(driven).speed, -120, 1e-3);
    EXPECT_NEAR(world.info(gear).value, 0, 1e-6);
}

TEST(Mechanisms, ALoopOfHingesTurnsWithItsMotor) {
    World world;
    const Body frame = world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body crank = boxAt(world, {0, 1.25}, {Real(0.1), Real(0.5)}, Real(0.5)),
               rod = boxAt(world, {1, 1.5}, {2, Real(0.1)}),
               rocker = boxAt(world, {2, 0.5}, {Real(0.1), 2});
    for (const Body& body : {crank, rod, rocker}) world.setFilter(body, {.mask = 0});
    const MechanismId motor =
        world.hinge(frame, crank, {0, 1}, {.drive = {.motorSpeed = 5, .motorMax = 200}});
    world.hinge(crank, rod, {0, 1.5});
    world.hinge(rod, rocker, {2, 1.5});
    world.hinge(frame, rocker, {2, -0.5});
    for (int i = 0; i < 3000; ++i) {
        world.step();
        if (i < 500) continue;
        ASSERT_NEAR(world.info(motor).speed, 5, 0.02) << i;
    }
}

// --- laws ------------------------------------------------------------------------------------

TEST(Mechanisms, KeepBothMomentaOfWhatNothingElseHolds) {
    for (const int rate : {60, 500}) {
        World world({.gravity = {0, 0}, .tickRate = rate});
        const Body a = boxAt(world, {0, 0}), b = boxAt(world, {1, 0}, {1, Real(0.2)}, 2),
                   c = boxAt(world, {2, 0});
        world.hinge(a, b, {0.5, 0},
                    {.drive = {.lower = -1, .upper = 1, .motorSpeed = 10, .motorMax = 5}});
        world.hinge(b, c, {1.5, 0}, {.drive = {.stiffness = 50, .damping = Real(0.1)}});
        a.setVelocity({1, 1}, 5);
        const lab::Momenta before = lab::momentaOf(world, {0, 0});
        test::run(world, 5);
        const lab::Momenta after = lab::momentaOf(world, {0, 0});
        EXPECT_NEAR((after.linear.sum - before.linear.sum).norm(), 0, 1e-5) << rate;
        EXPECT_NEAR(after.angular, before.angular, 1e-4) << rate;
    }
}

TEST(Mechanisms, ASpringMakesNoEnergy) {
    for (const int rate : {60, 500}) {
        World world({.gravity = {0, 0}, .tickRate = rate});
        const Body a = boxAt(world, {0, 0}), b = boxAt(world, {1, 0});
        world.hinge(a, b, {0.5, 0}, {.drive = {.stiffness = 300}});
        a.setVelocity({0, 0}, 5);
        const double before = world.energy();
        for (int i = 0; i < 5 * rate; ++i) {
            world.step();
            ASSERT_LT(world.energy(), 1.001 * before) << rate << ' ' << i;
        }
    }
}

TEST(Mechanisms, LimitsHoldUnderBlows) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body upper = boxAt(world, {0, 2}, {Real(0.6), Real(0.1)}),
               lower = boxAt(world, {0.6, 2}, {Real(0.6), Real(0.1)});
    const MechanismId knee =
        world.hinge(upper, lower, {0.3, 2}, {.drive = {.lower = Real(-0.2), .upper = Real(0.2)}});
    upper.setVelocity({1, -3}, 2);
    lower.setVelocity({1, -3}, 2);
    for (int i = 0; i < 2000; ++i) {
        world.step();
        ASSERT_LT(std::abs(world.info(knee).value), 0.22) << i;
    }
}

TEST(Mechanisms, AWeldInVainThrowsNobody) {
    for (const double beside : {0.5, 1.0}) {
        World world;
        world.add(shapes::floor({-5, 0}, {5, 0}));
        const Body crate = boxAt(world, {0, 0.49}, {1, 1});  // a centimetre in the floor
        world.weld(fixedAt(world, {-beside, 0.5}), crate, {-beside, 0.5});
        for (int i = 0; i < 1000; ++i) {
            world.step();
            ASSERT_LT(static_cast<double>(crate.meanVelocity().norm()), 0.5) << beside << ' ' << i;
        }
    }
}

TEST(Mechanisms, EnergyKnowsTheSpringsOfDrives) {
    World world({.gravity = {0, 0}});
    const Body a = boxAt(world, {0, 0}), b = boxAt(world, {0, 2});
    world.distance(a, {0, 0}, b, {0, 2}, {.drive = {.stiffness = 50, .rest = 1}});
    EXPECT_NEAR(world.energy(), 25, 1e-4);
    test::run(world, 0.2);
    EXPECT_LT(world.energy(), 25.01);
    EXPECT_GT(world.energy(), 23);
}

TEST(Mechanisms, AMotorAgainstALimitBreaksIt) {
    World world({.gravity = {0, 0}});
    const Body arm = boxAt(world, {0.5, 0});
    const MechanismId hinge =
        world.hinge(fixedAt(world, {0, 0}), arm, {0, 0},
                    {.drive = {.upper = Real(0.2), .motorSpeed = 1, .motorMax = 4, .strength = 3}});
    test::run(world, 0.5);
    EXPECT_FALSE(world.contains(hinge));
}

// What it gave in the last step is a blow with which the next one begins.
TEST(Mechanisms, AMotorThatIsTakenAwayGivesNothingAnyMore) {
    for (const Drive& drive : {Drive{.motorSpeed = 100, .motorMax = 2},
                               Drive{.stiffness = 5, .damping = 1, .rest = 2}}) {
        World world({.gravity = {0, 0}});
        const Body arm = boxAt(world, {0.5, 0});
        const MechanismId hinge =
            world.hinge(fixedAt(world, {0, 0}), arm, {0, 0}, {.drive = drive});
        test::run(world, 0.05);
        const double speed = world.info(hinge).speed;
        ASSERT_GT(speed, 0.1);
        world.setDrive(hinge, {});
        test::run(world, 0.1);
        EXPECT_NEAR(world.info(hinge).speed, speed, 1e-4);
        EXPECT_EQ(world.info(hinge).force, 0);
    }
}

TEST(Mechanisms, ALimitThatIsTakenAwayBearsNothingAnyMore) {
    World world;
    const Body arm = boxAt(world, {0.5, 0});
    const MechanismId hinge =
        world.hinge(fixedAt(world, {0, 0}), arm, {0, 0}, {.drive = {.lower = 0}});
    test::run(world, 0.2);
    ASSERT_NEAR(world.info(hinge).force, 0.5 * g, 0.01);
    world.setDrive(hinge, {});
    world.step();
    const double inertia = static_cast<double>(arm.inertia()) + 0.25;
    const double fall = 0.5 * g / inertia * static_cast<double>(world.tickDuration());
    EXPECT_NEAR(world.info(hinge).speed, -fall, 0.1 * fall);
}

}  // namespace
}  // namespace sulfur
