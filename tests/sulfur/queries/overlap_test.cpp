#include "helpers.hpp"
#include "queries/brute_force.hpp"

namespace sulfur {
namespace {

std::vector<BodyId> idsOf(const std::vector<Overlap>& overlaps) {
    std::vector<BodyId> ids;
    for (const Overlap& overlap : overlaps) ids.push_back(overlap.body);
    return ids;
}

TEST(Overlap, TellsWhatTouchesAndWhatEncloses) {
    World world;
    const Body crate = world.add(shapes::box({.size = {2, 2}, .radius = Real(0.1)}));
    const auto inside = world.overlapCircle({0, 0}, 0.1);
    ASSERT_EQ(inside.size(), 1u);
    EXPECT_EQ(inside[0].body, crate.id());
    EXPECT_FALSE(inside[0].joint);
    EXPECT_FALSE(inside[0].particle);
    const auto side = world.overlapCircle({1.3, 0}, 0.4);
    ASSERT_EQ(side.size(), 1u);
    EXPECT_EQ(side[0].joint, crate.joints()[1]);
    EXPECT_TRUE(world.overlapCircle({1.3, 0}, 0.29).empty());
    EXPECT_EQ(world.overlapBox({-5, -5}, {5, 5}).size(), 1u) << "a box around it";
    EXPECT_TRUE(world.overlapBox({1.01, -5}, {5, 5}).empty());
}

TEST(Overlap, ATurnedBoxIsNotItsBounds) {
    World world;
    const Body ball = world.add(shapes::ball({.radius = Real(0.1)}), {.position = {0.9, 0.9}});
    EXPECT_EQ(world.overlap(QueryShape::box({0, 0}, {2, 2})).size(), 1u);
    EXPECT_TRUE(world.overlap(QueryShape::box({0, 0}, {2, 2}, 0.785398)).empty());
    EXPECT_EQ(world.overlap(QueryShape::box({0, 0}, {2, Real(2.8)}, 0.785398)).size(), 0u);
    EXPECT_EQ(world.overlap(QueryShape::box({0, 0}, {Real(2.8), 2}, 0.785398)).front().body,
              ball.id());
}

TEST(Overlap, MovedAsleepAndRemovedBodiesAreSeenAsTheyAre) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}, Real(0.1)));
    const Body crate = world.add(shapes::box(), {.position = {0, 0.62}});
    test::run(world, 4);
    ASSERT_TRUE(world.asleep(crate));
    EXPECT_EQ(world.bodiesAt({0, 0.6}), std::vector{crate.id()});
    for (const ParticleId p : crate.particles())
        world.setPosition(p, world.position(p) + Point(3, 0));
    EXPECT_TRUE(world.bodiesAt({0, 0.6}).empty());
    EXPECT_EQ(world.bodiesAt({3, 0.6}), std::vector{crate.id()});
    world.remove(crate);
    EXPECT_TRUE(world.bodiesAt({3, 0.6}).empty());
    const Body other = world.add(shapes::box(), {.position = {3, 1}});
    EXPECT_EQ(world.bodiesAt({3, 0.6}), std::vector{other.id()}) << "before any tick";
}

TEST(Overlap, BodiesInABoxAreFoundOnceByTheirHandles) {
    World world;
    const Body net = world.add(shapes::cloth({.radius = 0}), {.position = {10, 0}});
    const Body ball = world.add(shapes::ball({.radius = Real(0.5)}), {.position = {0, 0}});
    const Body room = world.add(shapes::ground({.points = {{-3, -3}, {3, -3}, {3, 3}}}));
    const Body crate = world.add(shapes::box({.size = {6, 6}}), {.position = {20, 0}});
    Blueprint gate = shapes::box();
    gate.sensor = true;
    const Body sensor = world.add(gate, {.position = {0, 0}});
    const auto ids = [](std::initializer_list<Body> bodies) {
        return std::vector<BodyId>(bodies.begin(), bodies.end());
    };
    EXPECT_EQ(world.bodiesIn({-30, -30}, {30, 30}), ids({net, ball, room, crate}));
    EXPECT_EQ(world.bodiesIn({-30, -30}, {30, 30}, {.sensors = true}),
              ids({net, ball, room, crate, sensor}));
    EXPECT_EQ(world.bodiesIn({-30, -30}, {30, 30}, {.ignore = net}), ids({ball, room, crate}));
    EXPECT_EQ(world.bodiesIn({0.4, -0.1}, {2, 0.1}), ids({ball})) << "its rim, not its centre";
    EXPECT_EQ(world.bodiesIn({19.9, -0.1}, {20.1, 0.1}), ids({crate})) << "inside of it";
    EXPECT_EQ(world.bodiesIn({9, -1}, {11, 1}), ids({net})) << "a corner without a surface";
    const Point corner = world.position(net[0]);
    EXPECT_EQ(world.bodiesIn(corner, corner), ids({net}));
    EXPECT_TRUE(world.bodiesIn({12, 2}, {14, 9}).empty());
    EXPECT_THROW(world.bodiesIn({1, 0}, {0, 1}), Error);
    world.remove(net);
    EXPECT_TRUE(world.bodiesIn({9, -1}, {11, 1}).empty());
}

/// A wall whose border broke open encloses no longer what was behind the breach.
TEST(Overlap, ABrokenOutlineIsOpen) {
    World world({.gravity = {0, 0}});
    const Body wall = world.add(shapes::wall({.size = {1, 1}, .columns = 1, .rows = 1}));
    EXPECT_EQ(world.bodiesAt({0, 0}).size(), 1u);
    world.remove(wall.joints()[0]);
    EXPECT_TRUE(world.bodiesAt({0, 0}).empty());
}

TEST(Overlap, ARoomDoesNotContainWhatIsInIt) {
    World world;
    const std::vector<Vec2> corners{{-4, 0}, {4, 0}, {4, 3}, {-4, 3}};
    world.add(shapes::ground({.points = corners, .closed = true}));
    EXPECT_TRUE(world.bodiesAt({0, 1}).empty());
    const std::vector<Vec2> clockwise(corners.rbegin(), corners.rend());
    world.add(shapes::ground({.points = clockwise, .closed = true}), {.position = {20, 0}});
    EXPECT_EQ(world.bodiesAt({20, 1}).size(), 1u);
}

TEST(Overlap, AgreesWithBruteForce) {
    test::Zoo zoo(11);
    test::run(zoo.world, 0.1);
    const test::Catalogue all = zoo.catalogue();
    std::size_t overlaps = 0, enclosed = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Point centre = zoo.place();
        std::vector<Point> points{centre};
        for (std::size_t more = zoo.below(5); more > 0; --more)
            points.push_back(centre + zoo.place(1.5));
        const double radius = zoo.below(2) == 0 ? 0 : zoo.uniform(0, 1);
        const QueryShape shape = QueryShape::polygon(points, radius);
        const std::vector<Point> hull(shape.points().begin(), shape.points().end());
        std::vector<BodyId> expected;
        for (const test::Capsule& c : all.capsules)
            if (test::distance(c.a, c.b, hull) <= c.radius + radius) expected.push_back(c.body);
        for (const test::Hollow& hollow : all.hollows)
            if (test::contains(hollow.corners, hull[0])) {
                expected.push_back(hollow.body);
                ++enclosed;
            }
        std::sort(expected.begin(), expected.end());
        expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
        ASSERT_EQ(idsOf(zoo.world.overlap(shape)), expected) << trial;
        overlaps += expected.size();
    }
    EXPECT_GT(overlaps, 400u);
    EXPECT_GT(enclosed, 30u);
}

TEST(Overlap, LargeRegionsFindEverything) {
    test::Zoo zoo(12);
    EXPECT_EQ(zoo.world.overlapCircle({0, 0}, 1e6).size(), zoo.bodies.size());
    EXPECT_EQ(zoo.world.overlapBox({-1e7, -1e7}, {1e7, 1e7}).size(), zoo.bodies.size());
    EXPECT_TRUE(zoo.world.overlapBox({1e6, 1e6}, {1e7, 1e7}).empty());
}

TEST(Overlap, ShapesAreRefused) {
    World world;
    const auto refused = [&](ErrorCode code, auto&& call) {
        test::expectRefused(world, code, [&] { call(); });
    };
    refused(ErrorCode::outOfRange, [] { QueryShape::circle({0, 0}, -1); });
    refused(ErrorCode::notFinite, [] { QueryShape::circle({NAN, 0}, 1); });
    refused(ErrorCode::outOfRange, [] { QueryShape::capsule({0, 0}, {2e7, 0}, 1); });
    refused(ErrorCode::outOfRange, [] { QueryShape::box({0, 0}, {-1, 1}); });
    refused(ErrorCode::outOfRange, [] { QueryShape::polygon({}); });
    refused(ErrorCode::outOfRange, [] { QueryShape::polygon(std::vector<Point>(9)); });
    refused(ErrorCode::degenerate, [&] { world.overlapBox({1, 0}, {0, 1}); });
    refused(ErrorCode::outOfRange, [&] { world.overlapCircle({0, 0}, 2e6); });
    refused(ErrorCode::outOfRange, [&] {
        world.castShape(QueryShape::circle({0, 0}, 1), {2e7, 0});
    });
    refused(ErrorCode::degenerate, [&] { world.castRay({0, 0}, {0, 0}, 1); });
    refused(ErrorCode::outOfRange, [&] { world.castRay({0, 0}, {1, 0}, 2e6); });
    refused(ErrorCode::outOfRange, [&] { world.closestPoint({0, 0}, -1); });
}

}  // namespace
}  // namespace sulfur
