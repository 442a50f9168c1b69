// What the caller makes of contacts before they are solved: one-way platforms, belts, ice.
#include <cstring>
#include <sulfur/thread_pool.hpp>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr double thickness = 0.05;  // m, half of that of a floor

Body addPlatform(World& world, double height = 0) {
    const Real y = static_cast<Real>(height);
    return world.add(shapes::floor({-50, y}, {50, y}, static_cast<Real>(thickness)));
}

/// Of each kind one, whose middles are at a height.
std::vector<Body> addKinds(World& world, double height) {
    const Real y = static_cast<Real>(height);
    std::vector<Body> bodies;
    bodies.push_back(world.add(shapes::box({.size = {1, 1}}), {.position = {-6, height}}));
    bodies.push_back(world.add(shapes::ball({.radius = Real(0.3)}), {.position = {-3, height}}));
    bodies.push_back(world.add(
        shapes::jelly({.size = {1, 1}, .columns = 3, .rows = 3, .stiffness = 2000, .damping = 5}),
        {.position = {0, height}}));
    bodies.push_back(world.add(shapes::rope({.from = {3, y}, .to = {4, y}, .radius = Real(0.03)})));
    return bodies;
}

/// The rule that setPreSolve() recommends.
void makeOneWay(World& world, BodyId platform, double middle) {
    world.setPreSolve([&world, platform, middle](const PreSolveContact& contact, Material&) {
        if (contact.a != platform && contact.b != platform) return true;
        const BodyId other = contact.a == platform ? contact.b : contact.a;
        return world.bounds(other).low[1] > middle;
    });
}

double lowEnd(const World& world, BodyId body) {
    return world.bounds(body).low[1];
}

/// The twin without a platform shows that nobody is braked on his way up. What is in the upper half
/// of a platform is pushed out of it, by some millimetres.
TEST(PreSolve, OneWayPlatformsLetThroughFromBelowAndHoldFromAbove) {
    for (const int rate : {60, 500}) {
        World world({.tickRate = rate}), twin({.tickRate = rate});
        const Body platform = addPlatform(world);
        makeOneWay(world, platform.id(), 0);
        const std::vector<Body> bodies = addKinds(world, -2), free = addKinds(twin, -2);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            world.setVelocity(bodies[i], Vec2(0, 9));
            twin.setVelocity(free[i], Vec2(0, 9));
        }
        test::run(world, 0.9);
        test::run(twin, 0.9);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            EXPECT_GT(lowEnd(world, bodies[i]), 0.5) << rate << " Hz, " << i;
            EXPECT_NEAR(lowEnd(world, bodies[i]), lowEnd(twin, free[i]), 0.005);
        }
        test::run(world, 2);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            EXPECT_NEAR(lowEnd(world, bodies[i]), thickness, 0.02) << rate << " Hz, " << i;
        EXPECT_EQ(world.validate(), "");
    }
}

TEST(PreSolve, OneWayPlatformsAreOneWayAtFiftyMetresASecond) {
    for (const int rate : {60, 500})
        for (const double sign : {1.0, -1.0})
            for (int start = 0; start < 7; ++start) {
                World world({.gravity = {0, 0}, .tickRate = rate});
                const Body platform = addPlatform(world);
                makeOneWay(world, platform.id(), 0);
                const std::vector<Body> bodies = addKinds(world, -sign * (2 + 0.021 * start));
                for (const Body& body : bodies)
                    world.setVelocity(body, Vec2(0, static_cast<Real>(50 * sign)));
                test::run(world, 0.1);
                for (std::size_t i = 0; i < bodies.size(); ++i) {
                    SCOPED_TRACE(::testing::Message() << rate << " Hz, " << sign << ", " << i);
                    if (sign > 0) {
                        EXPECT_GT(lowEnd(world, bodies[i]), 1.5);
                        EXPECT_NEAR(world.meanVelocity(bodies[i])[1], 50, 0.01);
                    } else {
                        EXPECT_GT(lowEnd(world, bodies[i]), -thickness);
                    }
                }
            }
}

/// What comes to stand in a platform, and does not act yet, falls back out of it.
TEST(PreSolve, WhatDoesNotComeThroughFallsBack) {
    World world;
    const Body platform = addPlatform(world);
    makeOneWay(world, platform.id(), 0);
    const std::vector<Body> bodies = addKinds(world, -1.1);
    for (const Body& body : bodies) world.setVelocity(body, Vec2(0, Real(4.5)));
    double highest = -1;
    for (int i = 0; i < 500; ++i) {
        world.step();
        highest = std::max(highest, world.bounds(bodies[0]).high[1]);
    }
    EXPECT_GT(highest, 0.25);
    for (const Body& body : bodies) EXPECT_LT(world.bounds(body).high[1], -0.5);
}

/// Of one floor that is whole for everybody else.
TEST(PreSolve, AContactDoesNotActWhereTheCallerSaysSo) {
    World world;
    addPlatform(world);
    const std::vector<Body> bodies = addKinds(world, 1);
    world.setPreSolve([](const PreSolveContact& contact, Material&) {
        return contact.point[0] < -4.5 || contact.point[0] > 2;
    });
    test::run(world, 1.5);
    EXPECT_GT(lowEnd(world, bodies[0]), 0);
    EXPECT_LT(lowEnd(world, bodies[1]), -1);
    EXPECT_LT(lowEnd(world, bodies[2]), -1);
    EXPECT_GT(lowEnd(world, bodies[3]), 0);
}

TEST(PreSolve, ALiftWithOneWayTakesAlongWhatHasComeThroughIt) {
    for (const int rate : {60, 500}) {
        World world({.tickRate = rate});
        Blueprint plan = shapes::box({.size = {20, Real(2 * thickness)}});
        plan.kind = BodyKind::kinematic;
        const Body lift = world.add(plan);
        world.setVelocity(lift, Vec2(0, 1));
        world.setPreSolve([&](const PreSolveContact& contact, Material&) {
            const BodyId other = contact.a == lift.id() ? contact.b : contact.a;
            return lowEnd(world, other) > world.centreOfMass(lift)[1];
        });
        const std::vector<Body> bodies = addKinds(world, -1.5);
        for (const Body& body : bodies) world.setVelocity(body, Vec2(0, 9));
        test::run(world, 3);
        EXPECT_NEAR(world.centreOfMass(lift)[1], 3, 0.01);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            EXPECT_NEAR(lowEnd(world, bodies[i]), 3 + thickness, 0.02) << rate << " Hz, " << i;
    }
}

/// Where a sleeper lies in somebody who came later, neither wakes the other again and again.
TEST(PreSolve, WhoRestsInEachOtherFallsAsleep) {
    World world({.gravity = {0, 0}});
    const Body one = world.add(shapes::box());
    const Body other = world.add(shapes::box(), {.position = {-2, 0.2}});
    world.setPreSolve([](const PreSolveContact&, Material&) { return false; });
    world.setVelocity(other, Vec2(1, 0));
    test::run(world, 1.7);
    EXPECT_LT(world.centreOfMass(one).norm(), 1e-12);
    world.setVelocity(other, Vec2(0, 0));
    test::run(world, 2);
    EXPECT_NEAR(world.centreOfMass(other)[0], -0.3, 0.01);
    EXPECT_TRUE(world.asleep(one) && world.asleep(other));
}

/// As belts of Material do it, on either side of the pair.
TEST(PreSolve, BeltsCarryWhatLiesOnThemAtTheirSpeed) {
    for (const int rate : {60, 500})
        for (const bool floorFirst : {true, false}) {
            World world({.tickRate = rate, .sleeping = false});
            if (floorFirst) addPlatform(world);
            const std::vector<Body> bodies = addKinds(world, 0.6);
            if (!floorFirst) addPlatform(world);
            world.setPreSolve([](const PreSolveContact&, Material& surface) {
                surface.surfaceSpeed = 2;
                return true;
            });
            test::run(world, 3);
            for (std::size_t i = 0; i < bodies.size(); ++i)
                EXPECT_NEAR(world.meanVelocity(bodies[i])[0], 2, 0.05) << rate << " Hz, " << i;
        }
}

/// A second after it was let go at 6 m/s on a floor that brakes it by g / 2, but not between 1
/// and 3.
TEST(PreSolve, IceIsWhereTheCallerSaysSo) {
    for (const int rate : {60, 500}) {
        World world({.tickRate = rate, .sleeping = false});
        addPlatform(world);
        const Body crate = world.add(shapes::box(), {.position = {0, 0.5 + thickness}});
        world.setPreSolve([](const PreSolveContact& contact, Material& surface) {
            if (contact.point[0] > 1 && contact.point[0] < 3)
                surface.staticFriction = surface.kineticFriction = 0;
            return true;
        });
        test::run(world, 0.1);
        world.setVelocity(crate, Vec2(6, 0));
        double atOne = 0, atThree = 0;
        for (int i = 0; i < rate; ++i) {
            world.step();
            const double x = world.centreOfMass(crate)[0];
            const double speed = static_cast<double>(world.meanVelocity(crate)[0]);
            if (x < 1) atOne = speed;
            if (x < 3) atThree = speed;
        }
        const double brakes = 9.81 * 0.5, slower = std::sqrt(36 - 2 * brakes);
        EXPECT_NEAR(atOne, slower, 0.12);
        EXPECT_NEAR(atThree, atOne, 0.12);
        EXPECT_NEAR(world.meanVelocity(crate)[0], 6 - brakes * (1 - 2 / slower), 0.15);
    }
}

TEST(PreSolve, WhatBouncesNowhereElseBouncesWhenTheCallerSaysSo) {
    World world({.sleeping = false});
    addPlatform(world, -thickness);
    const Body ball = world.add(shapes::ball({.radius = Real(0.3)}), {.position = {0, 1.3}});
    world.setPreSolve([](const PreSolveContact&, Material& surface) {
        surface.restitution = Real(0.8);
        return true;
    });
    double highest = 0;
    bool rose = false;
    for (int i = 0; i < 500; ++i) {
        world.step();
        const double v = static_cast<double>(world.velocity(ball.front())[1]);
        if (rose && v < 0) break;
        rose |= v > 0;
        if (rose) highest = std::max(highest, world.position(ball.front())[1] - 0.3);
    }
    EXPECT_NEAR(highest, 0.64, 0.02);
}

/// Through a row of balls that touch each other already, as Newton's cradle does.
TEST(PreSolve, ABlowGoesOnThroughWhatBouncesByAnAnswer) {
    World world({.gravity = {0, 0}});
    std::vector<Body> balls;
    for (int i = 0; i < 4; ++i)
        balls.push_back(world.add(shapes::ball({.radius = Real(0.25)}),
                                  {.position = {i == 0 ? -1.0 : 0.5 * i, 0}}));
    world.setPreSolve([](const PreSolveContact&, Material& surface) {
        surface.restitution = 1;
        return true;
    });
    world.setVelocity(balls[0], Vec2(5, 0));
    for (int i = 0; i < 1000 && world.meanVelocity(balls[0])[0] > 1; ++i) world.step();
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(world.meanVelocity(balls[static_cast<std::size_t>(i)])[0], i == 3 ? 5 : 0, 1e-3)
            << i;
}

/// With the paper's friction, kinetic friction is its constant, in N s/m.
TEST(PreSolve, ChangesTheFrictionOfThePaperToo) {
    for (const Real friction : {Real(0), Real(0.5)}) {
        World world({.sleeping = false, .friction = Friction::sliding});
        addPlatform(world);
        const Body crate = world.add(shapes::box(), {.position = {0, 0.5 + thickness}});
        Real seen = -1;
        world.setPreSolve([&](const PreSolveContact&, Material& surface) {
            seen = surface.kineticFriction;
            surface.kineticFriction = surface.staticFriction = friction;
            return true;
        });
        test::run(world, 0.1);
        world.setVelocity(crate, Vec2(4, 0));
        test::run(world, 0.5);
        EXPECT_EQ(seen, Real(0.5));
        if (friction == 0)
            EXPECT_NEAR(world.meanVelocity(crate)[0], 4, 1e-3);
        else
            EXPECT_LT(world.meanVelocity(crate)[0], 3.8);
    }
}

TEST(PreSolve, TellsWhereAndHowFastTwoMeet) {
    for (const bool floorFirst : {true, false}) {
        World world({.gravity = {0, 0}});
        Body platform = world.body(floorFirst ? addPlatform(world).id()
                                              : world.add(shapes::box(), {{9, 9}, 0}).id());
        const Body ball = world.add(shapes::ball({.radius = Real(0.3)}), {.position = {2, 1.5}});
        if (!floorFirst) platform = addPlatform(world);
        world.setVelocity(ball, Vec2(1, -5));
        int asked = 0;
        Real least = 1;
        world.setPreSolve([&](const PreSolveContact& contact, Material& surface) {
            ++asked;
            EXPECT_TRUE(contact.a < contact.b);
            EXPECT_EQ(contact.a, floorFirst ? platform.id() : ball.id());
            EXPECT_NEAR(contact.normal[1], floorFirst ? -1 : 1, 1e-5);
            EXPECT_NEAR(contact.gap, lowEnd(world, ball) - thickness, 1e-4);
            // The corner is the ball's, or, before its rounding, an end of the floor's.
            EXPECT_NEAR(contact.point[0], world.position(ball.front())[0], 1e-3);
            EXPECT_NEAR(contact.point[1], lowEnd(world, ball), 1e-4);
            if (contact.gap > 0) {
                EXPECT_NEAR(contact.speed, 5, 1e-3);
            }
            EXPECT_EQ(surface, Material{});
            least = std::min(least, contact.gap);
            return true;
        });
        test::run(world, 0.5);
        EXPECT_GT(asked, 3);
        EXPECT_LT(least, 0.01);
        EXPECT_NEAR(world.velocity(ball.front())[1], 0, 1e-3) << "it is stopped";
    }
}

TEST(PreSolve, EventsTellWhenContactsCeaseToAct) {
    World world({.sleeping = false});
    const Body platform = addPlatform(world);
    const Body crate = world.add(shapes::box(), {.position = {0, 0.5 + thickness}});
    bool acts = true;
    world.setPreSolve([&](const PreSolveContact&, Material&) { return acts; });
    test::run(world, 0.2);
    EXPECT_FALSE(world.contacts().empty());
    acts = false;
    world.step();
    ASSERT_EQ(world.events().contactsEnded.size(), 1u);
    EXPECT_EQ(world.events().contactsEnded[0].a, platform.id());
    EXPECT_TRUE(world.contacts().empty());
    acts = true;
    world.step();
    ASSERT_EQ(world.events().contactsBegun.size(), 1u);
    EXPECT_EQ(world.events().contactsBegun[0].b, platform.id());
    EXPECT_TRUE(world.contains(crate.id()));
}

/// Between ticks no answer is left: neither in what goes on without the callback nor in a snapshot.
TEST(PreSolve, AnswersHoldForOneStepOnly) {
    World world({.sleeping = false}), plain({.sleeping = false});
    addPlatform(world);
    const std::vector<Body> bodies = addKinds(world, 0.6);
    test::run(world, 0.5);
    plain.restore(world.snapshot());
    // An answer that changes nothing: nobody slides or bounces.
    world.setPreSolve([](const PreSolveContact&, Material& surface) {
        surface.staticFriction = 50;
        surface.restitution = Real(0.1);
        return true;
    });
    for (const Body& body : bodies) world.wake(body);
    world.step();
    world.setPreSolve({});
    for (const Body& body : bodies) world.setVelocity(body, Vec2(3, 0));
    World twin({.sleeping = false});
    twin.restore(world.snapshot());
    for (int i = 0; i < 50; ++i) {
        world.step();
        twin.step();
        ASSERT_EQ(world.hash(), twin.hash()) << i;
    }
    EXPECT_NEAR(world.meanVelocity(bodies[0])[0], 3 - 0.5 * 9.81 * 0.1, 0.03) << "brakes again";
}

TEST(PreSolve, NumbersOutOfRangeAreRefused) {
    World world({.sleeping = false}), untold({.sleeping = false});
    for (World* each : {&world, &untold}) {
        addPlatform(*each);
        addKinds(*each, 0.6);
        test::run(*each, 0.2);
    }
    int kind = 0;
    const auto spoil = [&](Material& surface) {
        const Real nan = std::numeric_limits<Real>::quiet_NaN();
        if (kind == 0) surface.kineticFriction = nan;
        if (kind == 1) surface.staticFriction = surface.kineticFriction / 2;
        if (kind == 2) surface.restitution = 2;
        if (kind == 3) surface.surfaceSpeed = 1001;
    };
    world.setPreSolve([&](const PreSolveContact&, Material& surface) {
        spoil(surface);
        return true;
    });
    for (; kind < 4; ++kind) {
        EXPECT_THROW(world.step(), Error) << kind;
        untold.step();
        EXPECT_EQ(world.hash(), untold.hash()) << kind;
        EXPECT_EQ(world.validate(), "");
    }
}

/// Some of everything: piles, soft things, ropes, things that break and that are tied.
void addMuch(World& world) {
    addPlatform(world);
    for (int i = 0; i < 15; ++i)
        world.add(shapes::box({.size = {Real(0.9), Real(0.7)}, .strength = 2000}),
                  {.position = {-4 + 0.95 * (i % 3), 0.6 + 0.8 * (i / 3)}, .angle = 0.1 * i});
    for (int i = 0; i < 6; ++i)
        world.add(shapes::ball({.radius = Real(0.3), .material = {.restitution = Real(0.5)}}),
                  {.position = {0.5 * i, 2 + 0.3 * i}});
    for (int i = 0; i < 3; ++i)
        world.add(shapes::jelly({.size = {1, 1}, .columns = 3, .rows = 3}),
                  {.position = {4 + 0.3 * i, 1 + 1.2 * i}});
    const Body rope = world.add(shapes::rope({.from = {-7, 3}, .to = {-4, 4}, .pinFirst = true}));
    const Body load = world.add(shapes::box({.mass = 20}), {.position = {-4, 5}});
    world.attach(rope.back(), load, {Real(-0.5), 0});
    const Body fast = world.add(shapes::ball({.radius = Real(0.1)}), {.position = {9, 1}});
    world.setVelocity(fast, Vec2(-150, 0));
    const Body one = world.add(shapes::box(), {.position = {11, 1}});
    const Body other = world.add(shapes::box(), {.position = {14, 1}, .angle = 1});
    world.connect(one.front(), other.front(), {.radius = Real(0.05)});
    world.add(shapes::ball(), {.position = {12.5, 3}});
}

TEST(PreSolve, ACallbackThatChangesNothingChangesNothing) {
    for (const int rate : {60, 500})
        for (const Friction friction : {Friction::coulomb, Friction::sliding}) {
            World world({.tickRate = rate, .friction = friction}),
                untold({.tickRate = rate, .friction = friction});
            addMuch(world);
            addMuch(untold);
            int asked = 0;
            world.setShouldCollide([](BodyId, BodyId) { return true; });
            world.setPreSolve([&](const PreSolveContact& contact, Material&) {
                ++asked;
                EXPECT_NEAR(contact.normal.norm(), 1, 1e-4);
                return world.bounds(contact.b).low[1] > -100;
            });
            for (int i = 0; i < rate; ++i) {
                world.step();
                untold.step();
                ASSERT_EQ(world.hash(), untold.hash()) << rate << " Hz, tick " << i;
            }
            EXPECT_GT(asked, 1000);
        }
}

/// Pieces of work by the caller alone, the last first.
class LastFirst final : public Tasks {
public:
    std::size_t threads() const override { return 3; }
    double overhead() const override { return 0.01; }
    void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
        for (std::size_t i = count; i-- > 0;) task(context, i);
    }
};

/// Each call with all that it was told, and the hash at the end; answers of all sorts.
std::vector<std::uint64_t> callsOf(Tasks* tasks) {
    World world({.tickRate = 120});
    addMuch(world);
    world.setTasks(tasks);
    std::vector<std::uint64_t> calls;
    const auto note = [&](const auto& value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, std::min(sizeof bits, sizeof value));
        calls.push_back(bits);
    };
    world.setShouldCollide([&](BodyId a, BodyId b) {
        note(a);
        note(b);
        return (a.index + b.index) % 5 != 0;
    });
    world.setPreSolve([&](const PreSolveContact& contact, Material& surface) {
        note(contact.a);
        note(contact.b);
        note(contact.point[0]);
        note(contact.speed);
        note(contact.gap);
        surface.kineticFriction /= 2;
        if (contact.b.index % 3 == 0) surface.surfaceSpeed = 1;
        if (contact.b.index % 3 == 1) surface.restitution = Real(0.3);
        return contact.b.index % 7 != 0 || contact.speed > 1;
    });
    for (int i = 0; i < 120; ++i) world.step();
    calls.push_back(world.hash());
    return calls;
}

TEST(PreSolve, CallsComeInTheSameOrderWhateverTheThreads) {
    const std::vector<std::uint64_t> once = callsOf(nullptr);
    EXPECT_GT(once.size(), 10000u);
    EXPECT_EQ(callsOf(nullptr), once);
    LastFirst lastFirst;
    EXPECT_EQ(callsOf(&lastFirst), once);
    ThreadPool pool(4);
    EXPECT_EQ(callsOf(&pool), once);
}

TEST(PreSolve, WorldsGoOnFromSnapshotsWithTheSameCallbacks) {
    World world({.tickRate = 120}), twin;
    addMuch(world);
    for (World* each : {&world, &twin})
        each->setPreSolve([](const PreSolveContact& contact, Material& surface) {
            surface.kineticFriction /= 2;
            if (contact.b.index % 3 == 0) surface.surfaceSpeed = 1;
            return contact.b.index % 7 != 0 || contact.speed > 1;
        });
    for (int i = 0; i < 60; ++i) world.step();
    twin.restore(world.snapshot());
    for (int i = 0; i < 60; ++i) {
        world.step();
        twin.step();
        ASSERT_EQ(world.hash(), twin.hash()) << i;
    }
}

/// Who does not act on each other is one island all the same, in a restored world too.
TEST(PreSolve, ARestoredWorldKnowsWhoHasPassedThroughWhom) {
    const auto passes = [](const PreSolveContact&, Material&) { return false; };
    World world({.gravity = {0, 0}}), twin;
    const Body one = world.add(shapes::box()), other = world.add(shapes::box(), {{0.99, 0}, 0});
    world.setVelocity(one, Vec2(1, 0));
    world.setPreSolve(passes);
    twin.setPreSolve(passes);
    test::run(world, 0.02);
    twin.restore(world.snapshot());
    ASSERT_EQ(world.hash(), twin.hash());
    for (World* each : {&world, &twin}) {
        EXPECT_TRUE(each->putToSleep(one));
        EXPECT_TRUE(each->asleep(other));
    }
    EXPECT_EQ(world.hash(), twin.hash());
}

}  // namespace
}  // namespace sulfur
