// Ticks of several steps: what a tick means stays the same.
#include "helpers.hpp"

namespace sulfur {
namespace {

using test::run;

WorldSettings settings(int rate, bool sleeping = false) {
    return {.tickRate = rate, .sleeping = sleeping};
}

/// A ball that goes on bouncing between walls at x metres.
Body addRestless(World& world, double x) {
    world.add(shapes::ground({.points = {{-2, 4}, {-2, 0}, {2, 0}, {2, 4}}}), {.position = {x, 0}});
    const Body ball = world.add(shapes::ball(), {.position = {x, 2}});
    world.setVelocity(ball.id(), {20, 0});
    world.setMaterial(ball.id(), {.restitution = 1});
    return ball;
}

Body addRope(World& world, double x) {
    return world.add(
        shapes::rope({.from = {0, 0}, .to = {2, 0}, .radius = 0, .bending = 0, .pinFirst = true}),
        {.position = {x, 0}});
}

TEST(Substeps, AreNoLongerThanOneIn480OfASecond) {
    for (const auto& [rate, steps] : {std::pair(60, 8u),
                                      {100, 5u},
                                      {120, 4u},
                                      {200, 3u},
                                      {240, 2u},
                                      {479, 2u},
                                      {480, 1u},
                                      {500, 1u},
                                      {2000, 1u}}) {
        World world(settings(rate));
        addRope(world, 0);
        world.step();
        EXPECT_EQ(world.statistics().substeps, steps) << rate;
    }
}

/// To the last bit: rope, jelly, crates and a ball that never rests go as in a world that steps as
/// often as this one divides its ticks.
TEST(Substeps, MoveThingsAsTicksOfTheirLengthDo) {
    const auto build = [](World& world) {
        addRestless(world, 20);
        addRope(world, 0);
        world.add(shapes::floor({-5, -3}, {5, -3}));
        world.add(shapes::jelly({.stiffness = 2000}), {.position = {-3, -1}});
        for (int i = 0; i < 3; ++i)
            world.add(shapes::box(), {.position = {2 + 0.1 * i, -2.3 + 1.2 * i}});
    };
    for (const int rate : {60, 120, 240}) {
        World coarse(settings(rate, true)), fine(settings(480, true));
        build(coarse), build(fine);
        for (int i = 0; i < 3 * rate; ++i) {
            coarse.step();
            for (int k = 0; k < 480 / rate; ++k) fine.step();
        }
        for (std::size_t b = 0; b < coarse.bodies().size(); ++b) {
            const auto same = fine.particles(fine.bodies()[b]);
            const auto own = coarse.particles(coarse.bodies()[b]);
            for (std::size_t k = 0; k < own.size(); ++k)
                ASSERT_EQ(coarse.position(own[k]), fine.position(same[k])) << rate << ' ' << b;
        }
    }
}

/// While all sleeps a tick costs nothing, however many steps it would have.
TEST(Substeps, AreNotTakenWhileAllSleeps) {
    World world(settings(120, true));
    world.add(shapes::floor({-5, 0}, {5, 0}));
    world.add(shapes::box(), {.position = {0, 0.5}});
    run(world, 3);
    const auto before = world.statistics().idleTicks;
    run(world, 1);
    EXPECT_EQ(world.statistics().idleTicks, before + 120);
}

/// Falls, targets of kinematic bodies, the clock, and what is told are those of the tick.
TEST(Substeps, KeepWhatATickMeans) {
    World world(settings(120));
    world.add(shapes::ground({.points = {{-5, 0}, {5, 0}}}));
    const Body ball = world.add(shapes::ball(), {.position = {0, 8}});
    Blueprint plan = shapes::box();
    plan.kind = BodyKind::kinematic;
    const Body lift = world.add(plan, {.position = {3, 5}});
    for (int i = 1; i <= 60; ++i) {
        world.moveTo(lift.id(), {.position = {3 + 0.1 * i, 5}});
        world.step();
        EXPECT_EQ(world.statistics().substeps, 4u);
        EXPECT_NEAR(world.centreOfMass(lift.id())[0], 3 + 0.1 * i, 1e-5);
    }
    EXPECT_DOUBLE_EQ(world.time(), 0.5);
    EXPECT_FLOAT_EQ(static_cast<float>(world.tickDuration()), 1.f / 120);
    EXPECT_NEAR(world.position(ball.front())[1], 8 - 9.81 / 2 * 0.25, 1e-4);
    int begun = 0;
    for (int i = 0; i < 240; ++i) {
        world.step();
        begun += static_cast<int>(world.events().contactsBegun.size());
    }
    EXPECT_EQ(begun, 1);
}

TEST(Substeps, KeepTheEnergyOfASpring) {
    World world(settings(120));
    world.setGravity({0, 0});
    Blueprint spring;
    spring.particles = {{.position = {0, 0}, .mass = 1, .radius = 0.3f},
                        {.position = {1, 0}, .mass = 1, .radius = 0.3f}};
    spring.joints = {{.a = 0, .b = 1, .stiffness = 50}};
    const Body body = world.add(spring);
    run(world, 1);
    world.setVelocity(body[0], {-2, 0}), world.setVelocity(body[1], {2, 0});
    run(world, 0.25);
    const double energy = world.energy();
    double most = 0;
    for (int i = 0; i < 600; ++i) {
        world.step();
        most = std::max(most, std::abs(world.energy() / energy - 1));
    }
    EXPECT_LT(most, 0.02);
}

/// A force acts for a whole tick, in however many steps.
TEST(Substeps, LetAppliedForcesActForTheWholeTick) {
    for (const double speed : {0.0, 20.0}) {
        World world(settings(120));
        world.setGravity({0, 0});
        const Body ball = world.add(shapes::ball({.mass = 2}));
        run(world, 1);
        world.setVelocity(ball.id(), {static_cast<float>(speed), 0});
        run(world, 0.1);
        for (int i = 0; i < 12; ++i) {
            for (const ParticleId id : world.particles(ball.id()))
                world.applyForce(id, {0, 10.f / static_cast<float>(ball.size())});
            world.step();
        }
        run(world, 0.1);
        EXPECT_NEAR(world.meanVelocity(ball.id())[1], 10 * 0.1 / 2, 1e-3) << speed;
    }
}

TEST(Substeps, LetABulletPushWhatWasCalm) {
    for (const int rate : {120, 240, 500}) {
        World world(settings(rate));
        world.setGravity({0, 0});
        const Body target = world.add(shapes::box({.mass = 1}), {.position = {0, 0}});
        run(world, 1);
        const Body bullet =
            world.add(shapes::ball({.radius = 0.1f, .mass = 1}), {.position = {-30, 0}});
        world.setVelocity(bullet.id(), {300, 0});
        run(world, 0.3);
        const double sum = static_cast<double>(world.meanVelocity(target.id())[0]) +
                           static_cast<double>(world.meanVelocity(bullet.id())[0]);
        EXPECT_NEAR(sum, 300, 0.1) << rate;
        EXPECT_GT(world.meanVelocity(target.id())[0], 140) << rate;
    }
}

TEST(Substeps, WakeSleepersThatAreHit) {
    World world(settings(120, true));
    world.add(shapes::ground({.points = {{-50, 0}, {50, 0}}}));
    addRope(world, 200);
    const Body sleeper = world.add(shapes::box(), {.position = {0, 0.5}});
    run(world, 3);
    ASSERT_TRUE(world.asleep(sleeper.id()));
    const Body ball = world.add(shapes::ball({.radius = 0.3f}), {.position = {-8, 0.4}});
    world.setVelocity(ball.id(), {15, 0});
    run(world, 1);
    EXPECT_FALSE(world.asleep(sleeper.id()));
    EXPECT_GT(world.centreOfMass(sleeper.id())[0], 0.3);
    run(world, 10);
    EXPECT_TRUE(world.asleep(sleeper.id()));
    EXPECT_EQ(world.validate(), "");
}

template <class Event>
std::pair<BodyId, BodyId> pairOf(const Event& e) {
    return std::minmax(e.a, e.b);
}

/// Who lies goes on touching, and is told once a tick.
TEST(Substeps, TellEachTouchOnce) {
    World world({.tickRate = 120, .sleeping = false, .tellPersisting = true});
    world.add(shapes::ground({.points = {{-5, 0}, {5, 0}}}));
    world.add(shapes::box(), {.position = {0, 0.6}});
    run(world, 2);
    addRestless(world, 100);
    std::size_t begun = 0, ended = 0;
    for (int i = 0; i < 240; ++i) {
        world.step();
        std::vector<std::pair<BodyId, BodyId>> pairs;
        for (const auto& e : world.events().contactsPersisted) pairs.push_back(pairOf(e));
        EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
        EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
        const auto resting = std::pair(world.bodies()[0], world.bodies()[1]);
        EXPECT_EQ(std::count(pairs.begin(), pairs.end(), resting), 1) << i;
        for (const auto& e : world.events().contactsBegun) begun += pairOf(e) == resting;
        for (const auto& e : world.events().contactsEnded) ended += pairOf(e) == resting;
    }
    EXPECT_EQ(begun + ended, 0u);
}

/// Balls that rebound in the middle of ticks: begun and ended say in turns who touches.
TEST(Substeps, TellWhoBeganAndEndedInTurns) {
    World world({.tickRate = 60, .sleeping = false, .tellPersisting = true});
    world.add(shapes::ground({.points = {{-6, 6}, {-6, 0}, {6, 0}, {6, 6}}}));
    addRope(world, 100);
    test::Random random(3);
    const auto uniform = [&](double most) {
        return static_cast<double>(random.bits() % 2001) / 1000 * most - most;
    };
    for (int i = 0; i < 8; ++i) {
        const Body ball =
            world.add(shapes::ball({.radius = 0.2f}), {.position = {uniform(5), 3 + uniform(2)}});
        world.setMaterial(ball.id(), {.restitution = 0.7f});
        world.setVelocity(ball.id(), Point(uniform(8), uniform(8)).cast<Real>());
    }
    std::vector<std::pair<BodyId, BodyId>> touching;
    const auto among = [&](const auto& pair) {
        return std::count(touching.begin(), touching.end(), pair);
    };
    for (int i = 0; i < 240; ++i) {
        world.step();
        const Events& events = world.events();
        for (const auto& e : events.contactsBegun) {
            EXPECT_EQ(among(pairOf(e)), 0);
            touching.push_back(pairOf(e));
        }
        for (const auto& e : events.contactsEnded) {
            EXPECT_EQ(among(pairOf(e)), 1);
            std::erase(touching, pairOf(e));
        }
        for (const auto& e : events.contactsPersisted) EXPECT_EQ(among(pairOf(e)), 1);
    }
}

/// Over a tick's duration the impulse of what lies is its weight, in however many steps.
TEST(Substeps, AddUpTheImpulsesOfATick) {
    World world({.tickRate = 120, .sleeping = false, .tellPersisting = true});
    world.add(shapes::ground({.points = {{-5, 0}, {5, 0}}}));
    for (int i = 0; i < 2; ++i) world.add(shapes::box({.mass = 2}), {.position = {0, 0.5 + i}});
    run(world, 3);
    ASSERT_EQ(world.events().contactsPersisted.size(), 2u);
    Real most = 0;
    for (const auto& e : world.events().contactsPersisted) most = std::max(most, e.impulse);
    EXPECT_NEAR(most * 120, 4 * 9.81, 0.4);
}

/// What is drawn between two ticks stands between its places in them.
TEST(Substeps, InterpolateBetweenTicks) {
    World world(settings(60));
    const Body ball = addRestless(world, 20), rope = addRope(world, 0);
    for (int i = 0; i < 120; ++i) {
        const Point before = world.position(ball[0]), end = world.position(rope.back());
        world.step();
        EXPECT_NEAR((world.interpolated(ball[0], 0) - before).norm(), 0, 1e-5);
        EXPECT_NEAR((world.interpolated(rope.back(), 0) - end).norm(), 0, 1e-5);
    }
}

TEST(Substeps, GoOnAfterASnapshot) {
    World world(settings(120));
    addRestless(world, 100);
    addRope(world, 0);
    world.add(shapes::jelly({.stiffness = 2000}), {.position = {50, 0}});
    run(world, 0.7);
    const auto saved = world.snapshot();
    World other(settings(500));
    other.restore(saved);
    EXPECT_EQ(other.hash(), world.hash());
    run(world, 1), run(other, 1);
    EXPECT_EQ(other.hash(), world.hash());
}

/// Something breaks within a tick, bodies are added and go, the rate changes: nothing is lost.
TEST(Substeps, OutliveChangesOfTheirBodies) {
    World world(settings(120, true));
    addRestless(world, 100);
    addRope(world, 0);
    Blueprint weak = shapes::rope({.from = {0, 0}, .to = {3, 0}, .radius = 0.05f});
    weak.particles.front().pinned = true;
    for (JointSpec& j : weak.joints) j.strength = 20;
    for (int i = 0; i < 20; ++i) {
        const Body rope = world.add(weak, {.position = {20.0 + 5 * i, 5}});
        run(world, 0.1);
        if (i % 3 == 0) world.remove(rope.id());
        if (i == 10) world.setTickRate(240);
        if (i == 13) world.setTickRate(600);
        if (i == 16) world.setTickRate(60);
        EXPECT_EQ(world.validate(), "");
    }
    run(world, 5);
    EXPECT_EQ(world.validate(), "");
}

TEST(Substeps, KeepTheEnergyOfAWeightOnARope) {
    for (const int rate : {60, 120, 240}) {
        World world(settings(rate));
        const Body rope = addRope(world, 0);
        const Body box =
            world.add(shapes::box({.size = {0.4f, 0.4f}, .mass = 5}), {.position = {2.2, 0}});
        world.connect(rope.back(), box[0], {.stiffness = 500, .damping = 1});
        world.step();
        const double start = world.energy();
        for (int i = 0; i < 6 * rate; ++i) {
            world.step();
            ASSERT_LT(world.energy(), start + 3) << rate << " Hz, tick " << i;
        }
    }
}

/// Balls at rest that one strikes one after the other: each goes on in the tick after its blow.
TEST(Substeps, KeepTheMomentumOfAShotAmongManyAtRest) {
    const Material smooth{.staticFriction = 0, .kineticFriction = 0, .restitution = 1};
    const Blueprint plan = shapes::ball({.radius = 0.1f, .mass = 1, .material = smooth});
    for (const int rate : {60, 120, 240}) {
        test::Random random(5);
        const auto noise = [&] { return static_cast<double>(random.bits() % 1000) / 5000 - 0.1; };
        for (int shot = 0; shot < 10; ++shot) {
            World world(settings(rate));
            world.setGravity({0, 0});
            for (int i = 0; i < 25; ++i)
                world.add(plan, {.position = {i % 5 * 0.6 + noise(), i / 5 * 0.6 + noise()}});
            run(world, 1);
            const Body ball = world.add(plan, {.position = {-2, 1.2 + noise()}});
            world.setVelocity(ball.id(), {30, 0});
            run(world, 1);
            Vec2 sum(0, 0);
            for (const BodyId id : world.bodies()) sum += world.meanVelocity(id);
            EXPECT_NEAR((sum - Vec2(30, 0)).norm(), 0, 0.01) << rate << " Hz, shot " << shot;
        }
    }
}

/// A body that stands still, and a sleeper, collect no forces.
TEST(Substeps, PullOnceOnWhatHangsOnAKinematicBody) {
    Blueprint plan;
    plan.kind = BodyKind::kinematic;
    plan.particles = {{.position = {0, 0}}};
    {
        World world(settings(120));
        addRope(world, 100);
        const Body anchor = world.add(plan, {.position = {0, 5}});
        const Body ball =
            world.add(shapes::ball({.radius = 0.1f, .mass = 1}), {.position = {0, 4}});
        world.connect(anchor[0], ball[0], {.stiffness = 50, .restLength = 1.f});
        world.setVelocity(ball.id(), {6, 0});
        run(world, 0.1);
        const double start = world.energy();
        for (int i = 0; i < 480; ++i) {
            world.step();
            EXPECT_NEAR(world.energy(), start, 0.1);
        }
    }
    for (const int rate : {120, 500}) {
        World world(settings(rate, true));
        addRope(world, 100);
        const Body anchor = world.add(plan, {.position = {0, 5}});
        const Body ball = world.add(shapes::ball({.radius = 0.1f}), {.position = {0, 4}});
        world.connect(anchor[0], ball[0], {.stiffness = 10, .damping = 4, .restLength = 1.f});
        run(world, 30);
        EXPECT_TRUE(world.asleep(ball.id()));
        world.wake(ball.id());
        run(world, 0.1);
        EXPECT_LT(world.meanVelocity(ball.id()).norm(), 0.01) << rate;
    }
}

}  // namespace
}  // namespace sulfur
