// Whom callbacks are asked about, what they may do, and what becomes of what they throw.
#include <stdexcept>
#include <utility>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

using Pairs = std::vector<std::pair<BodyId, BodyId>>;

Body addFloor(World& world) {
    return world.add(shapes::floor({-50, 0}, {50, 0}, Real(0.05)));
}

/// One of each kind above a floor at 0, side by side, 0.3 m above it.
std::vector<Body> addOneOfEach(World& world) {
    std::vector<Body> bodies;
    bodies.push_back(world.add(shapes::box(), {.position = {-4, 0.85}}));
    bodies.push_back(world.add(shapes::ball({.radius = Real(0.3)}), {.position = {-2, 0.65}}));
    bodies.push_back(world.add(shapes::jelly({.size = {1, 1}, .columns = 3, .rows = 3}),
                               {.position = {0, 0.85}}));
    bodies.push_back(world.add(
        shapes::rope({.from = {2, Real(0.37)}, .to = {4, Real(0.37)}, .radius = Real(0.03)})));
    return bodies;
}

double lowest(const World& world, BodyId body) {
    return world.bounds(body).low[1];
}

TEST(ShouldCollide, LetsThroughWhomItSays) {
    for (const int rate : {60, 500}) {
        World world({.tickRate = rate});
        const Body floor = addFloor(world);
        const std::vector<Body> bodies = addOneOfEach(world);
        const std::vector<Body> others = [&] {
            std::vector<Body> more;
            more.push_back(world.add(shapes::box(), {.position = {8, 0.85}}));
            more.push_back(
                world.add(shapes::ball({.radius = Real(0.3)}), {.position = {10, 0.65}}));
            return more;
        }();
        world.setShouldCollide([&](BodyId a, BodyId b) {
            return !(a == floor.id() &&
                     std::any_of(bodies.begin(), bodies.end(),
                                 [&](const Body& body) { return body.id() == b; }));
        });
        test::run(world, 1);
        for (const Body& body : bodies) EXPECT_LT(lowest(world, body), -1);
        for (const Body& other : others) EXPECT_NEAR(lowest(world, other), 0.05, 0.01);
        EXPECT_EQ(world.validate(), "");
    }
}

/// Neither what rows nor what continuous collision would hold.
TEST(ShouldCollide, LetsFastThingsThrough) {
    for (const int rate : {60, 500})
        for (const bool collides : {false, true}) {
            World world({.tickRate = rate});
            addFloor(world);
            const std::vector<Body> bodies = addOneOfEach(world);
            for (const Body& body : bodies) world.setVelocity(body, Vec2(0, -50));
            world.setShouldCollide([&](BodyId, BodyId) { return collides; });
            test::run(world, 0.1);
            for (const Body& body : bodies) {
                if (collides)
                    EXPECT_GT(lowest(world, body), -0.1);
                else
                    EXPECT_LT(world.bounds(body).high[1], -2);
            }
        }
}

TEST(ShouldCollide, IsAskedOnceWhileTwoAreNearEachOther) {
    World world({.sleeping = false});
    const Body floor = addFloor(world);
    const std::vector<Body> bodies = addOneOfEach(world);
    for (const bool answer : {true, false}) {
        Pairs asked;
        world.setShouldCollide([&](BodyId a, BodyId b) {
            asked.emplace_back(a, b);
            return answer;
        });
        // Material and filter make shapes anew, so that the second round asks again.
        for (const Body& body : bodies) world.setFilter(body, world.filter(body));
        test::run(world, answer ? 1 : 0.02);
        ASSERT_EQ(asked.size(), bodies.size());
        for (const auto& [a, b] : asked) EXPECT_TRUE(a == floor.id() && a < b);
    }
    world.setShouldCollide({});
    test::run(world, 1);
    for (const Body& body : bodies) EXPECT_LT(lowest(world, body), -1) << "the answer still holds";
}

TEST(ShouldCollide, IsAskedAgainWhenTwoHaveParted) {
    World world({.gravity = {0, 0}});
    const Body wall = world.add(shapes::floor({0, -2}, {0, 2}, Real(0.05)));
    const Body ball = world.add(shapes::ball({.radius = Real(0.2)}), {.position = {-1, 0}});
    int asked = 0;
    world.setShouldCollide([&](BodyId, BodyId) { return ++asked > 1; });
    world.setVelocity(ball, Vec2(5, 0));
    test::run(world, 0.5);
    EXPECT_EQ(asked, 1);
    EXPECT_GT(world.position(ball.front())[0], 1);
    world.setVelocity(ball, Vec2(-5, 0));
    test::run(world, 0.5);
    EXPECT_EQ(asked, 2);
    EXPECT_GT(world.position(ball.front())[0], 0.2);
    EXPECT_TRUE(world.contains(wall));
}

/// Who is put into something that he does not collide with is not led out of it, nor is he woken.
TEST(ShouldCollide, LetsBodiesRestInEachOther) {
    World world({.gravity = {0, 0}});
    const Body one = world.add(shapes::box());
    const Body other = world.add(shapes::box(), {.position = {0.3, 0.2}});
    world.setShouldCollide([](BodyId, BodyId) { return false; });
    test::run(world, 2);
    EXPECT_TRUE(world.asleep(one) && world.asleep(other));
    EXPECT_LT(world.centreOfMass(one).norm(), 1e-12);
    world.setVelocity(other, Vec2(1, 0));
    test::run(world, 0.1);
    EXPECT_TRUE(world.asleep(one));
    EXPECT_FALSE(world.asleep(other));
}

/// More than a hundred at one place, which take no room from what they stand on.
TEST(ShouldCollide, ACrowdThatPassesThroughItselfStaysOnTheFloor) {
    World world;
    const Body floor = addFloor(world);
    std::vector<Body> balls;
    for (int i = 0; i < 150; ++i)
        balls.push_back(world.add(shapes::ball({.radius = Real(0.2)}),
                                  {.position = {0.001 * i, 0.5 + 0.001 * i}}));
    world.setShouldCollide([&](BodyId a, BodyId) { return a == floor.id(); });
    test::run(world, 1);
    for (const Body& ball : balls) EXPECT_NEAR(lowest(world, ball), 0.05, 0.01);
}

TEST(ShouldCollide, AnswersAreInSnapshotsAndCallbacksAreNot) {
    World world, twin;
    addFloor(world);
    const std::vector<Body> bodies = addOneOfEach(world);
    world.setShouldCollide([](BodyId, BodyId) { return false; });
    int asked = 0;
    twin.setShouldCollide([&](BodyId, BodyId) { return ++asked > 0; });
    test::run(world, 0.2);
    twin.restore(world.snapshot());
    for (int i = 0; i < 20; ++i) {
        world.step();
        twin.step();
        ASSERT_EQ(world.hash(), twin.hash()) << i;
    }
    EXPECT_EQ(asked, 0);
    const Body box = twin.add(shapes::box(), {.position = {20, 0.5}});
    twin.step();
    EXPECT_EQ(asked, 1) << "restore() keeps the callbacks of the world that restores";
    EXPECT_TRUE(twin.contains(box));
}

/// Expects that `call` throws Error{inCallback}.
template <class Function>
void expectNoCall(const char* what, Function&& call) {
    try {
        call();
        ADD_FAILURE() << what << " is accepted";
    } catch (const Error& error) {
        EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(ErrorCode::inCallback)) << what;
        EXPECT_GT(std::string(error.what()).size(), 20u);
    }
}

/// All that a callback must not call.
void expectLocked(World& world, Body body, const Snapshot& snapshot) {
    const ParticleId particle = body.particles().front();
    const auto no = [](const char* what, auto&& call) { expectNoCall(what, call); };
    no("add", [&] { world.add(shapes::box()); });
    no("remove", [&] { world.remove(body.id()); });
    no("setGravity", [&] { world.setGravity({0, 1}); });
    no("setAirFriction", [&] { world.setAirFriction(1); });
    no("setTickRate", [&] { world.setTickRate(60); });
    no("setDamper", [&] { world.setDamper(Damper::full); });
    no("setMaterial", [&] { world.setMaterial(body.id(), Material{}); });
    no("setFilter", [&] { world.setFilter(body.id(), {}); });
    no("setUserData", [&] { world.setUserData(body.id(), 3); });
    no("setVelocity", [&] { world.setVelocity(body.id(), Vec2(1, 0)); });
    no("setPose", [&] { world.setPose(body.id(), {}); });
    no("setPosition", [&] { world.setPosition(particle, {0, 9}); });
    no("applyForce", [&] { world.applyForce(particle, {1, 0}); });
    no("applyImpulse", [&] { world.applyImpulse(particle, {1, 0}); });
    no("grab", [&] { world.grab(particle, {0, 0}); });
    no("attach", [&] { world.attach(particle, body.id(), {0, 0}); });
    no("field", [&] { world.add(Field{UniformField{}}); });
    no("wake", [&] { world.wake(body.id()); });
    no("step", [&] { world.step(); });
    no("restore", [&] { world.restore(snapshot); });
    no("snapshot", [&] { static_cast<void>(world.snapshot()); });
    no("hash", [&] { static_cast<void>(world.hash()); });
    no("validate", [&] { static_cast<void>(world.validate()); });
    no("query", [&] { static_cast<void>(world.bodiesAt({0, 0})); });
    no("ray", [&] { static_cast<void>(world.castRay({0, 0}, {1, 0}, 1)); });
    no("nearest", [&] { static_cast<void>(world.nearestParticle({0, 0}, 1)); });
    no("setTasks", [&] { world.setTasks(nullptr); });
    no("setProfiling", [&] { world.setProfiling(true); });
    no("setShouldCollide", [&] { world.setShouldCollide({}); });
    no("setPreSolve", [&] { world.setPreSolve({}); });
}

TEST(Callbacks, MayLookAndNotChange) {
    World world, untold;
    for (World* each : {&world, &untold}) {
        addFloor(*each);
        addOneOfEach(*each);
    }
    const Snapshot before = world.snapshot();
    int asked = 0;
    world.setShouldCollide([&](BodyId, BodyId b) {
        ++asked;
        expectLocked(world, world.body(b), before);
        EXPECT_GT(world.bounds(b).low[1], 0);
        EXPECT_GT(world.centreOfMass(b)[1], 0);
        EXPECT_EQ(world.kind(b), BodyKind::dynamic);
        return true;
    });
    int contacts = 0;
    world.setPreSolve([&](const PreSolveContact& contact, Material&) {
        ++contacts;
        expectLocked(world, world.body(contact.b), before);
        EXPECT_GT(world.bounds(contact.b).high[1], 0);
        EXPECT_GT(world.pose(contact.b).position[0], -5);
        return true;
    });
    for (int i = 0; i < 200; ++i) {
        world.step();
        untold.step();
        ASSERT_EQ(world.hash(), untold.hash()) << i;
    }
    EXPECT_EQ(asked, 4);
    EXPECT_GT(contacts, 100);
}

TEST(Callbacks, WhatTheyThrowComesOutOfAWholeTick) {
    World world, untold;
    for (World* each : {&world, &untold}) {
        addFloor(*each);
        addOneOfEach(*each);
    }
    int asked = 0;
    world.setShouldCollide([&](BodyId, BodyId) -> bool {
        ++asked;
        throw std::runtime_error("no answer");
    });
    int thrown = 0;
    for (int i = 0; i < 100; ++i) {
        try {
            world.step();
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "no answer");
            ++thrown;
        }
        untold.step();
        ASSERT_EQ(world.hash(), untold.hash()) << i;
        ASSERT_EQ(world.ticks(), untold.ticks());
        ASSERT_EQ(world.validate(), "");
    }
    EXPECT_GT(thrown, 0);
    EXPECT_EQ(asked, thrown) << "nobody is asked again in a tick in which he has thrown";
}

}  // namespace
}  // namespace sulfur
