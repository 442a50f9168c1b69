#include "helpers.hpp"

namespace sulfur {
namespace {

Blueprint sensing(Blueprint plan, BodyKind kind = BodyKind::fixed) {
    plan.sensor = true;
    plan.kind = kind;
    return plan;
}

/// How often a visitor came into a sensor and left it, over some ticks.
struct Told {
    int entered = 0, left = 0;
};
Told watch(World& world, double seconds, BodyId sensor, BodyId visitor) {
    Told told;
    for (long i = std::lround(seconds * world.settings().tickRate); i > 0; --i) {
        world.step();
        for (const SensorEntered& event : world.events().sensorsEntered)
            told.entered += event.sensor == sensor && event.visitor == visitor;
        for (const SensorLeft& event : world.events().sensorsLeft)
            told.left += event.sensor == sensor && event.visitor == visitor;
    }
    return told;
}

TEST(Sensors, FeelWhatFallsThroughAndDoNotTouchIt) {
    World world, empty;
    const Body zone = world.add(sensing(shapes::box({.size = {4, 2}})), {.position = {0, -4}});
    const Body ball = world.add(shapes::ball({.radius = Real(0.1)}));
    const Body free = empty.add(shapes::ball({.radius = Real(0.1)}));
    EXPECT_TRUE(world.sensor(zone));
    EXPECT_FALSE(world.sensor(ball));
    // Its lowest point reaches the zone's top, 2.9 m below, after sqrt(2 * 2.9 / g).
    int entered = -1, left = -1;
    for (int tick = 0; tick < 1000; ++tick) {
        world.step();
        empty.step();
        if (!world.events().sensorsEntered.empty()) entered = tick;
        if (!world.events().sensorsLeft.empty()) left = tick;
        const double y = world.position(ball.front())[1];
        EXPECT_EQ(world.visitors(zone).size(), y < -2.9 && y > -5.1 ? 1u : 0u) << y;
    }
    EXPECT_NEAR(entered / 500.0, std::sqrt(2 * 2.9 / 9.81), 0.005);
    EXPECT_NEAR(left / 500.0, std::sqrt(2 * 5.1 / 9.81), 0.005);
    EXPECT_EQ(world.position(ball.front()), empty.position(free.front()));
}

/// What breaks in a tick closes the gaps of what was removed before it; sensors stay who they are.
TEST(Sensors, StayThemselvesWhenSomethingBreaksAfterOthersWent) {
    World world({.gravity = {0, 0}});
    std::vector<Body> others;
    for (int i = 0; i < 20; ++i)
        others.push_back(world.add(shapes::box(), {.position = {10.0 + 2 * i, 0}}));
    Blueprint dumbbell;
    for (const Real x : {Real(-1), Real(1)})
        dumbbell.particles.push_back({.position = {x, 0}, .radius = Real(0.1)});
    dumbbell.joints.push_back({.a = 0, .b = 1, .strength = Real(0.01)});
    const Body breaks = world.add(dumbbell, {.position = {-10, 0}});
    const Body zone = world.add(sensing(shapes::box({.size = {4, 4}})), {.position = {0, 0}});
    const Body crate = world.add(shapes::box());
    for (int i = 0; i < 10; ++i) world.add(shapes::box(), {.position = {10.0 + 2 * i, 5}});
    world.step();
    for (int i = 0; i < 8; ++i) world.remove(others[static_cast<std::size_t>(i)]);
    world.applyForce(breaks[0], {-50, 0});
    world.step();
    EXPECT_EQ(world.events().jointsBroken.size(), 1u);
    ASSERT_EQ(world.visitors(zone).size(), 1u);
    EXPECT_EQ(world.visitors(zone)[0], crate.id());
    EXPECT_TRUE(world.events().sensorsLeft.empty());
}

TEST(Sensors, ABodyWhollyInsideCountsAndStaysCounted) {
    World world({.gravity = {0, 0}});
    // Drawn either way round: a sensor is never a room.
    const std::vector<Vec2> corners{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}};
    const std::vector<Vec2> reversed(corners.rbegin(), corners.rend());
    const Body crate = world.add(shapes::box());
    for (const auto& points : {corners, reversed}) {
        const Body zone = world.add(sensing(shapes::ground({.points = points, .closed = true})));
        const Told told = watch(world, 3, zone, crate);
        EXPECT_EQ(told.entered, 1);
        EXPECT_EQ(told.left, 0);
        EXPECT_EQ(world.visitors(zone), std::vector{crate.id()});
    }
    EXPECT_TRUE(world.asleep(crate)) << "and sleepers are felt";
}

TEST(Sensors, ASmallSensorInALargeHollowFeelsTheLargeBody) {
    World world({.gravity = {0, 0}});
    const Body crate = world.add(shapes::box({.size = {20, 20}}));
    const Body zone = world.add(sensing(shapes::ball({.radius = Real(0.1)})));
    world.step();
    EXPECT_EQ(world.visitors(zone), std::vector{crate.id()});
}

TEST(Sensors, FeelSomeKindsOnly) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body zone = world.add(sensing(shapes::box({.size = {4, 4}})));
    world.add(shapes::floor({-1, 0}, {1, 0}));
    world.add(sensing(shapes::ball(), BodyKind::dynamic));
    Blueprint lift = shapes::box();
    lift.kind = BodyKind::kinematic;
    lift.filter.category = 4;
    const Body kinematic = world.add(lift);
    Blueprint stranger = shapes::ball({.radius = Real(0.1)});
    stranger.filter.mask = 2;
    const Body deaf = world.add(stranger, {.position = {1, 1}});
    world.step();
    EXPECT_EQ(world.visitors(zone), std::vector{kinematic.id()});
    world.setFilter(deaf, {});
    world.setFilter(kinematic, {.category = 4, .mask = 2});
    world.step();
    EXPECT_EQ(world.visitors(zone), std::vector{deaf.id()});
    ASSERT_EQ(world.events().sensorsLeft.size(), 2u) << "two sensors are in one place";
    for (const SensorLeft& event : world.events().sensorsLeft)
        EXPECT_EQ(event.visitor, kinematic.id());
}

TEST(Sensors, ThemselvesMove) {
    World world({.gravity = {0, 0}});
    const Body sleeper = world.add(shapes::box(), {.position = {6, 0}});
    test::run(world, 2);
    ASSERT_TRUE(world.asleep(sleeper));
    const Body probe = world.add(sensing(shapes::ball({.radius = Real(0.2)}), BodyKind::kinematic));
    world.setVelocity(probe, {4, 0});
    const Told told = watch(world, 3, probe, sleeper);
    EXPECT_EQ(told.entered, 1);
    EXPECT_EQ(told.left, 1);
    EXPECT_TRUE(world.asleep(sleeper)) << "feeling does not wake";
}

TEST(Sensors, RemovalIsToldForVisitorsOnly) {
    World world({.gravity = {0, 0}});
    const Body first = world.add(sensing(shapes::box({.size = {4, 4}})));
    const Body second = world.add(sensing(shapes::box({.size = {4, 4}})));
    const Body ball = world.add(shapes::ball());
    const Body crate = world.add(shapes::box());
    world.step();
    ASSERT_EQ(world.events().sensorsEntered.size(), 4u);
    world.remove(first);
    world.remove(ball);
    EXPECT_EQ(world.visitors(second), std::vector{crate.id()});
    world.step();
    ASSERT_EQ(world.events().sensorsLeft.size(), 1u);
    EXPECT_EQ(world.events().sensorsLeft[0].sensor, second.id());
    EXPECT_EQ(world.events().sensorsLeft[0].visitor, ball.id());
    world.step();
    EXPECT_TRUE(world.events().sensorsLeft.empty());
    world.remove(second);
    world.step();
    EXPECT_TRUE(world.events().sensorsLeft.empty());
}

TEST(Sensors, EventsComeByTheIds) {
    World world({.gravity = {0, 0}});
    std::vector<BodyId> zones, balls;
    for (int i = 0; i < 3; ++i) {
        balls.push_back(world.add(shapes::ball({.radius = Real(0.1)}), {.position = {0.3 * i, 0}}));
        zones.push_back(world.add(sensing(shapes::box({.size = {4, 4}}))));
    }
    world.step();
    const auto& entered = world.events().sensorsEntered;
    ASSERT_EQ(entered.size(), 9u);
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_EQ(entered[i].sensor, zones[i / 3]);
        EXPECT_EQ(entered[i].visitor, balls[i % 3]);
    }
}

TEST(Sensors, ASupportThatBecomesASensorLetsFall) {
    World world;
    const Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body crate = world.add(shapes::box(), {.position = {0, 0.56}});
    test::run(world, 4);
    ASSERT_TRUE(world.asleep(crate));
    world.setSensor(floor, true);
    const Told through = watch(world, 2, floor, crate);
    EXPECT_EQ(through.entered, 1);
    EXPECT_EQ(through.left, 1);
    EXPECT_LT(world.centreOfMass(crate)[1], -5);
    world.setSensor(floor, false);
    const Body ball = world.add(shapes::ball(), {.position = {0, 2}});
    test::run(world, 2);
    EXPECT_NEAR(world.position(ball.front())[1], 0.3, 1e-2);
    EXPECT_TRUE(world.visitors(floor).empty());
}

/// Tears a body of links apart at its second one, and returns the new body.
BodyId tear(World& world, const Body& line) {
    world.setStrength(line.joints()[1], 10);
    world.applyForce(line.front(), {-1000, 0});
    world.applyForce(line.back(), {1000, 0});
    world.step();
    const auto& splits = world.events().bodiesSplit;
    EXPECT_EQ(splits.size(), 1u);
    return splits.empty() ? BodyId{} : splits[0].piece;
}

TEST(Sensors, PiecesOfAVisitorAndOfASensorAreVisitorsAndSensors) {
    World world({.gravity = {0, 0}});
    const Body zone = world.add(sensing(shapes::box({.size = {8, 8}})));
    const Body rope = world.add(shapes::rope({.from = {-1, 0}, .to = {1, 0}, .links = 4}));
    const Body thread = world.add(
        sensing(shapes::rope({.from = {-1, 3}, .to = {1, 3}, .links = 4}), BodyKind::dynamic));
    world.step();
    ASSERT_EQ(world.visitors(zone), std::vector{rope.id()});
    const BodyId piece = tear(world, rope);
    EXPECT_EQ(world.visitors(zone), (std::vector{rope.id(), piece}));
    ASSERT_EQ(world.events().sensorsEntered.size(), 1u);
    EXPECT_EQ(world.events().sensorsEntered[0].visitor, piece);
    EXPECT_TRUE(world.sensor(tear(world, thread)));
}

TEST(Sensors, QueriesPassThroughThemUnlessAsked) {
    World world;
    const Body zone = world.add(sensing(shapes::box({.size = {2, 2}})));
    EXPECT_EQ(world.castSegment({-5, 0}, {5, 0}), std::nullopt);
    EXPECT_TRUE(world.bodiesAt({0, 0}).empty());
    EXPECT_EQ(world.castSegment({-5, 0}, {5, 0}, {.sensors = true})->body, zone.id());
    EXPECT_EQ(world.bodiesAt({0, 0}, {.sensors = true}), std::vector{zone.id()});
}

TEST(Sensors, AreKeptInSnapshots) {
    World world({.gravity = {0, 0}});
    const Body zone = world.add(sensing(shapes::box({.size = {4, 4}})));
    const Body ball = world.add(shapes::ball());
    world.step();
    const auto hash = world.hash();
    const Snapshot snapshot = world.snapshot();
    world.setSensor(zone, false);
    EXPECT_NE(world.hash(), hash) << "a sensor pushes nothing, so it decides how the world goes on";
    world.restore(snapshot);
    EXPECT_EQ(world.hash(), hash);
    EXPECT_TRUE(world.sensor(zone));
    EXPECT_EQ(world.visitors(zone), std::vector{ball.id()});
    world.step();
    EXPECT_TRUE(world.events().sensorsEntered.empty()) << "it is there already";
    EXPECT_EQ(world.validate(), "");
}

/// Against the query, which looks at everything anew: a crowd that comes and goes.
TEST(Sensors, AgreeWithOverlapsInACrowd) {
    test::Random random(5);
    World world({.gravity = {0, -2}});
    world.add(shapes::ground({.points = {{-6, 8}, {-6, 0}, {6, 0}, {6, 8}}, .radius = Real(0.1)}));
    std::vector<Body> zones;
    zones.push_back(world.add(sensing(shapes::box({.size = {3, 3}})), {.position = {-3, 2}}));
    zones.push_back(world.add(sensing(shapes::ball({.radius = 1})), {.position = {2, 1.5}}));
    for (int i = 0; i < 12; ++i) {
        const Pose pose{{random.uniform(-5, 5), random.uniform(1, 8)}, random.uniform(0, 6)};
        const Body body = i % 3 == 0   ? world.add(shapes::box({.size = {1, 1}}), pose)
                          : i % 3 == 1 ? world.add(shapes::ball(), pose)
                                       : world.add(shapes::jelly({.damping = 5}), pose);
        world.setVelocity(body, {static_cast<Real>(random.uniform(-5, 5)), 0});
    }
    std::size_t visits = 0, changes = 0;
    for (int tick = 0; tick < 1500; ++tick) {
        world.step();
        changes += world.events().sensorsEntered.size() + world.events().sensorsLeft.size();
        if (tick % 5 != 0) continue;
        std::vector<BodyId> ball;
        for (const Overlap& hit : world.overlapCircle(
                 {2, 1.5}, 1,
                 {.accept = [&](BodyId body) { return world.kind(body) != BodyKind::fixed; }}))
            ball.push_back(hit.body);
        ASSERT_EQ(world.visitors(zones[1]), ball) << tick;
        const Real radius = world.info(zones[0].joints()[0]).radius;
        const auto inner = 3 - 2 * static_cast<double>(radius);
        std::vector<BodyId> box;
        const QueryShape shape =
            QueryShape::polygon(std::vector<Point>{{-3 - inner / 2, 2 - inner / 2},
                                                   {-3 + inner / 2, 2 - inner / 2},
                                                   {-3 + inner / 2, 2 + inner / 2},
                                                   {-3 - inner / 2, 2 + inner / 2}},
                                static_cast<double>(radius));
        for (const Overlap& hit : world.overlap(shape, {.accept = [&](BodyId body) {
                                                    return world.kind(body) != BodyKind::fixed;
                                                }}))
            box.push_back(hit.body);
        ASSERT_EQ(world.visitors(zones[0]), box) << tick;
        visits += ball.size() + box.size();
    }
    EXPECT_GT(visits, 300u);
    EXPECT_GT(changes, 10u);
}

}  // namespace
}  // namespace sulfur
