#include <functional>

#include "helpers.hpp"

namespace sulfur {
namespace {

struct Lying : testing::Test {
    World world;
    Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    Body jelly = world.add(shapes::jelly({.damping = 4}), {.position = {0, 0.6}});
    Lying() { test::run(world, 8); }
};

TEST_F(Lying, FallsAsleepAndCostsNothing) {
    ASSERT_TRUE(world.asleep(jelly));
    EXPECT_EQ(world.statistics().awakeParticles, 0u);
    EXPECT_EQ(world.statistics().candidates, 0u);
    const Point before = world.centreOfMass(jelly);
    test::run(world, 1);
    EXPECT_EQ(world.centreOfMass(jelly), before);
}

TEST_F(Lying, WakesByForceGravityTouchAndLossOfSupport) {
    const auto state = world.snapshot();
    ASSERT_TRUE(world.asleep(jelly));
    world.applyForce(jelly[0], {1, 0});
    EXPECT_FALSE(world.asleep(jelly));
    world.restore(state);
    ASSERT_TRUE(world.asleep(jelly));
    world.setGravity({0, 1});
    EXPECT_FALSE(world.asleep(jelly));
    world.restore(state);
    world.add(shapes::ball(), {.position = {0, 3}});
    test::run(world, 1);
    EXPECT_FALSE(world.asleep(jelly));
    world.restore(state);
    world.remove(floor);
    EXPECT_FALSE(world.asleep(jelly));
    test::run(world, 1);
    EXPECT_LT(world.centreOfMass(jelly)[1], -3);
}

TEST_F(Lying, BearsWhatIsLaidOnItGently) {
    ASSERT_TRUE(world.asleep(jelly));
    const double before = world.centreOfMass(jelly)[1];
    double top = 0;
    for (const ParticleId p : jelly.particles()) top = std::max(top, world.position(p)[1]);
    world.add(shapes::box({.size = {2, Real(0.2)}, .mass = 8}), {.position = {0, top + 0.1301}});
    test::run(world, 2);
    EXPECT_LT(world.centreOfMass(jelly)[1], before - 0.02) << "is pressed flat";
}

TEST(Sleep, CanBeSwitchedOff) {
    World world({.sleeping = false});
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body jelly = world.add(shapes::jelly({.damping = 4}), {.position = {0, 0.6}});
    test::run(world, 8);
    EXPECT_FALSE(world.asleep(jelly));
}

TEST(Sleep, SlowDriftIsNotRest) {
    World world({.gravity = {0, 0}});
    const Body ball = world.add(shapes::ball());
    world.setVelocity(ball, {Real(0.01), 0});
    test::run(world, 3);
    EXPECT_FALSE(world.asleep(ball));
}

/// Runs until everything that is dynamic sleeps.
bool runUntilAsleep(World& world, double seconds = 20) {
    const auto resting = [&] {
        for (const BodyId id : world.bodies())
            if (world.kind(id) == BodyKind::dynamic && !world.asleep(id)) return false;
        return true;
    };
    const auto ticks = std::lround(seconds * world.settings().tickRate);
    for (long i = 0; i < ticks && !resting(); ++i) world.step();
    return resting();
}

Blueprint crate(double size = 1) {
    const auto side = static_cast<Real>(size);
    return shapes::box({.size = {side, side}});
}

/// A stack of three crates on a shelf, a plank that leans on the stack, and a lonely crate.
struct Stack : testing::Test {
    World world;
    Body ground = world.add(shapes::floor({-8, -2}, {8, -2}));
    Body shelf = world.add(shapes::floor({-3, 0}, {3, 0}));
    std::vector<Body> crates;
    Body lonely = world.add(crate(), {.position = {-6, -1.45}});
    Body leaning;
    Snapshot start;

    Stack() {
        for (int i = 0; i < 3; ++i)
            crates.push_back(world.add(crate(), {.position = {0, 0.55 + i}}));
        leaning = world.add(shapes::box({.size = {2, Real(0.1)}, .mass = Real(0.5)}),
                            {.position = {1.05, 0.97}, .angle = 2.1});
        EXPECT_TRUE(runUntilAsleep(world));
        start = world.snapshot();
    }
    std::vector<BodyId> heap() const {
        std::vector<BodyId> all(crates.begin(), crates.end());
        all.push_back(leaning);
        return all;
    }
    /// Does something to the sleepers and expects that `woken` and nobody else wake, at once or
    /// within a few ticks.
    void expectWakes(const char* what, const std::vector<BodyId>& woken,
                     const std::function<void()>& act, int ticks = 0) {
        world.restore(start);
        for (const BodyId id : heap()) ASSERT_TRUE(world.asleep(id)) << what;
        act();
        for (int i = 0; i < ticks; ++i) world.step();
        for (const BodyId id : woken) EXPECT_FALSE(world.asleep(id)) << what;
        for (const BodyId id : world.bodies()) {
            const bool meant = std::find(woken.begin(), woken.end(), id) != woken.end();
            if (world.kind(id) != BodyKind::dynamic || meant) continue;
            EXPECT_TRUE(world.asleep(id)) << what;
        }
        EXPECT_EQ(world.validate(), "") << what;
    }
};

TEST_F(Stack, WakesAsAWhole) {
    const auto heap = this->heap();
    for (const BodyId id : heap) expectWakes("wake", heap, [&] { world.wake(id); });
    expectWakes("wake the lonely one", {lonely}, [&] { world.wake(lonely); });
    const ParticleId lowest = crates[0].front();
    expectWakes("force", heap, [&] { world.applyForce(lowest, {0, 1}); });
    expectWakes("no force", {}, [&] { world.applyForce(lowest, {0, 0}); });
    expectWakes("impulse", heap, [&] { world.applyImpulse(lowest, {0, Real(0.1)}); });
    expectWakes("velocity", heap, [&] { world.setVelocity(crates[0], {0, 0}); });
    expectWakes("mass", heap, [&] { world.setMass(lowest, 3); });
    expectWakes("pin", heap, [&] { world.setPinned(lowest, true); });
    expectWakes("position", heap,
                [&] { world.setPosition(lowest, world.position(lowest) + Point(0.01, 0)); });
    expectWakes("grab", heap, [&] { world.grab(lowest, {0, 0}); });
    expectWakes("material", heap, [&] { world.setMaterial(crates[0], {.restitution = 1}); });
    expectWakes("joint material", heap,
                [&] { world.setMaterial(crates[0].joints()[0], Material{.restitution = 1}); });
    expectWakes("stiffness", heap, [&] { world.setStiffness(crates[0].joints()[0], 1e4); });
    expectWakes("filter", heap, [&] { world.setFilter(crates[0], {1, 0, 0}); });
    expectWakes("sensor", heap, [&] { world.setSensor(crates[0], true); });
    expectWakes("self-collision", heap, [&] { world.setSelfCollision(crates[0], true); });
    expectWakes("veto", heap, [&] { world.setCollision(crates[0], crates[1], false); });
    expectWakes("removal of a joint", heap, [&] { world.remove(crates[0].joints()[0]); });
    auto all = heap;
    all.push_back(lonely);
    expectWakes("gravity", all, [&] { world.setGravity({1, -9}); });
    expectWakes("attach", all, [&] { world.attach(lonely.front(), crates[2], {0, 0}); });
    expectWakes("connect", all,
                [&] { world.connect(lonely.front(), crates[1].front(), {.stiffness = 1}); });
}

TEST_F(Stack, LosesItsSupport) {
    const auto heap = this->heap();
    auto left = heap;
    left.erase(left.begin());
    expectWakes("removal of the lowest", left, [&] { world.remove(crates[0]); });
    test::run(world, 0.3);
    EXPECT_LT(world.centreOfMass(crates[2])[1], 2.3);
    left = heap;
    left.pop_back();
    expectWakes("removal of what leans", left, [&] { world.remove(leaning); });
    expectWakes("removal of the shelf", heap, [&] { world.remove(shelf); });
    expectWakes("shelf moved", heap, [&] { world.setPosition(shelf[0], {-3, -0.5}); });
    expectWakes("shelf's filter", heap, [&] { world.setFilter(shelf, {1, 0, 0}); });
    expectWakes("shelf a sensor", heap, [&] { world.setSensor(shelf, true); });
    expectWakes("shelf passable", heap, [&] { world.setCollision(shelf, crates[0], false); });
    expectWakes("slippery shelf", heap, [&] { world.setMaterial(shelf, {0, 0, 0}); });
    expectWakes("slippery plank of the shelf", heap, [&] {
        world.setMaterial(shelf.joints()[0], Material{0, 0, 0});
    });
    expectWakes("belt", heap, [&] { world.setMaterial(shelf, {.surfaceSpeed = 1}); });
    expectWakes("removal of the shelf's joint", heap, [&] { world.remove(shelf.joints()[0]); });
    test::run(world, 0.3);
    EXPECT_LT(world.centreOfMass(crates[0])[1], 0.3) << "falls";
}

TEST_F(Stack, IsHit) {
    const auto heap = this->heap();
    for (const double height : {0.55, 2.55}) {
        world.restore(start);
        const Body ball =
            world.add(shapes::ball({.mass = Real(0.2)}), {.position = {-0.9, height}});
        world.setVelocity(ball, {5, 0});
        bool touched = false;
        for (int i = 0; i < 500 && !touched; ++i) {
            const bool far = world.position(ball.front())[0] < -0.8;
            for (const BodyId id : heap) EXPECT_TRUE(world.asleep(id) || !far) << "tick " << i;
            world.step();
            touched = !world.events().contactsBegun.empty();
        }
        ASSERT_TRUE(touched);
        world.step();
        for (const BodyId id : heap) EXPECT_FALSE(world.asleep(id)) << height;
        EXPECT_TRUE(world.asleep(lonely));
    }
}

TEST_F(Stack, NoticesWhatIsPutInItsPlace) {
    const auto heap = this->heap();
    expectWakes(
        "a fixed floor through the lowest crate", heap,
        [&] {
            world.add(shapes::floor({-1, 0.5}, {1, 0.5}));
        },
        1);
    expectWakes(
        "a fixed floor elsewhere", {},
        [&] {
            world.add(shapes::floor({-1, 9}, {1, 9}));
        },
        2);
    Blueprint paddle = shapes::floor({-1, 0.5}, {1, 0.5});
    paddle.kind = BodyKind::kinematic;
    expectWakes(
        "a kinematic paddle", heap, [&] { world.add(paddle); }, 2);
    paddle.filter.mask = 0;
    expectWakes(
        "a paddle that passes", {}, [&] { world.add(paddle); }, 2);
    expectWakes("a paddle that no longer does", heap, [&] {
        const Body body = world.add(paddle);
        world.step();
        world.setFilter(body, {});
    });
    auto all = heap;
    all.push_back(lonely);
    expectWakes("the ground, moved there", all, [&] {
        world.setPosition(ground[0], {-8, 0.5});
        world.setPosition(ground[1], {8, 0.5});
    });
    expectWakes(
        "a shot by a query", {},
        [&] {
            EXPECT_TRUE(world.castRay({0, 9}, {0, -1}, 9).has_value());
            EXPECT_FALSE(world.bodiesAt({0, 0.5}).empty());
        },
        1);
}

TEST_F(Stack, KeepsItsContactsAndTellsNothing) {
    const auto told = [&] {
        const Events& e = world.events();
        return e.contactsBegun.size() + e.contactsEnded.size();
    };
    const auto contacts = world.contacts();
    ASSERT_GE(contacts.size(), 8u);
    for (int i = 0; i < 5; ++i) {
        world.step();
        EXPECT_EQ(told(), 0u) << "asleep";
    }
    EXPECT_EQ(world.contacts().size(), contacts.size());
    double weight = 0;
    for (const ContactInfo& c : world.contacts())
        if (c.b == shelf.id() || c.a == shelf.id())
            weight +=
                static_cast<double>(c.impulse) * 500 * std::abs(static_cast<double>(c.normal[1]));
    EXPECT_NEAR(weight, 3.5 * 9.81, 0.05 * 3.5 * 9.81);
    world.wake(crates[1]);
    for (int i = 0; i < 20; ++i) {
        world.step();
        EXPECT_EQ(told(), 0u) << "awake, tick " << i;
    }
    EXPECT_TRUE(runUntilAsleep(world));
    EXPECT_EQ(told(), 0u);
    EXPECT_EQ(world.validate(), "");
}

TEST_F(Stack, IsTheSameAfterARestore) {
    World other;
    other.restore(start);
    EXPECT_EQ(other.hash(), world.hash());
    for (World* w : {&world, &other}) {
        w->applyImpulse(crates[1].front(), {Real(0.3), 0});
        for (const BodyId id : heap()) EXPECT_FALSE(w->asleep(id));
        test::run(*w, 1);
    }
    EXPECT_EQ(other.hash(), world.hash());
}

/// A hit on the top crate must not end and begin the contacts below it.
TEST(Sleep, WakingEndsNoContact) {
    World world;
    const Body floor = world.add(shapes::floor({-3, 0}, {3, 0}));
    const Body low = world.add(crate(), {.position = {0, 0.55}});
    const Body top = world.add(crate(), {.position = {0, 1.55}});
    ASSERT_TRUE(runUntilAsleep(world));
    const Body ball = world.add(shapes::ball({.mass = Real(0.1)}), {.position = {0, 3}});
    for (int i = 0; i < 1000; ++i) {
        world.step();
        for (const ContactBegun& e : world.events().contactsBegun)
            EXPECT_TRUE(e.a == ball.id() || e.b == ball.id()) << "tick " << i;
        for (const ContactEnded& e : world.events().contactsEnded)
            EXPECT_TRUE(e.a == ball.id() || e.b == ball.id()) << "tick " << i;
    }
    EXPECT_TRUE(world.contains(floor) && world.contains(low) && world.contains(top));
}

/// Whatever part of the tick has passed when it hits.
TEST(Sleep, ASleeperTakesTheMomentumOfAShot) {
    for (const double speed : {5.0, 50.0, 300.0})
        for (const double start : {-3.0, -3.1, -3.17, -3.33}) {
            World world({.gravity = {0, 0}});
            const Body box = world.add(crate());
            const Body aside = world.add(crate(), {.position = {0, 40}});
            ASSERT_TRUE(runUntilAsleep(world));
            const Body ball =
                world.add(shapes::ball({.radius = Real(0.1)}), {.position = {start, 0}});
            world.setVelocity(ball, {static_cast<Real>(speed), 0});
            test::run(world, 6 / speed + 0.1);
            for (const BodyId id : {box.id(), ball.id()}) {
                const auto v = static_cast<double>(world.meanVelocity(id)[0]);
                EXPECT_NEAR(v / speed, 0.5, 0.005) << speed << " m/s from " << start;
            }
            EXPECT_TRUE(world.asleep(aside));
        }
}

TEST(Sleep, WhatLandsOnASleeperJoinsIt) {
    World world;
    world.add(shapes::floor({-3, 0}, {3, 0}));
    const Body low = world.add(crate(), {.position = {0, 0.55}});
    ASSERT_TRUE(runUntilAsleep(world));
    for (const double drop : {1e-4, 0.3}) {
        const Body next = world.add(crate(), {.position = {0, 1.55 + drop}});
        ASSERT_TRUE(runUntilAsleep(world));
        const auto asleep = world.snapshot();
        world.wake(low);
        EXPECT_FALSE(world.asleep(next)) << drop;
        world.restore(asleep);
        world.wake(next);
        EXPECT_FALSE(world.asleep(low)) << drop;
        world.restore(asleep);
        world.remove(next);
        ASSERT_TRUE(runUntilAsleep(world));
    }
}

/// A crate asleep on a kinematic platform.
struct Platform : testing::Test {
    World world;
    Body platform = world.add(plan(), {.position = {0, 0}});
    Body box = world.add(crate(), {.position = {0.5, 0.55}});
    Snapshot start;

    static Blueprint plan() {
        Blueprint plan = shapes::floor({0, 0}, {2, 0});
        plan.kind = BodyKind::kinematic;
        return plan;
    }
    Platform() {
        EXPECT_TRUE(runUntilAsleep(world));
        start = world.snapshot();
    }
};

TEST_F(Platform, TakesItsSleepersAlong) {
    for (const Vec2& velocity :
         {Vec2(0, Real(0.4)), Vec2(0, Real(-0.4)), Vec2(Real(0.4), 0), Vec2(0, Real(-0.004)),
          Vec2(Real(0.004), 0), Vec2(0, Real(0.004))}) {
        for (const bool towards : {false, true}) {
            world.restore(start);
            ASSERT_TRUE(world.asleep(box));
            const Point before = world.centreOfMass(box);
            if (!towards) world.setVelocity(platform, velocity);
            for (int i = 1; i <= 1000; ++i) {
                if (towards) world.moveTo(platform, {velocity.cast<double>() * (i * 0.002), 0});
                world.step();
                ASSERT_FALSE(world.asleep(box)) << velocity.transpose() << ", tick " << i;
            }
            const Point moved = world.centreOfMass(box) - before;
            // It slides until kinetic friction has brought it to the speed of the platform.
            const double slip = std::pow(static_cast<double>(velocity[0]), 2) / (2 * 0.5 * 9.81);
            EXPECT_NEAR((moved - 2 * velocity.cast<double>()).norm(), slip, 0.002)
                << velocity.transpose() << (towards ? " by moveTo" : " by setVelocity");
            world.setVelocity(platform, {0, 0});
            EXPECT_TRUE(runUntilAsleep(world)) << velocity.transpose();
        }
    }
}

TEST(SleepOnADriver, WhatWakesOnAKinematicCrateStaysOnIt) {
    World world;
    Blueprint plan = shapes::box({.size = {4, 1}});
    plan.kind = BodyKind::kinematic;
    const Body platform = world.add(plan, {.position = {0, 0}});
    const Body box = world.add(crate(), {.position = {0.5, 1.05}});
    ASSERT_TRUE(runUntilAsleep(world));
    const Point before = world.centreOfMass(box);
    world.setVelocity(platform, {Real(0.4), 0});
    for (int i = 0; i < 1000; ++i) world.step();
    const Point moved = world.centreOfMass(box) - before;
    EXPECT_NEAR(moved[0], 0.8 - 0.4 * 0.4 / (2 * 0.5 * 9.81), 0.002);
    EXPECT_NEAR(moved[1], 0, 1e-4);
}

TEST_F(Platform, WakesItsSleepersWhenItTurnsAboutItsEnd) {
    for (const double rate : {0.3, -0.3}) {
        world.restore(start);
        ASSERT_TRUE(world.asleep(box));
        for (int i = 1; i <= 250; ++i) {
            world.moveTo(platform, {{0, 0}, rate * i / 500});
            world.step();
            EXPECT_FALSE(world.asleep(box)) << rate << ", tick " << i;
        }
        EXPECT_NEAR(world.centreOfMass(box)[1], 0.55 + 0.5 * std::tan(rate / 2), 0.03) << rate;
    }
}

TEST_F(Platform, PullsWhatHangsOnItHoweverSlowly) {
    World hanging({.gravity = {0, -10}});
    const Body hook = hanging.add(plan(), {.position = {0, 3}});
    const Body ball = hanging.add(shapes::ball(), {.position = {0, 2}});
    hanging.connect(hook[0], ball.front());
    ASSERT_TRUE(runUntilAsleep(hanging));
    hanging.setVelocity(hook, {0, Real(0.01)});
    test::run(hanging, 2);
    EXPECT_NEAR(hanging.position(ball.front())[1], 2.02, 1e-3);
}

TEST_F(Platform, AKinematicBodyThatRunsIntoASleeperWakesIt) {
    for (const double speed : {0.01, 1.0, 50.0}) {
        world.restore(start);
        const Body wall = world.add(plan(), {.position = {-0.1, 0.3}, .angle = 1.57});
        world.setVelocity(wall, {static_cast<Real>(speed), 0});
        test::run(world, 0.1 / speed + 1);
        EXPECT_FALSE(world.asleep(box)) << speed;
        EXPECT_GT(world.centreOfMass(box)[0], 0.5) << speed;
    }
}

/// What lies on a joint between a fixed and a dynamic body rests on both.
TEST(Sleep, WhatLiesOnAConnectionWakesWithBothEnds) {
    World world;
    const Body left = world.add(shapes::floor({-3, 0}, {-1, 0}));
    const Body right = world.add(shapes::ball({.radius = Real(0.1)}), {.position = {1, 0}});
    world.setPinned(right.front(), true);
    const JointId plank = world.connect(left[1], right.front(), {.radius = Real(0.05)});
    const Body box = world.add(crate(), {.position = {0, 0.55}});
    ASSERT_TRUE(runUntilAsleep(world));
    const auto start = world.snapshot();
    const std::vector<std::function<void()>> acts{
        [&] { world.remove(right); }, [&] { world.remove(left); }, [&] { world.remove(plank); },
        [&] { world.setPinned(right.front(), false); }, [&] { world.wake(right); }};
    for (std::size_t i = 0; i < acts.size(); ++i) {
        world.restore(start);
        ASSERT_TRUE(world.asleep(box));
        acts[i]();
        EXPECT_FALSE(world.asleep(box)) << i;
        test::run(world, 0.3);
        const bool falls = i < 4;
        EXPECT_EQ(world.centreOfMass(box)[1] < 0.45, falls) << i;
        EXPECT_EQ(world.validate(), "");
    }
}

/// Breaking takes bodies away in the tick in which a sleeper is run into.
TEST(Sleep, BodiesMayVanishInTheTickOfAKnock) {
    World world({.gravity = {0, 0}});
    Blueprint pair;
    pair.particles = {{{0, 0}, 1, 0, true}, {{1, 0}, 1, 0, false}};
    pair.joints = {{.a = 0, .b = 1, .stiffness = 1e4, .strength = 5}};
    std::vector<Body> vanishing;
    for (int i = 0; i < 40; ++i)
        vanishing.push_back(world.add(pair, {.position = {20, double(i)}}));
    const Body box = world.add(crate(), {.position = {0, 0}});
    ASSERT_TRUE(runUntilAsleep(world));
    Blueprint paddle = shapes::floor({-1, -1}, {-1, 1});
    paddle.kind = BodyKind::kinematic;
    const Body wall = world.add(paddle, {});
    for (const Body& body : vanishing) world.setVelocity(body[1], {1000, 0});
    for (int i = 0; i < 5 && world.events().jointsBroken.empty(); ++i) {
        ASSERT_TRUE(world.asleep(box));
        const auto before = world.snapshot();
        world.step();
        if (world.events().jointsBroken.empty()) continue;
        world.restore(before);
        world.moveTo(wall, {{0.6, 0}, 0});
        world.step();
    }
    ASSERT_EQ(world.events().jointsBroken.size(), vanishing.size());
    ASSERT_EQ(world.bodies().size(), 2u) << "all that broke is gone";
    EXPECT_FALSE(world.asleep(box));
    EXPECT_EQ(world.validate(), "");
}

}  // namespace
}  // namespace sulfur
