// Chains that go side by side in SIMD lanes move, to the last bit, as each does by itself.
#include "trees/chain_batches.hpp"

#include <gtest/gtest.h>

#include <sulfur/sulfur.hpp>

#include "helpers.hpp"
#include "kernels/chain_lanes.hpp"

namespace sulfur {

namespace {

constexpr detail::Instructions everything = detail::Instructions::avx512;

struct ChainPlan {
    unsigned links = 1;
    Real load = 1;  // masses of a link, on the last particle
    bool pinnedAtTheEnd = false;
    Vec2 push{0, 0};  // m/s
};

Blueprint chain(const ChainPlan& plan) {
    Blueprint blueprint;
    for (unsigned i = 0; i <= plan.links; ++i)
        blueprint.particles.push_back(
            {.position = Vec2(Real(0.03) * Real(i), Real(-0.04) * Real(i)),
             .mass = i == plan.links ? Real(0.05) * plan.load : Real(0.05),
             .pinned = i == 0 || (plan.pinnedAtTheEnd && i == plan.links)});
    for (unsigned i = 0; i < plan.links; ++i)
        blueprint.joints.push_back({.a = i, .b = i + 1, .stiffness = infinite});
    return blueprint;
}

Body add(World& world, const ChainPlan& plan, double x) {
    const Body body = world.add(chain(plan), {.position = {x, 0}});
    for (std::uint32_t i = 1; i + 1 < body.size(); ++i) world.setVelocity(body[i], plan.push);
    if (!plan.pinnedAtTheEnd) world.setVelocity(body[body.size() - 1], plan.push);
    return body;
}

/// All chains in one world, and each in a world of its own at the same place.
void expectTheSameBits(const std::vector<ChainPlan>& plans, std::uint32_t leastInLanes) {
    World together;
    std::vector<Body> bodies;
    std::vector<std::unique_ptr<World>> worlds;
    std::vector<Body> alone;
    for (std::size_t i = 0; i < plans.size(); ++i) {
        bodies.push_back(add(together, plans[i], 10.0 * static_cast<double>(i)));
        worlds.push_back(std::make_unique<World>());
        alone.push_back(add(*worlds.back(), plans[i], 10.0 * static_cast<double>(i)));
    }
    std::uint32_t most = 0;
    for (int tick = 0; tick < 400; ++tick) {
        together.step();
        most = std::max(most, together.statistics().chainsInLanes);
        for (const auto& world : worlds) {
            world->step();
            ASSERT_EQ(world->statistics().chainsInLanes, 0u);
        }
    }
    EXPECT_GE(most, leastInLanes);
    for (std::size_t i = 0; i < plans.size(); ++i) {
        for (std::uint32_t k = 0; k < bodies[i].size(); ++k) {
            EXPECT_EQ(together.position(bodies[i][k]), worlds[i]->position(alone[i][k]));
            EXPECT_EQ(together.velocity(bodies[i][k]), worlds[i]->velocity(alone[i][k]));
        }
        for (std::uint32_t k = 0; k < bodies[i].joints().size(); ++k)
            EXPECT_EQ(together.info(bodies[i].joints()[k]).force,
                      worlds[i]->info(alone[i].joints()[k]).force);
    }
}

std::uint64_t hashOfARow(detail::Instructions most) {
    detail::useKernelsUpTo(most);
    World world;
    for (unsigned i = 0; i < 21; ++i)
        add(world, {.links = 1 + i % 4, .load = Real(1 + i), .push = Vec2(1, Real(i))}, 5.0 * i);
    std::uint32_t inLanes = 0;
    for (int tick = 0; tick < 300; ++tick) {
        world.step();
        inLanes += world.statistics().chainsInLanes;
    }
    EXPECT_GT(inLanes, 4000u);
    EXPECT_EQ(world.validate(), "");
    detail::useKernelsUpTo(everything);
    return world.hash();
}

}  // namespace

TEST(ChainBatches, PendulumsMoveAsAlone) {
    std::vector<ChainPlan> plans(11);
    for (std::size_t i = 0; i < plans.size(); ++i) plans[i].push = Vec2(Real(i), 0);
    expectTheSameBits(plans, 8);
}

TEST(ChainBatches, RopesMoveAsAlone) {
    for (const unsigned links : {2u, 3u, 4u, 5u, 39u, 40u}) {
        std::vector<ChainPlan> plans(3, {.links = links});
        plans[1].push = Vec2(2, 1);
        plans[2].load = 100;
        expectTheSameBits(plans, 3);
    }
}

/// A heavy load takes more steps, a wild one falls back to the general solver.
TEST(ChainBatches, LanesOfDifferentStepsPartAndMeet) {
    std::vector<ChainPlan> plans(8, {.links = 20});
    plans[1].load = 1e4;
    plans[2].push = Vec2(300, 400);
    plans[3].load = 1e3;
    plans[5].push = Vec2(-30, 40);
    expectTheSameBits(plans, 5);
}

/// Those that are held at both ends are networks, beside which the others go in lanes.
TEST(ChainBatches, BesideSomeThatAreHeldAtBothEnds) {
    expectTheSameBits({{.links = 5, .pinnedAtTheEnd = true},
                       {.links = 5},
                       {.links = 5},
                       {.links = 5, .pinnedAtTheEnd = true}},
                      2);
}

TEST(ChainBatches, ChainsOfDifferentLengthsShareNoLanes) {
    World world;
    for (const unsigned links : {5u, 6u, 7u}) add(world, {.links = links}, links);
    world.step();
    EXPECT_EQ(world.statistics().trees, 3u);
    EXPECT_EQ(world.statistics().chainsInLanes, 0u);
}

TEST(ChainBatches, SameBitsWithAnyInstructions) {
    const auto baseline = hashOfARow(detail::Instructions::baseline);
    EXPECT_EQ(hashOfARow(detail::Instructions::avx2), baseline);
    EXPECT_EQ(hashOfARow(everything), baseline);
}

}  // namespace sulfur
