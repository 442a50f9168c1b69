#include "helpers.hpp"
#include "queries/brute_force.hpp"

namespace sulfur {
namespace {

TEST(RayCast, HitsTheSurfaceOfACapsule) {
    World world;
    const Body wall = world.add(shapes::floor({5, -5}, {5, 5}, Real(0.25)));
    const auto hit = world.castSegment({0, 1}, {10, 1});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, wall.id());
    EXPECT_NEAR(hit->point[0], 4.75, 1e-9);
    EXPECT_NEAR(hit->normal[0], -1, 1e-6);
    EXPECT_NEAR(hit->fraction, 0.475, 1e-6);
    EXPECT_NEAR(hit->along, 0.6, 1e-6);
    EXPECT_EQ(world.castSegment({0, 6}, {10, 6}), std::nullopt);
    EXPECT_EQ(world.castSegment({0, 1}, {4.7, 1}), std::nullopt);
}

TEST(RayCast, HitsCapsAndDiscs) {
    World world;
    world.add(shapes::floor({0, 0}, {0, 2}, Real(0.5)));
    const auto cap = world.castSegment({0, 5}, {0, 0});
    ASSERT_TRUE(cap);
    EXPECT_NEAR(cap->point[1], 2.5, 1e-9);
    const Body ball = world.add(shapes::ball({.radius = Real(0.5)}), {.position = {10, 0}});
    const auto disc = world.castSegment({10, 4}, {10, -4});
    ASSERT_TRUE(disc);
    EXPECT_EQ(disc->body, ball.id());
    EXPECT_EQ(disc->particle, ball.front());
    EXPECT_FALSE(disc->joint);
    EXPECT_NEAR(disc->point[1], 0.5, 1e-9);
}

TEST(RayCast, FiltersAndStartsInside) {
    World world;
    Blueprint near = shapes::floor({1, -1}, {1, 1}, Real(0.1));
    near.filter.category = 2;
    const Body first = world.add(near);
    const Body second = world.add(shapes::floor({2, -1}, {2, 1}, Real(0.1)));
    EXPECT_EQ(world.castSegment({0, 0}, {5, 0})->body, first.id());
    EXPECT_EQ(world.castSegment({0, 0}, {5, 0}, {.mask = 1})->body, second.id());
    EXPECT_EQ(world.castSegment({0, 0}, {5, 0}, {.ignore = first.id()})->body, second.id());
    const auto inside = world.castSegment({1, 0}, {5, 0});
    EXPECT_EQ(inside->fraction, 0);
    EXPECT_EQ(inside->normal, Vec2(0, 0));
}

/// The grid may skip nothing: the same as testing each capsule alone.
TEST(RayCast, AgreesWithBruteForce) {
    test::Random random(3);
    World all;
    std::vector<std::unique_ptr<World>> single;
    for (int i = 0; i < 60; ++i) {
        const Point a(random.uniform(-20, 20), random.uniform(-20, 20));
        const Point b = a + Point(random.uniform(-3, 3), random.uniform(-3, 3));
        Blueprint plan = shapes::floor(a.cast<Real>(), b.cast<Real>(), Real(0.1));
        if (i % 2 == 0) plan.kind = BodyKind::dynamic;
        all.add(plan);
        single.push_back(std::make_unique<World>());
        single.back()->add(plan);
    }
    int hits = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const Point from(random.uniform(-25, 25), random.uniform(-25, 25));
        const Point to(random.uniform(-25, 25), random.uniform(-25, 25));
        std::optional<double> nearest;
        for (const auto& world : single)
            if (const auto hit = world->castSegment(from, to))
                nearest = std::min(nearest.value_or(2), static_cast<double>(hit->fraction));
        const auto hit = all.castSegment(from, to);
        ASSERT_EQ(hit.has_value(), nearest.has_value()) << trial;
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(static_cast<double>(hit->fraction), *nearest, 1e-6);
    }
    EXPECT_GT(hits, 100);
}

TEST(RayCast, SeesWhereThingsAreNow) {
    World world({.gravity = {0, 0}});
    const Body ball = world.add(shapes::ball({.radius = Real(0.5)}));
    world.setVelocity(ball, {10, 0});
    test::run(world, 1);
    EXPECT_EQ(world.castSegment({0, 2}, {0, -2}), std::nullopt);
    EXPECT_TRUE(world.castSegment({10, 2}, {10, -2}));
    world.setPosition(ball.front(), {-3, 0});
    EXPECT_TRUE(world.castSegment({-3, 2}, {-3, -2}));
    world.remove(ball);
    EXPECT_EQ(world.castSegment({-3, 2}, {-3, -2}), std::nullopt);
}

TEST(RayCast, ReachesAsFarAsItIsTold) {
    World world;
    const Body wall = world.add(shapes::floor({5, -5}, {5, 5}, Real(0.25)));
    const auto hit = world.castRay({0, 1}, {Real(1e-20), 0}, 10);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, wall.id());
    EXPECT_NEAR(hit->point[0], 4.75, 1e-9);
    EXPECT_NEAR(hit->fraction, 0.475, 1e-9);
    EXPECT_EQ(world.castRay({0, 1}, {1, 0}, 4.7), std::nullopt);
    EXPECT_EQ(world.castRay({0, 1}, {-1, 0}, 1e6), std::nullopt);
    EXPECT_EQ(world.castRay({0, 1}, {1, 0}, 0), std::nullopt);
}

/// From a thousand kilometres away, and past, at the cost of what is there: this would take
/// minutes if every cell between were looked at.
TEST(RayCast, ComesFromFarAwayAtOnce) {
    World world;
    const Body crate = world.add(shapes::box({.size = {Real(0.1), Real(0.1)}}));
    world.step();
    for (int i = 0; i < 2000; ++i) {
        const auto hit = world.castRay({-9e5, 1e-3}, {1, 0}, 1e6);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->body, crate.id());
        EXPECT_NEAR(hit->point[0], -0.05, 1e-6);
        EXPECT_EQ(world.castRay({-9e5, 0.3}, {1, 0}, 1e6), std::nullopt);
    }
}

TEST(RayCast, StartsInsideOfACrate) {
    World world;
    const Body crate = world.add(shapes::box({.size = {1, 1}, .radius = Real(0.1)}));
    const auto hit = world.castSegment({0, 0}, {2, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, crate.id());
    EXPECT_NEAR(hit->point[0], 0.3, 1e-6) << "the inner side of the capsule";
    EXPECT_NEAR(hit->normal[0], -1, 1e-6);
    EXPECT_EQ(world.castSegment({0, 0}, {0, 0}), std::nullopt);
    EXPECT_EQ(world.castSegment({0.4, 0}, {0.4, 0})->fraction, 0);
}

TEST(RayCast, AsksTheCaller) {
    World world({.sleeping = true});
    std::vector<BodyId> walls;
    for (const Real x : {Real(1), Real(2), Real(3)})
        walls.push_back(world.add(shapes::floor({x, -1}, {x, 1}, Real(0.1))).id());
    const auto hit = world.castSegment({0, 0}, {5, 0},
                                       {.accept = [&](BodyId body) { return body == walls[1]; }});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, walls[1]);
    EXPECT_EQ(world.castSegment({0, 0}, {5, 0}, {.accept = [](BodyId) { return false; }}),
              std::nullopt);
}

TEST(RayCast, FindsAllInTheirOrder) {
    World world;
    std::vector<BodyId> walls;
    for (const Real x : {Real(3), Real(1), Real(2)})
        walls.push_back(world.add(shapes::floor({x, -1}, {x, 1}, Real(0.1))).id());
    const auto hits = world.castAll({0, 0}, {5, 0});
    ASSERT_EQ(hits.size(), 3u);
    EXPECT_EQ(hits[0].body, walls[1]);
    EXPECT_EQ(hits[1].body, walls[2]);
    EXPECT_EQ(hits[2].body, walls[0]);
    EXPECT_NEAR(hits[2].point[0], 2.9, 1e-6);
    EXPECT_TRUE(world.castAll({0, 2}, {5, 2}).empty());
    EXPECT_EQ(world.castAll({0, 0}, {5, 0}, {.ignore = walls[2]}).size(), 2u);
}

/// Marches by the distance to each capsule, which can pass through none.
std::optional<double> march(const test::Capsule& c, const Point& from, const Point& way) {
    double fraction = 0;
    for (int i = 0; i < 100000 && fraction <= 1; ++i) {
        const double gap = test::distance(c.a, c.b, from + fraction * way) - c.radius;
        if (gap < 1e-10) return fraction;
        fraction += gap / way.norm();
    }
    return std::nullopt;
}

TEST(RayCast, AgreesWithMarching) {
    test::Zoo zoo(7);
    zoo.world.step();
    const test::Catalogue all = zoo.catalogue();
    std::size_t hits = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Point from = zoo.place(), way = zoo.place() - from;
        std::vector<double> expected;
        for (const test::Capsule& c : all.capsules)
            if (const auto fraction = march(c, from, way)) expected.push_back(*fraction);
        std::sort(expected.begin(), expected.end());
        const auto found = zoo.world.castAll(from, from + way);
        ASSERT_EQ(found.size(), expected.size()) << trial;
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i].fraction, expected[i], 1e-7);
        const auto first = zoo.world.castSegment(from, from + way);
        ASSERT_EQ(first.has_value(), !expected.empty());
        if (first) {
            EXPECT_EQ(first->fraction, found.front().fraction);
            EXPECT_EQ(first->body, found.front().body);
        }
        hits += found.size();
    }
    EXPECT_GT(hits, 2000u);
}

}  // namespace
}  // namespace sulfur
