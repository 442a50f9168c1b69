#include "helpers.hpp"

namespace sulfur {
namespace {

double inertia(const Blueprint& plan) {
    const Vec2 centre = plan.centreOfMass();
    double sum = 0;
    for (const auto& p : plan.particles)
        sum +=
            static_cast<double>(p.mass) * static_cast<double>((p.position - centre).squaredNorm());
    return sum;
}

Vec2 outerSize(const Blueprint& plan) {
    Vec2 low(1e9f, 1e9f), high(-1e9f, -1e9f);
    for (const auto& j : plan.joints) {
        for (const auto i : {j.a, j.b}) {
            const Vec2 margin(j.radius, j.radius);
            low = low.cwiseMin(plan.particles[i].position - margin);
            high = high.cwiseMax(plan.particles[i].position + margin);
        }
    }
    return high - low;
}

TEST(Shapes, BoxHasTheMassSizeAndInertiaOfASolid) {
    for (const Vec2& size : {Vec2(1, 1), Vec2(2, 0.5), Vec2(0.3, 0.4)}) {
        const Blueprint plan = shapes::box({.size = size, .mass = 3});
        EXPECT_NEAR(plan.mass(), 3, 1e-5);
        EXPECT_NEAR((outerSize(plan) - size).norm(), 0, 1e-6);
        const double solid = 3 * static_cast<double>(size.squaredNorm()) / 12;
        EXPECT_NEAR(inertia(plan) / solid, 1, 1e-3);
    }
}

TEST(Shapes, PaperBoxHasFourParticlesAndSixJoints) {
    const Blueprint plan = shapes::box({.solidInertia = false});
    EXPECT_EQ(plan.particles.size(), 4u);
    EXPECT_EQ(plan.joints.size(), 6u);
}

TEST(Shapes, BlobHasTheMassAndInertiaOfADisc) {
    const Blueprint plan = shapes::blob({.radius = Real(0.5), .mass = 2});
    EXPECT_NEAR(plan.mass(), 2, 1e-5);
    EXPECT_NEAR(inertia(plan) / (2 * 0.5 * 0.5 / 2), 1, 1e-3);
}

TEST(Shapes, RopeRunsFromEndToEnd) {
    const Blueprint plan = shapes::rope({.from = {1, 2}, .to = {1, 0}, .links = 40, .mass = 2});
    EXPECT_EQ(plan.particles.size(), 41u);
    EXPECT_EQ(plan.joints.size(), 40u);
    EXPECT_EQ(plan.particles.front().position, Vec2(1, 2));
    EXPECT_EQ(plan.particles.back().position, Vec2(1, 0));
    EXPECT_NEAR(plan.mass(), 2, 1e-5);
    EXPECT_NEAR(*plan.joints[7].restLength, 0.05, 1e-7);
}

TEST(Shapes, GroundClosesAndHasOuterThickness) {
    const Blueprint open = shapes::ground({.points = {{0, 0}, {1, 0}, {1, 1}}});
    const Blueprint closed = shapes::ground({.points = {{0, 0}, {1, 0}, {1, 1}}, .closed = true});
    EXPECT_EQ(open.joints.size(), 2u);
    EXPECT_EQ(closed.joints.size(), 3u);
    EXPECT_EQ(open.kind, BodyKind::fixed);
}

TEST(Shapes, RefuseImpossibleSizes) {
    EXPECT_THROW(shapes::box({.size = {0.01, 1}}), Error);
    EXPECT_THROW(shapes::box({.mass = 0}), Error);
    EXPECT_THROW(shapes::ball({.radius = -1}), Error);
    EXPECT_THROW(shapes::rope({.from = {1, 1}, .to = {1, 1}}), Error);
    EXPECT_THROW(shapes::rope({.links = -3}), Error);
    EXPECT_THROW(shapes::jelly({.columns = 1}), Error);
    EXPECT_THROW(shapes::blob({.segments = 2}), Error);
    EXPECT_THROW(shapes::ground({.points = {{0, 0}}}), Error);
    EXPECT_THROW(shapes::floor({0, 0}, {0, 0}), Error);
}

}  // namespace
}  // namespace sulfur
