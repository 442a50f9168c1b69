// The kernels give the same bits whatever instructions they use.
#include "kernels/joint_sweep.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sulfur/sulfur.hpp>
#include <utility>

#include "helpers.hpp"

namespace sulfur {

namespace {

/// A net of `side` squared particles, shaken; 7 a side leave batches that fill no whole vector. A
/// triangle of springs hangs on it, so that it is swept whatever it is made of.
Body addNet(World& world, unsigned side, Real stiffness) {
    Blueprint plan;
    for (unsigned i = 0; i < side * side; ++i)
        plan.particles.push_back(
            {.position = Vec2(Real(0.1) * Real(i % side), Real(0.1) * Real(i / side)),
             .mass = Real(0.05) * Real(1 + i % 3),
             .pinned = i == side * (side - 1) || i == side * side - 1});
    for (unsigned i = 0; i < side * side; ++i) {
        if (i % side + 1 < side)
            plan.joints.push_back({.a = i, .b = i + 1, .stiffness = stiffness, .damping = 1});
        if (i + side < side * side)
            plan.joints.push_back({.a = i + side, .b = i, .stiffness = stiffness, .damping = 1});
    }
    for (const Vec2& place : {Vec2(Real(-0.1), 0), Vec2(0, Real(-0.1))})
        plan.particles.push_back({.position = place, .mass = Real(0.05)});
    for (const auto& [a, b] : {std::pair(0u, side * side), std::pair(0u, side * side + 1),
                               std::pair(side * side, side * side + 1)})
        plan.joints.push_back({.a = a, .b = b, .stiffness = Real(1e6), .damping = 1});
    const Body body = world.add(plan);
    test::Random random(7);
    for (const ParticleId id : body.particles())
        if (!world.info(id).pinned)
            world.setVelocity(id, Vec2(static_cast<Real>(random.bits() % 1000) / 500 - 1,
                                       static_cast<Real>(random.bits() % 1000) / 500 - 1));
    return body;
}

std::uint64_t hashAfterSwinging(Real stiffness, detail::Instructions most) {
    detail::useKernelsUpTo(most);
    World world;
    addNet(world, 7, stiffness);
    const Body net = addNet(world, 12, stiffness);
    for (int i = 0; i < 150; ++i) world.step();
    // Some are torn from now on.
    for (std::size_t j = 0; j < 200; j += 20) world.setRestLength(net.joints()[j], Real(0.15));
    for (int i = 0; i < 150; ++i) world.step();
    EXPECT_EQ(world.validate(), "");
    EXPECT_GT(world.statistics().sweptJoints, 100u);
    detail::useKernelsUpTo(detail::Instructions::avx512);
    return world.hash();
}

}  // namespace

TEST(JointSweep, SameBitsWithAnyInstructions) {
    for (const Real stiffness : {Real(1e6), infinite})
        EXPECT_EQ(hashAfterSwinging(stiffness, detail::Instructions::avx512),
                  hashAfterSwinging(stiffness, detail::Instructions::baseline));
}

/// What is kept of joints from tick to tick follows what it depends on: a world that has just been
/// restored has kept nothing.
TEST(JointSweep, FollowsAirFrictionAndMasses) {
    World world;
    const Body net = addNet(world, 7, Real(1e6));
    for (int i = 0; i < 20; ++i) world.step();
    const auto change = [&](World& w, int what) {
        if (what == 1) w.setAirFriction(Real(0.5));
        if (what == 2) w.setMass(net[8], Real(0.3));
        if (what == 3) w.setTickRate(1000);
    };
    for (const int what : {0, 1, 2, 3}) {
        World other;
        other.restore(world.snapshot());
        change(world, what);
        change(other, what);
        for (int i = 0; i < 20; ++i) world.step(), other.step();
        EXPECT_EQ(world.hash(), other.hash()) << what;
    }
}

TEST(JointSweep, KeepsLengthsOfARigidNet) {
    World world({.sweeps = 60});
    const Body net = addNet(world, 7, infinite);
    for (int i = 0; i < 200; ++i) world.step();
    for (unsigned row = 0; row < 7; ++row)
        for (unsigned k = 0; k + 1 < 7; ++k) {
            const Point a = world.position(net[7 * row + k]),
                        b = world.position(net[7 * row + k + 1]);
            EXPECT_NEAR((a - b).norm(), 0.1, 0.01);
        }
}

}  // namespace sulfur
