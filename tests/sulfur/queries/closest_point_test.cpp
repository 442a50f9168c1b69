#include "helpers.hpp"
#include "queries/brute_force.hpp"

namespace sulfur {
namespace {

TEST(ClosestPoint, OfACapsuleFromAllSides) {
    World world;
    const Body floor = world.add(shapes::floor({0, 0}, {4, 0}, Real(0.25)));
    const auto above = world.closestPoint({1, 2}, 5);
    ASSERT_TRUE(above);
    EXPECT_EQ(above->body, floor.id());
    EXPECT_EQ(above->joint, floor.joints()[0]);
    EXPECT_NEAR(above->distance, 1.75, 1e-9);
    EXPECT_NEAR((above->point - Point(1, 0.25)).norm(), 0, 1e-9);
    EXPECT_NEAR(above->normal[1], 1, 1e-6);
    EXPECT_NEAR(above->along, 0.25, 1e-6);
    EXPECT_EQ(above->particle, floor.front());
    const auto within = world.closestPoint({1, -0.1}, 0);
    ASSERT_TRUE(within);
    EXPECT_NEAR(within->distance, -0.15, 1e-6);
    EXPECT_NEAR(within->point[1], -0.25, 1e-6);
    EXPECT_NEAR(world.closestPoint({1, 0}, 0)->distance, -0.25, 1e-9) << "on the axis";
    EXPECT_EQ(world.closestPoint({1, 2}, 1.7), std::nullopt);
}

TEST(ClosestPoint, InsideOfACrateLeadsOut) {
    World world;
    const Body crate = world.add(shapes::box({.size = {2, 2}, .radius = Real(0.1)}));
    const auto way = world.closestPoint({0.5, 0.1}, 0);
    ASSERT_TRUE(way);
    EXPECT_EQ(way->body, crate.id());
    EXPECT_NEAR(way->distance, -0.5, 1e-6);
    EXPECT_NEAR(way->point[0], 1, 1e-6);
    EXPECT_NEAR(way->point[1], 0.1, 1e-6);
    EXPECT_NEAR(way->normal[0], 1, 1e-6);
    const auto onAxis = world.closestPoint({0.9, 0}, 0);
    ASSERT_TRUE(onAxis);
    EXPECT_NEAR(onAxis->distance, -0.1, 1e-6);
    EXPECT_NEAR(onAxis->normal[0], 1, 1e-6);
}

TEST(ClosestPoint, FindsFromFarAway) {
    World world;
    const Body grain = world.add(shapes::ball({.radius = Real(0.01)}));
    const auto found = world.closestPoint({6e5, -7e5}, 1e6);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->body, grain.id());
    EXPECT_NEAR(found->distance, std::hypot(6e5, 7e5) - 0.01, 1e-6);
    EXPECT_EQ(world.closestPoint({6e5, -7e5}, 9e5), std::nullopt);
    EXPECT_EQ(World().closestPoint({0, 0}, 1e6), std::nullopt);
}

TEST(ClosestPoint, AgreesWithBruteForce) {
    test::Zoo zoo(31);
    test::run(zoo.world, 0.1);
    const test::Catalogue all = zoo.catalogue();
    int found = 0, inside = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const Point point = zoo.place(trial % 3 == 0 ? 2000 : 25);
        const double reach = zoo.below(3) == 0 ? 1e4 : zoo.uniform(0, 5);
        std::vector<BodyId> around;
        double expected = reach;
        for (const test::Hollow& hollow : all.hollows) {
            if (!test::contains(hollow.corners, point)) continue;
            around.push_back(hollow.body);
            double depth = 1e300;
            for (const test::Capsule& c : all.capsules)
                if (c.body == hollow.body)
                    depth = std::min(depth, test::distance(c.a, c.b, point) + c.radius);
            expected = std::min(expected, -depth);
            ++inside;
        }
        bool any = !around.empty();
        for (const test::Capsule& c : all.capsules) {
            if (std::find(around.begin(), around.end(), c.body) != around.end()) continue;
            const double gap = test::distance(c.a, c.b, point) - c.radius;
            if (gap > expected) continue;
            expected = gap;
            any = true;
        }
        const auto closest = zoo.world.closestPoint(point, reach);
        ASSERT_EQ(closest.has_value(), any) << trial;
        if (!closest) continue;
        ++found;
        EXPECT_NEAR(closest->distance, expected, 1e-7) << trial;
        const Point back = closest->point + closest->distance * closest->normal.cast<double>();
        EXPECT_NEAR((back - point).norm(), 0, 1e-6 * (1 + std::abs(expected))) << trial;
    }
    EXPECT_GT(found, 1000);
    EXPECT_GT(inside, 50);
}

}  // namespace
}  // namespace sulfur
