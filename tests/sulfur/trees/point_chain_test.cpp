// The fast path for ropes moves them as the general solver for trees does.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sulfur/sulfur.hpp>

#include "helpers.hpp"

namespace sulfur {

namespace {

constexpr Real rigid = std::numeric_limits<Real>::infinity();
constexpr unsigned links = 40, knot = 20;

struct RopePlan {
    Real stiffness = rigid;  // N/m, of every second joint
    Real load = 1;           // masses of a link, on the last particle
    bool pinnedAtTheStart = true, pinnedAtTheEnd = false;
};

/// Straight, or in a bow if both ends are held.
Vec2 placeOf(const RopePlan& plan, unsigned i) {
    const double along = i, bow = plan.pinnedAtTheEnd ? 0.0008 * i * (links - i) : 0;
    return Vec2(static_cast<Real>(0.03 * along - bow), static_cast<Real>(-0.04 * along - bow));
}

/// A rope that hangs aside. With a `twig`, a joint to a particle of 1 milligram at its middle, it
/// is a chain no more, so the general solver moves it, the same to a millionth.
Blueprint rope(const RopePlan& plan, bool twig) {
    Blueprint blueprint;
    for (unsigned i = 0; i <= links; ++i) {
        blueprint.particles.push_back(
            {.position = placeOf(plan, i),
             .mass = i == links ? Real(0.05) * plan.load : Real(0.05),
             .pinned = (i == 0 && plan.pinnedAtTheStart) || (i == links && plan.pinnedAtTheEnd)});
    }
    for (unsigned i = 0; i < links; ++i)
        blueprint.joints.push_back(
            {.a = i, .b = i + 1, .stiffness = i % 2 == 0 ? rigid : plan.stiffness});
    if (twig) {
        blueprint.particles.push_back(
            {.position = placeOf(plan, knot) - Vec2(0, Real(0.05)), .mass = Real(1e-6)});
        blueprint.joints.push_back(
            {.a = knot, .b = links + 1, .stiffness = rigid, .restLength = Real(0.05)});
    }
    return blueprint;
}

void expectTheSame(const RopePlan& plan) {
    World chain, tree;
    const Body fast = chain.add(rope(plan, false)), slow = tree.add(rope(plan, true));
    chain.setVelocity(fast, Vec2(Real(0.5), 0));
    tree.setVelocity(slow, Vec2(Real(0.5), 0));
    for (int i = 0; i < 300; ++i) {
        chain.step();
        tree.step();
    }
    double farthest = 0, moved = 0;
    for (unsigned i = 0; i <= links; ++i) {
        const Point a = chain.position(fast[i]), b = tree.position(slow[i]);
        farthest = std::max(farthest, (a - b).norm());
        moved = std::max(moved, (a - placeOf(plan, i).cast<double>()).norm());
    }
    EXPECT_LT(farthest, 1e-5 * moved);
    EXPECT_GT(moved, 0.005);
    for (unsigned i = 0; i < links; ++i) {
        const double a = static_cast<double>(chain.info(fast.joints()[i]).force);
        const double b = static_cast<double>(tree.info(slow.joints()[i]).force);
        EXPECT_NEAR(a, b, 3e-3 * std::max(1.0, std::abs(b))) << i;
    }
    EXPECT_EQ(chain.validate(), "");
}

}  // namespace

TEST(PointChain, MovesAHangingRopeAsTheTreeSolverDoes) {
    expectTheSame({});
}

TEST(PointChain, TakesAsManyStepsForAHeavyLoad) {
    expectTheSame({.load = 1e4});
    World world;
    world.add(rope({.load = 1e4}, false));
    for (int i = 0; i < 10; ++i) world.step();
    EXPECT_GT(world.statistics().chainSteps, 1u);
}

TEST(PointChain, SolvesElasticLinksAmongRigidOnes) {
    expectTheSame({.stiffness = 1e6, .load = 10});
}

TEST(PointChain, IsHeldAtBothEnds) {
    expectTheSame({.pinnedAtTheEnd = true});
}

TEST(PointChain, FliesFreely) {
    expectTheSame({.pinnedAtTheStart = false});
}

/// Two links in a straight line between two pins: one more rigid row than can move.
TEST(PointChain, IsFiniteWhereALinkIsRedundant) {
    World world;
    Blueprint taut;
    for (unsigned i = 0; i < 3; ++i)
        taut.particles.push_back({.position = {1.0 * i, 0}, .mass = 1, .pinned = i != 1});
    for (unsigned i = 0; i < 2; ++i)
        taut.joints.push_back({.a = i, .b = i + 1, .stiffness = rigid, .restLength = Real(1)});
    const Body body = world.add(taut);
    for (int i = 0; i < 500; ++i) world.step();
    EXPECT_LT((world.position(body[1]) - Point(1, 0)).norm(), 0.1);
    EXPECT_EQ(world.validate(), "");
}

}  // namespace sulfur
