#include "helpers.hpp"
#include "queries/brute_force.hpp"

namespace sulfur {
namespace {

TEST(ShapeCast, ADiscStopsAtTheSurface) {
    World world;
    const Body wall = world.add(shapes::floor({5, -5}, {5, 5}, Real(0.25)));
    const auto hit = world.castShape(QueryShape::circle({0, 1}, 0.5), {10, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, wall.id());
    EXPECT_NEAR(hit->fraction, 0.425, 1e-9);
    EXPECT_NEAR(hit->point[0], 4.75, 1e-9);
    EXPECT_NEAR(hit->point[1], 1, 1e-9);
    EXPECT_NEAR(hit->normal[0], -1, 1e-6);
    EXPECT_EQ(world.castShape(QueryShape::circle({0, 1}, 0.5), {4.2, 0}), std::nullopt);
    EXPECT_EQ(world.castShape(QueryShape::circle({0, 6}, 0.5), {10, 0}), std::nullopt);
    EXPECT_TRUE(world.castShape(QueryShape::circle({0, 6}, 1), {10, 0}));
}

TEST(ShapeCast, ABoxLandsFlatAndOnACorner) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}, Real(0.1)));
    const auto flat = world.castShape(QueryShape::box({1, 3}, {2, 1}), {0, -10});
    ASSERT_TRUE(flat);
    EXPECT_NEAR(flat->fraction, 0.24, 1e-7);
    EXPECT_NEAR(flat->point[0], 1, 1e-7) << "the middle of the face";
    EXPECT_NEAR(flat->point[1], 0.1, 1e-7);
    const double turn = 0.5, half = std::cos(turn) * 0.5 + std::sin(turn) * 0.5;
    const auto corner = world.castShape(QueryShape::box({1, 3}, {1, 1}, turn), {0, -10});
    ASSERT_TRUE(corner);
    EXPECT_NEAR(corner->fraction, (2.9 - half) / 10, 1e-7);
    EXPECT_NEAR(corner->point[0], 1 + (std::sin(turn) - std::cos(turn)) / 2, 1e-6);
    const auto edge = world.castShape(QueryShape::box({5.5, 3}, {2, 1}), {0, -10});
    ASSERT_TRUE(edge);
    EXPECT_NEAR(edge->point[0], 4.75, 1e-6) << "the middle of what lies on the floor";
}

TEST(ShapeCast, WhatOverlapsAtTheStartIsMetAtOnce) {
    World world;
    const Body crate = world.add(shapes::box({.size = {2, 2}, .radius = Real(0.1)}));
    const auto touching = world.castShape(QueryShape::circle({1.2, 0}, 0.5), {5, 0});
    ASSERT_TRUE(touching);
    EXPECT_EQ(touching->fraction, 0);
    EXPECT_EQ(touching->normal, Vec2(0, 0));
    EXPECT_EQ(touching->joint, crate.joints()[1]);
    const auto inside = world.castShape(QueryShape::circle({0, 0}, 0.1), {5, 0});
    ASSERT_TRUE(inside);
    EXPECT_EQ(inside->body, crate.id());
    EXPECT_EQ(inside->fraction, 0);
    EXPECT_EQ(world.castShape(QueryShape::circle({0, 0}, 0.1), {5, 0}, {.ignore = crate.id()}),
              std::nullopt);
    EXPECT_EQ(world.castShape(QueryShape::circle({1.6, 0}, 0.5), {0, 0}), std::nullopt);
}

/// Advances by the distance to each capsule, which can pass through none.
TEST(ShapeCast, AgreesWithMarching) {
    test::Zoo zoo(21);
    zoo.world.step();
    const test::Catalogue all = zoo.catalogue();
    int hits = 0, overlaps = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Point start = zoo.place(), way = zoo.place(8);
        std::vector<Point> points{start};
        for (std::size_t more = zoo.below(5); more > 0; --more)
            points.push_back(start + zoo.place(1));
        const QueryShape shape = QueryShape::polygon(points, zoo.uniform(0, 0.5));
        const std::vector<Point> hull(shape.points().begin(), shape.points().end());
        double expected = 2;
        for (const test::Capsule& c : all.capsules) {
            double fraction = 0;
            for (int i = 0; i < 100000 && fraction <= std::min(expected, 1.0); ++i) {
                // Moving the capsule the other way is the same, and needs no moved hull.
                const double gap =
                    test::distance(c.a - fraction * way, c.b - fraction * way, hull) - c.radius -
                    shape.radius();
                if (gap < 1e-10) {
                    expected = std::min(expected, fraction);
                    break;
                }
                fraction += gap / way.norm();
            }
        }
        for (const test::Hollow& hollow : all.hollows)
            if (test::contains(hollow.corners, hull[0])) expected = 0;
        const auto hit = zoo.world.castShape(shape, way);
        ASSERT_EQ(hit.has_value(), expected <= 1) << trial;
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(hit->fraction, expected, 1e-7) << trial;
        if (hit->fraction == 0) {
            ++overlaps;
            continue;
        }
        // The moved shape's surface is at the point that the hit names.
        const Point back = hit->point - hit->fraction * way;
        EXPECT_NEAR(test::distance(back, back, hull), shape.radius(), 1e-6) << trial;
    }
    EXPECT_GT(hits, 800);
    EXPECT_GT(overlaps, 100);
}

}  // namespace
}  // namespace sulfur
