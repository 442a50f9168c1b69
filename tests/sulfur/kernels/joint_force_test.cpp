// The kernels give the same bits whatever instructions they use, and as one by one.
#include "kernels/joint_force.hpp"

#include <gtest/gtest.h>

#include <sulfur/sulfur.hpp>

#include "helpers.hpp"

namespace sulfur {

namespace {

/// So many jellies, shaken, each far from the others.
std::vector<Body> addJellies(World& world, int count, Real damping) {
    std::vector<Body> bodies;
    const Blueprint plan =
        shapes::jelly({.columns = 4, .rows = 4, .mass = 1, .stiffness = 20, .damping = damping});
    test::Random random(7);
    for (int i = 0; i < count; ++i) {
        bodies.push_back(world.add(plan, {.position = {10.0 * i, 0}}));
        for (const ParticleId id : bodies.back().particles())
            world.setVelocity(id, Vec2(static_cast<Real>(random.bits() % 1000) / 500 - 1,
                                       static_cast<Real>(random.bits() % 1000) / 500 - 1));
    }
    return bodies;
}

std::uint64_t hashAfterSwinging(int count, Real damping, detail::Instructions most) {
    detail::useKernelsUpTo(most);
    World world;
    addJellies(world, count, damping);
    for (int i = 0; i < 200; ++i) world.step();
    EXPECT_EQ(world.validate(), "");
    EXPECT_GT(world.statistics().explicitJoints, 10u);
    detail::useKernelsUpTo(detail::Instructions::avx512);
    return world.hash();
}

}  // namespace

/// 5 and 11 jellies leave batches that fill no whole vector.
TEST(JointForce, SameBitsWithAnyInstructions) {
    for (const int count : {1, 5, 11})
        for (const Real damping : {Real(0), Real(0.5)})
            EXPECT_EQ(hashAfterSwinging(count, damping, detail::Instructions::avx512),
                      hashAfterSwinging(count, damping, detail::Instructions::baseline));
}

/// Two are too few for lanes beyond their own joints, thirteen go side by side: to the last bit
/// the first of them moves as if it were alone.
TEST(JointForce, MovesInstancesAsIfTheyWereAlone) {
    for (const Real damping : {Real(0), Real(0.5)}) {
        World alone, many;
        const Body one = addJellies(alone, 1, damping).front();
        const Body first = addJellies(many, 13, damping).front();
        for (int i = 0; i < 300; ++i) alone.step(), many.step();
        for (std::size_t k = 0; k < one.size(); ++k) {
            EXPECT_EQ(alone.position(one[k]), many.position(first[k])) << k;
            EXPECT_EQ(alone.velocity(one[k]), many.velocity(first[k])) << k;
        }
        for (std::size_t j = 0; j < one.joints().size(); ++j)
            EXPECT_EQ(alone.info(one.joints()[j]).force, many.info(first.joints()[j]).force) << j;
    }
}

/// Between joints of length 0 nothing pulls, and nothing is not a number.
TEST(JointForce, LeavesWhatHasNoLengthAlone) {
    World world;
    world.setGravity({0, 0});
    Blueprint plan;
    for (int i = 0; i < 6; ++i) {
        plan.particles.push_back({.position = Vec2(Real(i), 0)});
        plan.particles.push_back({.position = Vec2(Real(i), 0)});
        JointSpec joint{.a = static_cast<std::uint32_t>(2 * i),
                        .b = static_cast<std::uint32_t>(2 * i + 1)};
        joint.stiffness = 10;
        joint.damping = i % 2 == 0 ? Real(1) : Real(0);
        joint.restLength = Real(0);
        plan.joints.push_back(joint);
    }
    const Body body = world.add(plan);
    for (int i = 0; i < 10; ++i) world.step();
    for (int i = 0; i < 6; ++i)
        EXPECT_EQ(world.position(body[static_cast<std::size_t>(2 * i)]), Point(i, 0));
    EXPECT_EQ(world.validate(), "");
}

}  // namespace sulfur
