#include "helpers.hpp"

namespace sulfur {
namespace {

Blueprint spring(Real stiffness, Real damping, Real mass = 1) {
    Blueprint plan;
    plan.particles = {{.position = {0, 0}, .pinned = true}, {.position = {1, 0}, .mass = mass}};
    plan.joints = {{.a = 0, .b = 1, .stiffness = stiffness, .damping = damping}};
    return plan;
}

TEST(Joints, KindIsDerivedFromStiffnessMassAndTick) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body soft = world.add(spring(100, 0));
    world.add(spring(Real(1e9), 0), {.position = {0, 5}});
    world.add(spring(infinite, 0), {.position = {0, 10}});
    world.step();
    EXPECT_EQ(world.statistics().explicitJoints, 1u);
    EXPECT_EQ(world.statistics().implicitJoints, 1u);
    EXPECT_EQ(world.statistics().rigidJoints, 1u);
    world.setStiffness(soft.joints()[0], Real(1e8));
    world.step();
    EXPECT_EQ(world.statistics().explicitJoints, 0u);
    world.setMass(soft[1], Real(1e6));
    world.step();
    EXPECT_EQ(world.statistics().explicitJoints, 1u);
}

/// NSV keeps the amplitude and shifts the frequency to 2 asin(w h / 2) / h.
TEST(Joints, UndampedSpringKeepsItsAmplitudeAndFrequency) {
    const double stiffness = 4000, h = 1 / 500.0;
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body body = world.add(spring(static_cast<Real>(stiffness), 0));
    world.setPosition(body[1], {1.1, 0});
    world.setVelocity(body[1], {0, 0});
    const double expected = 2 * std::asin(std::sqrt(stiffness) * h / 2) / h;
    const double period = 2 * 3.14159265358979 / expected;
    double largest = 0, lastCrossing = 0, firstCrossing = -1, before = 0.1;
    int crossings = 0;
    for (int i = 1; i < 100 * period / h; ++i) {
        world.step();
        const double stretch = world.position(body[1])[0] - 1;
        if (i > 99 * period / h) largest = std::max(largest, std::abs(stretch));
        if (before > 0 && stretch <= 0) {
            lastCrossing = (i - 1 + before / (before - stretch)) * h;
            if (firstCrossing < 0)
                firstCrossing = lastCrossing;
            else
                ++crossings;
        }
        before = stretch;
    }
    const double measured = 2 * 3.14159265358979 * crossings / (lastCrossing - firstCrossing);
    EXPECT_NEAR(measured / expected, 1, 1e-3);
    EXPECT_NEAR(largest, 0.1, 0.1 * 2e-2);  // sampled, so up to the phase between two ticks
}

TEST(Joints, StiffSpringHoldsItsLoadAndRestsAtHookesLength) {
    for (const Real k : {Real(1e3), Real(1e5), Real(1e7), Real(1e9)}) {
        World world({.sleeping = false});
        Blueprint plan = spring(k, std::sqrt(k));
        plan.particles[1].position = {0, -1};
        const Body body = world.add(plan);
        test::run(world, 5);
        const double stretch = -world.position(body[1])[1] - 1;
        EXPECT_NEAR(stretch, 9.81 / static_cast<double>(k),
                    2e-6 + 0.01 * 9.81 / static_cast<double>(k))
            << k;
        EXPECT_NEAR(world.info(body.joints()[0]).force, 9.81, 0.1) << k;
    }
}

/// Springs that pull along their direction at a tick's end take a share (h omega)^2 of the spin in
/// every tick: 37 % were gone after a second.
TEST(Joints, StiffJellyKeepsItsSpin) {
    for (const Real stiffness : {Real(2e3), Real(1e5)}) {
        World world({.gravity = {0, 0}, .sleeping = false});
        const Body body =
            world.add(shapes::jelly({.size = {1, 1}, .mass = 1, .stiffness = stiffness}));
        const Point centre = world.centreOfMass(body);
        for (const ParticleId id : body.particles()) {
            const Point arm = world.position(id) - centre;
            world.setVelocity(id, (20 * Point(-arm[1], arm[0])).cast<Real>());
        }
        const auto spin = [&] {
            double sum = 0;
            for (const ParticleId id : body.particles()) {
                const Point arm = world.position(id) - world.centreOfMass(body);
                const Point v = world.velocity(id).cast<double>();
                sum += arm[0] * v[1] - arm[1] * v[0];
            }
            return sum;
        };
        world.step();
        const double before = spin();
        for (int i = 0; i < 2500; ++i) world.step();
        ASSERT_GT(world.statistics().sweptJoints, 0u);
        EXPECT_NEAR(spin() / before, 1, 0.01) << stiffness;
    }
}

/// Forces are in balance whatever air friction there is, in trees, in networks and on attachments.
TEST(Joints, ForcesAtRestDoNotDependOnAirFriction) {
    for (const int rate : {500, 120}) {
        World world({.airFriction = 5, .tickRate = rate, .sleeping = false});
        Blueprint chain;
        chain.particles = {{.position = {0, 0}, .pinned = true},
                           {.position = {0, -1}, .mass = 1},
                           {.position = {0, -2}, .mass = 1}};
        chain.joints = {{.a = 0, .b = 1, .stiffness = 1e5f}, {.a = 1, .b = 2}};
        const Body hanging = world.add(chain);
        Blueprint frame = chain;  // with a cycle, so that it is swept
        for (ParticleSpec& p : frame.particles) p.position.x() += 3;
        frame.joints.push_back({.a = 0, .b = 2, .stiffness = 1e5f});
        const Body swept = world.add(frame);
        for (int i = 0; i < 20 * rate; ++i) world.step();
        const auto weight = static_cast<double>(world.settings().gravity.norm());
        EXPECT_NEAR(world.info(hanging.joints()[0]).force, 2 * weight, 1e-3 * weight) << rate;
        EXPECT_NEAR(world.info(hanging.joints()[1]).force, weight, 1e-3 * weight) << rate;
        const double held =
            world.info(swept.joints()[0]).force + world.info(swept.joints()[2]).force;
        EXPECT_NEAR(held, 2 * weight, 2e-3 * 2 * weight) << rate;
    }
}

TEST(Joints, RigidPendulumKeepsLengthEnergyAndPeriod) {
    World world({.sleeping = false});
    const Body pendulum = world.add(shapes::rope(
        {.from = {0, 0}, .to = {1, 0}, .links = 1, .mass = 2, .radius = 0, .pinFirst = true}));
    const double start = world.energy();
    double lowest = 0, crossing = 0, before = 1;
    for (int i = 1; crossing == 0 && i < 1000; ++i) {
        world.step();
        const double x = world.position(pendulum.back())[0];
        EXPECT_NEAR(world.position(pendulum.back()).norm(), 1, 1e-5);
        if (before > 0 && x <= 0) crossing = (i - 1 + before / (before - x)) / 500.0;
        before = x;
    }
    // A quarter of 4 sqrt(L / g) K(1/2), the period of a pendulum released at 90 degrees.
    EXPECT_NEAR(crossing, 2.367842 / 4 / std::sqrt(9.81 / 9.81), 2.367842 / 4 * 2e-3);
    test::run(world, 60);
    lowest = world.energy();
    EXPECT_NEAR(lowest, start, 0.005 * 9.81);
}

TEST(Joints, HangingRopeCarriesWhatIsBelow) {
    World world({.airFriction = 2, .sleeping = false});
    const Body rope = world.add(shapes::rope({.from = {0, 0},
                                              .to = {0, -2},
                                              .links = 40,
                                              .mass = Real(2.05),
                                              .radius = 0,
                                              .stiffness = 5000,
                                              .damping = 1,
                                              .pinFirst = true}));
    test::run(world, 30);
    for (std::size_t j = 0; j < 40; ++j) {
        const double carried = 0.05 * 9.81 * static_cast<double>(40 - j);
        EXPECT_NEAR(world.info(rope.joints()[j]).force, carried, 0.01 * carried + 0.01) << j;
    }
}

TEST(Joints, OverloadedJointBreaksWithAnEvent) {
    World world;
    Blueprint plan = spring(5000, 10);
    plan.particles[1].position = {0, -1};
    plan.joints[0].strength = 5;
    const Body body = world.add(plan);
    const JointId joint = body.joints()[0];
    bool told = false;
    for (int i = 0; i < 500; ++i) {
        world.step();
        for (const JointBroken& event : world.events().jointsBroken) {
            told = true;
            EXPECT_EQ(event.joint, joint);
            EXPECT_EQ(event.body, body.id());
            EXPECT_GT(event.force, 5);
        }
    }
    EXPECT_TRUE(told);
    EXPECT_FALSE(world.contains(joint));
    // Nothing is left of it: neither particle has a joint or a radius.
    EXPECT_FALSE(world.contains(body.id()));
    EXPECT_EQ(world.validate(), "");
}

TEST(Joints, ConnectionAndAttachmentTieBodies) {
    World world({.airFriction = 1, .sleeping = false});
    Blueprint plan = shapes::box({.size = {1, 1}, .mass = 2});
    const Body crate = world.add(plan, {.position = {0, 0}});
    const Body rope = world.add(
        shapes::rope({.from = {Real(0.4), 2}, .to = {Real(0.4), Real(0.5)}, .pinFirst = true}));
    const AttachmentId knot = world.attach(rope.back(), crate, {Real(0.4), Real(0.5)});
    test::run(world, 20);
    // The crate hangs with its centre below the knot.
    EXPECT_NEAR(world.centreOfMass(crate)[0], world.position(rope.front())[0], 0.08);
    EXPECT_NEAR(world.position(rope.back())[1], 0.5, 0.05);
    EXPECT_TRUE(world.contains(knot));
    world.remove(knot);
    test::run(world, 1);
    EXPECT_LT(world.centreOfMass(crate)[1], -3);
    EXPECT_EQ(world.validate(), "");
}

TEST(Joints, EveryStiffnessStaysFinite) {
    for (double exponent = -1; exponent <= 12; exponent += 0.5) {
        World world({.sleeping = false});
        const Body body = world.add(
            shapes::jelly({.stiffness = static_cast<Real>(std::pow(10, exponent)), .damping = 1}));
        world.setPinned(body[0], true);
        const double start = world.energy();
        test::run(world, 3);
        EXPECT_EQ(world.validate(), "") << exponent;
        // Beyond, the rounding of a length alone is a large energy.
        if (exponent <= 9) {
            EXPECT_LT(world.energy(), start + 5) << exponent;
        }
    }
}

}  // namespace
}  // namespace sulfur
