// What stages loop over follows each body that comes, goes, wakes or falls asleep. A restored world
// makes all its lists anew, and must go on to the bit.
#include <numeric>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// Whatever comes and goes at random, with much time to sleep in between.
class Household {
public:
    explicit Household(std::uint64_t seed, bool tied) : random_(seed), tied_(tied) {
        world.add(shapes::floor({-30, 0}, {30, 0}));
        Blueprint sensor = shapes::box({.size = {6, 2}});
        sensor.kind = BodyKind::fixed;
        sensor.sensor = true;
        world.add(sensor, {.position = {0, 1}});
        Blueprint lift = shapes::box({.size = {3, 0.5}});
        lift.kind = BodyKind::kinematic;
        lift_ = world.add(lift, {.position = {12, 1}});
        for (int i = 0; i < 30; ++i) add();
    }

    void act() {
        // What breaks to pieces without a surface goes.
        for (auto* list : {&bodies_, &fixed_})
            std::erase_if(*list, [&](BodyId id) { return !world.contains(id); });
        const std::size_t what = random_.below(40);
        if (what < 2)
            add();
        else if (what < 4 && bodies_.size() > 12)
            remove();
        else if (what == 4)
            world.setVelocity(any(), {Real(random_.uniform(-2, 2)), Real(random_.uniform(0, 3))});
        else if (what == 5)
            world.wake(any());
        else if (what == 6)
            world.moveTo(lift_, {{12, random_.uniform(0.6, 1.4)}, 0});
        else if (what == 7 && tied_)
            tie(any(), any());
        else if (what == 8)
            world.setPosition(world.particles(any())[0],
                              world.position(world.particles(any())[0]) + Point(0, 0.001));
    }

    World world;

private:
    void tie(BodyId a, BodyId b) {
        if (a != b) world.attach(world.particles(a)[0], b, {Real(0.1), 0});
    }
    BodyId any() { return bodies_[random_.below(bodies_.size())]; }

    void add() {
        const Pose pose{{random_.uniform(-15, 15), random_.uniform(0.6, 3)},
                        random_.uniform(-1, 1)};
        const std::size_t kind = random_.below(tied_ ? 8 : 6);
        const Real size = Real(random_.uniform(0.3, 1));
        Blueprint plan = shapes::box({.size = {size, size}});
        if (kind == 1) plan = shapes::ball({.radius = size / 2});
        if (kind == 2) plan = shapes::wheel({.radius = size / 2});
        if (kind == 3) plan = shapes::box({.size = {size, size / 2}, .strength = 900});
        if (kind == 6) plan = shapes::jelly({.size = {size, size}});
        if (kind == 7) plan = shapes::rope({.to = {1, 0}, .links = 6});
        if (kind == 0 && random_.below(4) == 0) plan.kind = BodyKind::fixed;
        const BodyId id = world.add(plan, pose).id();
        if (plan.kind == BodyKind::dynamic)
            bodies_.push_back(id);
        else
            fixed_.push_back(id);
    }
    void remove() {
        auto& list = !fixed_.empty() && random_.below(4) == 0 ? fixed_ : bodies_;
        const std::size_t k = random_.below(list.size());
        world.remove(list[k]);
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(k));
    }

    test::Random random_;
    bool tied_;
    BodyId lift_;
    std::vector<BodyId> bodies_, fixed_;
};

void expectThatRestoredWorldsGoOnAlike(bool tied) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Household house(seed, tied);
        World copy;
        for (int round = 0; round < 60; ++round) {
            for (int i = 0; i < 3; ++i) house.act();
            ASSERT_EQ(house.world.validate(), "") << "seed " << seed << ", round " << round;
            copy.restore(house.world.snapshot());
            for (int i = 0; i < 25; ++i) {
                house.world.step();
                copy.step();
                ASSERT_EQ(house.world.hash(), copy.hash())
                    << "seed " << seed << ", round " << round << ", tick " << i;
                ASSERT_EQ(house.world.statistics().awakeParticles,
                          copy.statistics().awakeParticles);
            }
        }
    }
}

TEST(WorkLists, FollowRigidBodiesAsIfMadeAnew) {
    expectThatRestoredWorldsGoOnAlike(false);
}

TEST(WorkLists, FollowWhatIsSoftOrTiedAsIfMadeAnew) {
    expectThatRestoredWorldsGoOnAlike(true);
}

/// Handles of what was removed stay void, also when their places are used again.
TEST(WorkLists, GapsAreClosedAndHandlesStayVoid) {
    World world;
    world.add(shapes::floor({-5, 0}, {500, 0}));
    std::vector<BodyId> gone, alive;
    for (int round = 0; round < 20; ++round) {
        for (int i = 0; i < 20; ++i)
            alive.push_back(world
                                .add(shapes::box(),
                                     {.position = {2.0 * static_cast<double>(alive.size()), 0.6}})
                                .id());
        for (int i = 0; i < 15; ++i) {
            const std::size_t k = static_cast<std::size_t>(7 * i) % alive.size();
            gone.push_back(alive[k]);
            world.remove(alive[k]);
            alive.erase(alive.begin() + static_cast<std::ptrdiff_t>(k));
        }
        ASSERT_EQ(world.validate(), "");
        for (const BodyId id : gone) ASSERT_FALSE(world.contains(id));
        for (const BodyId id : alive) ASSERT_TRUE(world.contains(id));
        ASSERT_EQ(world.bodies().size(), alive.size() + 1);
        world.step();
        EXPECT_EQ(world.statistics().bodies, alive.size() + 1);
    }
    const auto uses = world.memory();
    const auto bytes =
        std::accumulate(uses.begin(), uses.end(), std::size_t{0},
                        [](std::size_t sum, const MemoryUse& use) { return sum + use.bytes; });
    EXPECT_LT(bytes, 2000000u) << "gaps are closed";
}

/// A bent body is watched by its place among the bodies, which changes when gaps are closed.
TEST(WorkLists, WhatIsBentIsFollowedWhenGapsAreClosedAfterAnAddition) {
    World world;
    std::vector<BodyId> early;
    for (int i = 0; i < 6; ++i)
        early.push_back(world.add(shapes::box(), {Point(2.0 * i, 0), 0}).id());
    const Body bent = world.add(shapes::box(), {Point(20, 0), 0});
    world.step();
    world.setPosition(bent[0], world.position(bent[0]) + Point(0.3, 0.1));
    world.step();
    world.add(shapes::box(), {Point(30, 0), 0});
    for (const BodyId id : early) world.remove(id);
    world.step();
    EXPECT_EQ(world.validate(), "");
    test::run(world, 1);
    EXPECT_NEAR((world.position(bent[0]) - world.position(bent[1])).norm(), 0.9, 0.2);
}

}  // namespace
}  // namespace sulfur
