// The paper's constants are what the paper gives.
#include "helpers.hpp"

namespace sulfur {
namespace {

TEST(Presets, RopeIsThePapers) {
    const Blueprint plan = shapes::rope(presets::rope(250));
    ASSERT_EQ(plan.particles.size(), 40u);
    ASSERT_EQ(plan.joints.size(), 39u);
    for (const auto& p : plan.particles) EXPECT_NEAR(p.mass, 0.05, 1e-7);
    for (const auto& j : plan.joints) {
        EXPECT_NEAR(*j.restLength, 0.05, 1e-7);
        EXPECT_EQ(j.stiffness, 250);
        EXPECT_EQ(j.damping, Real(0.2));
    }
    EXPECT_TRUE(plan.particles.front().pinned);
    EXPECT_EQ(plan.particles.back().position.y(), 0);
}

TEST(Presets, AirFrictionIsThePapersForceOnItsParticles) {
    WorldSettings settings = presets::world();
    EXPECT_EQ(settings.tickRate, 500);
    settings.gravity = {0, 0};
    World world(settings);
    const Body ball = world.add(shapes::ball({.mass = presets::ropeParticleMass}));
    const double v = 3;
    world.setVelocity(ball[0], {Real(v), 0});
    test::run(world, 1);
    // m v' = -0.02 v
    EXPECT_NEAR(world.velocity(ball[0]).x(), v * std::exp(-0.02 / 0.05), 2e-3);
}

TEST(Presets, PlainBoxHasFourCornerMasses) {
    const Blueprint plan = shapes::box(presets::plainBox({2, 1}, 4));
    ASSERT_EQ(plan.particles.size(), 4u);
    for (const auto& p : plan.particles) EXPECT_EQ(p.mass, 1);
    EXPECT_EQ(plan.joints.size(), 6u);
}

}  // namespace
}  // namespace sulfur
