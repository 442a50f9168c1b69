// Sliders on a rail: along arcs, along ropes, from link to link.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "battery/random/momenta.hpp"
#include "mechanism_ends.hpp"

namespace sulfur {
namespace {

constexpr double earth = 9.81, pi = 3.14159265358979;

/// Arcs of a circle of the radius 1 about the origin, or their chords, from one angle to another.
Blueprint arcs(double first, double last, int count, bool bent = true) {
    Blueprint plan{.kind = BodyKind::fixed};
    const bool closed = std::abs(last - first) > 2 * pi - 1e-9;
    const double step = (last - first) / count;
    for (int i = 0; i < count + (closed ? 0 : 1); ++i)
        plan.particles.push_back(
            {.position = {Real(std::cos(first + i * step)), Real(std::sin(first + i * step))}});
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i)
        plan.joints.push_back({.a = i,
                               .b = static_cast<std::uint32_t>((i + 1) % plan.particles.size()),
                               .radius = Real(0.01),
                               .bend = bent ? Real(step) : 0});
    return plan;
}
Blueprint hoop(int count, bool bent = true) {
    return arcs(-pi / 2, 1.5 * pi, count, bent);
}
/// Straight links through points.
Blueprint line(const std::vector<Vec2>& points, BodyKind kind = BodyKind::fixed) {
    Blueprint plan{.kind = kind};
    for (const Vec2& point : points) plan.particles.push_back({.position = point});
    for (std::uint32_t i = 0; i + 1 < points.size(); ++i)
        plan.joints.push_back({.a = i, .b = i + 1});
    return plan;
}
Body beadAt(World& world, const Point& at, Real mass = 1) {
    return world.add({.particles = {{.mass = mass}}}, {.position = at});
}
Point onCircle(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

// --- arcs ------------------------------------------------------------------------------------

TEST(Rails, ABeadOnAHoopOfArcsSwingsAsAPendulum) {
    for (const int count : {2, 3, 8}) {
        World world;
        const Body ring = world.add(hoop(count));
        const double amplitude = 0.2;
        const Body bead = beadAt(world, onCircle(-pi / 2 + amplitude));
        const MechanismId slider = world.slider(ring, bead, bead.centreOfMass(), ring.joints());
        int swings = 0;
        double last = 0, before = bead.centreOfMass().x();
        while (swings < 4 && world.time() < 20) {
            world.step();
            const double now = bead.centreOfMass().x();
            ASSERT_NEAR(bead.centreOfMass().norm(), 1, 1e-6) << count;
            if (before < 0 && now >= 0) {
                ++swings;
                last =
                    world.time() - static_cast<double>(world.tickDuration()) * now / (now - before);
            }
            before = now;
        }
        // Its first passage comes after three quarters of a period.
        const double period = last / 3.75, square = amplitude * amplitude;
        const double theory =
            2 * pi / std::sqrt(earth) * (1 + square / 16 + 11 * square * square / 3072);
        EXPECT_NEAR(period, theory, 1e-3 * theory) << count;
        EXPECT_EQ(world.info(slider).rail.size(), static_cast<std::size_t>(count));
    }
}

TEST(Rails, ABeadGoesRoundAHoopAndKeepsItsEnergy) {
    for (const int rate : {120, 500}) {
        World world({.tickRate = rate});
        const Body ring = world.add(hoop(4));
        const Body bead = beadAt(world, {0, -1});
        const MechanismId slider = world.slider(ring, bead, {0, -1}, ring.joints());
        bead.setVelocity({8, 0});
        world.step();
        const double energy = world.energy();
        test::run(world, 10);
        const MechanismInfo info = world.info(slider);
        EXPECT_GT(info.value, 4 * 2 * pi) << "it counts whole rounds";
        EXPECT_NEAR(
            std::remainder(info.value - (std::atan2(info.pointB.y(), info.pointB.x()) + pi / 2),
                           2 * pi),
            0, 1e-4);
        EXPECT_NEAR(world.energy(), energy, 0.01 * energy) << rate;
        EXPECT_EQ(world.validate(), "");
    }
}

TEST(Rails, AHalfBowlHoldsABeadWithTheForceOfTheory) {
    World world;
    const Body bowl = world.add(arcs(-pi, 0, 1));
    const Body bead = beadAt(world, onCircle(-pi / 4), 2);
    const MechanismId slider = world.slider(bowl, bead, onCircle(-pi / 4), bowl.joints());
    EXPECT_NEAR(world.info(slider).value, 0.75 * pi, 1e-6) << "the length from its begin";
    const double start = bead.centreOfMass().y();
    world.step();
    const double energy = world.energy();
    for (int i = 0; i < 1000; ++i) {
        world.step();
        const MechanismInfo info = world.info(slider);
        ASSERT_NEAR(world.energy(), energy, 1e-3 * earth) << i;
        // m (v^2 / R + g cos) = m g (3 cos - 2 cos of the start), towards the centre.
        const double depth = -info.pointB.y();
        const double theory = 2 * earth * (3 * depth + 2 * start);
        ASSERT_NEAR(static_cast<double>(info.holding.norm()), theory, 0.02 * 2 * earth) << i;
        ASSERT_NEAR(static_cast<double>(info.axis.dot(Vec2(info.pointB.cast<Real>()))), 0, 1e-5);
    }
}

TEST(Rails, ArcsThatGoOnInEachOtherHandOverWithoutAKick) {
    World world({.gravity = {0, 0}});
    const Body ring = world.add(hoop(8));
    const Body bead = beadAt(world, {0, -1}, 2);
    const MechanismId slider = world.slider(ring, bead, {0, -1}, ring.joints());
    bead.setVelocity({3, 0});
    world.step();
    for (int i = 0; i < 1500; ++i) {
        world.step();
        ASSERT_NEAR(static_cast<double>(world.info(slider).holding.norm()), 2 * 9, 0.05) << i;
        ASSERT_NEAR(world.info(slider).speed, 3, 1e-3) << i;
    }
}

// --- ropes -----------------------------------------------------------------------------------

TEST(Rails, ABeadLosesNothingWhereStraightLinksMeet) {
    World world;
    const Body ring = world.add(hoop(16, false));
    const Body bead = beadAt(world, {0, -1});
    world.slider(ring, bead, {0, -1}, ring.joints());
    bead.setVelocity({3, 0});
    world.step();
    const double energy = world.energy();
    for (int i = 0; i < 5000; ++i) {
        world.step();
        ASSERT_NEAR(world.energy(), energy, 0.02 * 4.5) << i;
    }
}

TEST(Rails, ABeadOnAHangingRopeSlidesToItsLowestPoint) {
    World world({.airFriction = 2});
    shapes::RopeOptions options;
    options.from = {-2, 0};
    options.to = {2, Real(0.5)};
    options.links = 20;
    options.slack = Real(0.2);
    options.mass = 2;
    options.radius = 0;
    options.bending = 0;
    options.pinFirst = options.pinLast = true;
    const Body rope = world.add(shapes::rope(options));
    const Point start = world.position(rope[3]);
    const Body bead = beadAt(world, start, 2);
    const MechanismId slider =
        world.slider(rope, bead, start, rope.joints(), {.drive = {.damping = 2}});
    test::run(world, 12);
    const MechanismInfo info = world.info(slider);
    const Point at = info.pointB;
    // Its link is chosen when a step begins: where it trembles in a kink it is off the rope by as
    // much as it goes in one.
    constexpr double slow = 0.02;  // m/s
    EXPECT_GT(info.value, 1);
    EXPECT_LT((info.pointA - at).norm(), slow / 500) << "it is on the rope";
    for (std::uint32_t i = 0; i < rope.particles().size(); ++i)
        EXPECT_GT(world.position(rope[i]).y(), at.y() - 0.02) << i;
    EXPECT_LT(test::speedOf(bead), slow);
    EXPECT_LT(test::largestStrain(world, rope), 1e-4);
    EXPECT_EQ(world.validate(), "");
}

TEST(Rails, KeepBothMomentaOfWhatNothingElseHolds) {
    for (const int rate : {60, 500})
        for (const Real stiffness : {infinite, Real(2e3)}) {
            World world({.gravity = {0, 0}, .tickRate = rate});
            shapes::RopeOptions options;
            options.from = {0, 0};
            options.to = {3, 0};
            options.links = 6;
            options.mass = 3;
            options.radius = 0;
            options.bending = 0;
            options.stiffness = stiffness;
            const Body rope = world.add(shapes::rope(options));
            const Body bead = beadAt(world, {0.2, 0}, 2);
            world.slider(rope, bead, {0.2, 0}, rope.joints(),
                         {.drive = {.stiffness = 3, .rest = 2}});
            rope.setVelocity({0, 1}, 1);
            bead.setVelocity({2, -1});
            world.step();
            const lab::Momenta before = lab::momentaOf(world, {0, 0});
            test::run(world, 4);
            const lab::Momenta after = lab::momentaOf(world, {0, 0});
            EXPECT_NEAR((after.linear.sum - before.linear.sum).norm(), 0, 1e-4) << rate;
            EXPECT_NEAR(after.angular, before.angular, 2e-3) << rate;
        }
}

TEST(Rails, AFreeRigidArcTurnsUnderItsBead) {
    World world({.gravity = {0, 0}});
    Blueprint plan = arcs(-pi, 0, 1);
    plan.kind = BodyKind::dynamic;
    const Body bowl = world.add(plan);
    const Body bead = beadAt(world, onCircle(-0.8 * pi));
    const MechanismId slider = world.slider(bowl, bead, onCircle(-0.8 * pi), bowl.joints());
    bead.setVelocity({0, -3});
    world.step();
    const lab::Momenta before = lab::momentaOf(world, {0, 0});
    const double energy = world.energy();
    for (int i = 0; i < 200 && !world.info(slider).atUpper; ++i) {
        world.step();
        ASSERT_NEAR(world.energy(), energy, 0.005 * energy) << i;
        ASSERT_LT((world.info(slider).pointA - world.info(slider).pointB).norm(), 1e-5) << i;
    }
    const lab::Momenta after = lab::momentaOf(world, {0, 0});
    EXPECT_NEAR((after.linear.sum - before.linear.sum).norm(), 0, 1e-5);
    EXPECT_NEAR(after.angular, before.angular, 1e-4);
}

// --- drives ----------------------------------------------------------------------------------

TEST(Rails, FreeEndsStopWhatSlides) {
    for (const double speed : {-2.0, 2.0, 60.0}) {
        World world({.gravity = {0, 0}});
        const Body rail = world.add(line({{0, 0}, {1, 0}, {1, 1}}));
        const Body bead = beadAt(world, {0.5, 0});
        const MechanismId slider = world.slider(rail, bead, {0.5, 0}, rail.joints());
        bead.setVelocity({Real(speed), 0});
        std::size_t reached = 0;
        for (int i = 0; i < 1000; ++i) {
            world.step();
            for (const LimitReached& event : world.events().limitsReached)
                reached += event.mechanism == slider && event.upper == (speed > 0);
            ASSERT_GT(world.info(slider).value, -1e-3) << speed << ' ' << i;
            ASSERT_LT(world.info(slider).value, speed > 10 ? 2.2 : 2.001) << speed << ' ' << i;
        }
        EXPECT_GE(reached, 1u);
        EXPECT_NEAR(world.info(slider).value, speed > 0 ? 2 : 0, 1e-3) << speed;
        EXPECT_LT(test::speedOf(bead), 1e-3) << speed;
    }
}

TEST(Rails, LimitsActAlongTheRail) {
    World world;
    const Body bowl = world.add(arcs(-pi, 0, 3));
    const Body bead = beadAt(world, onCircle(-0.9 * pi));
    const MechanismId slider = world.slider(bowl, bead, onCircle(-0.9 * pi), bowl.joints(),
                                            {.drive = {.upper = Real(0.3 * pi)}});
    test::run(world, 3);
    const MechanismInfo info = world.info(slider);
    EXPECT_NEAR(info.value, 0.3 * pi, 1e-4);
    EXPECT_TRUE(info.atUpper);
    EXPECT_NEAR(info.force, -earth * std::cos(0.3 * pi), 0.01);
    EXPECT_NEAR(static_cast<double>(info.holding.norm()), earth * std::sin(0.3 * pi), 0.01);
}

TEST(Rails, AMotorDrivesAlongTheRailAndBreaksWithItsStrength) {
    World world;
    const Body ring = world.add(hoop(6));
    const Body bead = beadAt(world, {0, -1});
    Drive drive{.motorSpeed = 1, .motorMax = 100};
    const MechanismId slider = world.slider(ring, bead, {0, -1}, ring.joints(), {.drive = drive});
    world.step();
    for (int i = 0; i < 1500; ++i) {
        world.step();
        const MechanismInfo info = world.info(slider);
        if (i < 10) continue;  // it is about to be as fast
        ASSERT_NEAR(info.speed, 1, 2e-3) << i;
        ASSERT_NEAR(info.force, earth * std::sin(info.value), 0.05) << i;
    }
    drive.strength = 9;
    world.setDrive(slider, drive);
    std::size_t broken = 0;
    for (int i = 0; i < 3500 && world.contains(slider); ++i) {
        world.step();
        broken += world.events().mechanismsBroken.size();
    }
    EXPECT_FALSE(world.contains(slider));
    EXPECT_EQ(broken, 1u);
}

TEST(Rails, ASpringSwingsAlongTheRailAtItsFrequency) {
    World world({.gravity = {0, 0}});
    const Body ring = world.add(hoop(5));
    const Body bead = beadAt(world, {0, -1});
    const MechanismId slider =
        world.slider(ring, bead, {0, -1}, ring.joints(), {.drive = {.stiffness = 40, .rest = 1}});
    double before = -1, last = 0;
    int swings = 0;
    while (swings < 3 && world.time() < 10) {
        world.step();
        const double now = world.info(slider).value - 1;
        if (before < 0 && now >= 0) {
            ++swings;
            last = world.time();
        }
        before = now;
    }
    EXPECT_NEAR(last / 2.25, 2 * pi / std::sqrt(40), 0.005);
}

TEST(Rails, AGearCouplesPlacesOnTwoRails) {
    World world({.gravity = {0, 0}});
    const Body one = world.add(hoop(6)), other = world.add(line({{3, 0}, {5, 0}, {5, 9}}));
    const Body a = beadAt(world, {0, -1}), b = beadAt(world, {3, 0});
    const MechanismId first = world.slider(one, a, {0, -1}, one.joints(),
                                           {.drive = {.motorSpeed = 1, .motorMax = 50}}),
                      second = world.slider(other, b, {3, 0}, other.joints());
    world.gear(first, second, Real(-0.5));
    test::run(world, 4);
    EXPECT_NEAR(world.info(second).value, 2 * world.info(first).value, 2e-3);
    EXPECT_NEAR(world.info(second).value, 8, 0.1);
}

// --- what becomes of it ----------------------------------------------------------------------

TEST(Rails, EndWhereAJointIsRemovedAndLetGoWithTheirOwn) {
    World world;
    const Body rail = world.add(line({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}));
    const Body bead = beadAt(world, {1.5, 0});
    const MechanismId slider = world.slider(rail, bead, {1.5, 0}, rail.joints(),
                                            {.drive = {.motorSpeed = 1, .motorMax = 9}});
    const std::vector<JointId> links(rail.joints().begin(), rail.joints().end());
    world.remove(links[3]);
    EXPECT_EQ(world.info(slider).rail, (std::vector{links[0], links[1], links[2]}));
    test::run(world, 3);
    EXPECT_NEAR(world.info(slider).value, 3, 1e-3);
    EXPECT_TRUE(world.info(slider).atUpper);
    world.remove(links[0]);
    EXPECT_NEAR(world.info(slider).railBegin, 1, 1e-6);
    EXPECT_NEAR(world.info(slider).value, 3, 1e-3) << "it counts as before";
    world.remove(links[2]);
    EXPECT_FALSE(world.contains(slider));
    EXPECT_EQ(world.validate(), "");
    test::run(world, 0.2);
    EXPECT_LT(bead.centreOfMass().y(), -0.1);
}

TEST(Rails, AHoopThatIsCutEndsAtTheCut) {
    World world({.gravity = {0, 0}});
    const Body ring = world.add(hoop(4));
    const Body bead = beadAt(world, {0, -1});
    const MechanismId slider = world.slider(ring, bead, {0, -1}, ring.joints());
    const std::vector<JointId> links(ring.joints().begin(), ring.joints().end());
    bead.setVelocity({2, 0});
    test::run(world, 4);  // beyond the first round
    world.remove(links[2]);
    EXPECT_EQ(world.info(slider).rail, (std::vector{links[3], links[0], links[1]}));
    test::run(world, 4);
    EXPECT_NEAR(world.info(slider).value, 3 * pi, 1e-3);
    EXPECT_NEAR(world.info(slider).railBegin, 1.5 * pi, 1e-5);
    EXPECT_NEAR((bead.centreOfMass() - Point(0, 1)).norm(), 0, 1e-3);
}

TEST(Rails, StayOnTheirPieceOfARopeThatBreaks) {
    World world;
    const Body rope = world.add(shapes::chain({.from = {0, 0},
                                               .to = {2, 0},
                                               .links = 8,
                                               .radius = Real(0.01),
                                               .strength = 1000,
                                               .pinFirst = true}));
    const Body bead = beadAt(world, {1.6, 0}, Real(0.5));
    const MechanismId slider = world.slider(rope, bead, {1.6, 0}, rope.joints());
    const JointId weak = rope.joints()[4];
    test::run(world, 0.1);
    world.setStrength(weak, Real(1e-3));
    test::run(world, 0.05);
    ASSERT_FALSE(world.contains(weak));
    ASSERT_TRUE(world.contains(slider));
    const MechanismInfo info = world.info(slider);
    EXPECT_NE(info.a, rope.id()) << "a piece of it";
    EXPECT_EQ(info.rail.size(), 3u);
    EXPECT_EQ(world.validate(), "");
    test::run(world, 1);
    EXPECT_LT((world.info(slider).pointA - world.info(slider).pointB).norm(), 1e-2);
    world.remove(info.a);
    EXPECT_FALSE(world.contains(slider));
}

TEST(Rails, SnapshotsAndClonesGoOnAsTheyDo) {
    World world;
    const Body ring = world.add(hoop(7));
    const Body bead = beadAt(world, {0, -1});
    const MechanismId slider =
        world.slider(ring, bead, {0, -1}, ring.joints(), {.turns = false, .value = -2});
    EXPECT_NEAR(world.info(slider).value, -2, 1e-6);
    bead.setVelocity({7, 0});
    test::run(world, 0.7);
    World copy = world.clone();
    const Snapshot snapshot = world.snapshot();
    test::run(world, 2);
    test::run(copy, 2);
    EXPECT_EQ(copy.hash(), world.hash());
    EXPECT_EQ(copy.info(slider).value, world.info(slider).value);
    World other;
    other.restore(snapshot);
    test::run(other, 2);
    EXPECT_EQ(other.hash(), world.hash());
    EXPECT_EQ(world.validate(), "");
}

TEST(Rails, ABeadBesideItsRailIsLedThereWithoutASpeed) {
    World world({.gravity = {0, 0}});
    const Body rail = world.add(line({{0, 0}, {1, 0}, {2, 0}}));
    const Body bead = beadAt(world, {0.5, 0.3});
    world.slider(rail, bead, {0.5, 0.3}, rail.joints());
    for (int i = 0; i < 100; ++i) {
        const Point before = bead.centreOfMass();
        world.step();
        ASSERT_LT((bead.centreOfMass() - before).norm(), 5.01 / 500) << i;
    }
    test::run(world, 1);
    EXPECT_NEAR((bead.centreOfMass() - Point(0.5, 0)).norm(), 0, 1e-4);
    EXPECT_LT(test::speedOf(bead), 1e-5);
}

// --- at random -------------------------------------------------------------------------------

/// Free chains and hoops with beads that nothing else touches.
TEST(Rails, RandomOnesKeepMomentaAndMakeNoEnergy) {
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        test::Random random(seed);
        World world({.gravity = {0, 0}, .tickRate = seed % 3 == 0 ? 120 : 500});
        std::vector<Vec2> points{{0, 0}};
        const std::size_t count = 1 + random.below(7);
        double angle = random.uniform(-3, 3);
        for (std::size_t i = 0; i < count; ++i) {
            angle += random.uniform(-1, 1);
            const double length = random.uniform(0.3, 1);
            points.push_back(points.back() +
                             Vec2(Real(length * std::cos(angle)), Real(length * std::sin(angle))));
        }
        Blueprint plan = line(points, BodyKind::dynamic);
        for (ParticleSpec& particle : plan.particles) particle.mass = Real(random.uniform(0.2, 3));
        const Body rope = world.add(plan);
        std::vector<MechanismId> sliders;
        for (int k = 0; k < 3; ++k) {
            const auto link = random.below(count);
            const Point at = (points[link] + points[link + 1]).cast<double>() / 2;
            const Body bead = beadAt(world, at, Real(random.uniform(0.2, 3)));
            sliders.push_back(world.slider(rope, bead, at, rope.joints()));
            bead.setVelocity({Real(random.uniform(-2, 2)), Real(random.uniform(-2, 2))});
        }
        world.step();
        const lab::Momenta before = lab::momentaOf(world, {0, 0});
        double energy = world.energy();
        for (int i = 0; i < 800; ++i) {
            world.step();
            ASSERT_LT(world.energy(), 1.02 * energy + 1e-3) << seed << ' ' << i;
            energy = std::min(energy, world.energy());
            for (const MechanismId id : sliders)
                ASSERT_LT((world.info(id).pointA - world.info(id).pointB).norm(), 0.02)
                    << seed << ' ' << i;
        }
        const lab::Momenta after = lab::momentaOf(world, {0, 0});
        EXPECT_LT((after.linear.sum - before.linear.sum).norm(), 1e-4) << seed;
        EXPECT_NEAR(after.angular, before.angular, 1e-2) << seed;
        EXPECT_EQ(world.validate(), "") << seed;
    }
}

}  // namespace
}  // namespace sulfur
