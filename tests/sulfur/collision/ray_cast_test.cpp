#include "helpers.hpp"

namespace sulfur {
namespace {

TEST(RayCast, HitsTheSurfaceOfACapsule) {
    World world;
    const Body wall = world.add(shapes::floor({5, -5}, {5, 5}, Real(0.25)));
    const auto hit = world.castRay({0, 1}, {10, 1});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, wall.id());
    EXPECT_NEAR(hit->point[0], 4.75, 1e-9);
    EXPECT_NEAR(hit->normal[0], -1, 1e-6);
    EXPECT_NEAR(hit->fraction, 0.475, 1e-6);
    EXPECT_NEAR(hit->along, 0.6, 1e-6);
    EXPECT_EQ(world.castRay({0, 6}, {10, 6}), std::nullopt);
    EXPECT_EQ(world.castRay({0, 1}, {4.7, 1}), std::nullopt);
}

TEST(RayCast, HitsCapsAndDiscs) {
    World world;
    world.add(shapes::floor({0, 0}, {0, 2}, Real(0.5)));
    const auto cap = world.castRay({0, 5}, {0, 0});
    ASSERT_TRUE(cap);
    EXPECT_NEAR(cap->point[1], 2.5, 1e-9);
    const Body ball = world.add(shapes::ball({.radius = Real(0.5)}), {.position = {10, 0}});
    const auto disc = world.castRay({10, 4}, {10, -4});
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
    EXPECT_EQ(world.castRay({0, 0}, {5, 0})->body, first.id());
    EXPECT_EQ(world.castRay({0, 0}, {5, 0}, {.mask = 1})->body, second.id());
    EXPECT_EQ(world.castRay({0, 0}, {5, 0}, {.ignore = first.id()})->body, second.id());
    const auto inside = world.castRay({1, 0}, {5, 0});
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
            if (const auto hit = world->castRay(from, to))
                nearest = std::min(nearest.value_or(2), static_cast<double>(hit->fraction));
        const auto hit = all.castRay(from, to);
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
    EXPECT_EQ(world.castRay({0, 2}, {0, -2}), std::nullopt);
    EXPECT_TRUE(world.castRay({10, 2}, {10, -2}));
    world.setPosition(ball.front(), {-3, 0});
    EXPECT_TRUE(world.castRay({-3, 2}, {-3, -2}));
    world.remove(ball);
    EXPECT_EQ(world.castRay({-3, 2}, {-3, -2}), std::nullopt);
}

}  // namespace
}  // namespace sulfur
