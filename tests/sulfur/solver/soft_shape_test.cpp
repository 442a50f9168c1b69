// Soft bodies have their shape again after what has pressed on them.
#include <algorithm>
#include <cmath>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// The largest change of a distance between two particles of a body, as a share of its size.
double changeOfShape(const World& world, const Body& body, const Blueprint& plan) {
    double most = 0, size = 0;
    for (std::uint32_t i = 0; i < body.size(); ++i)
        for (std::uint32_t j = 0; j < i; ++j) {
            const auto rest = static_cast<double>(
                (plan.particles[i].position - plan.particles[j].position).norm());
            const double now = (world.position(body[i]) - world.position(body[j])).norm();
            size = std::max(size, rest);
            most = std::max(most, std::abs(now - rest));
        }
    return most / size;
}

/// The middle of a lattice of three by three holds all others: its springs, stiffer than those of
/// the rim, are a star, and were taken for a tree.
TEST(SoftShape, ALatticeAroundOneParticleHasTriangles) {
    for (const Real damping : {Real(0), Real(1), Real(30)})
        for (const Real stiffness : {Real(400), Real(5000), Real(1e6)}) {
            World world({.gravity = {0, 0}});
            world.add(shapes::jelly(
                {.columns = 3, .rows = 3, .stiffness = stiffness, .damping = damping}));
            world.step();
            EXPECT_EQ(world.statistics().triangles, 16u) << stiffness << " " << damping;
            EXPECT_EQ(world.statistics().trees, 0u) << stiffness << " " << damping;
        }
}

TEST(SoftShape, ComesBackAfterAFall) {
    for (const int rate : {500, 120})
        for (const int columns : {3, 4, 5}) {
            World world({.tickRate = rate});
            world.add(shapes::floor({-50, 0}, {50, 0}));
            const Blueprint plan = shapes::jelly({.size = {Real(0.4), Real(0.3)},
                                                  .columns = columns,
                                                  .rows = 3,
                                                  .mass = Real(0.5),
                                                  .stiffness = 800,
                                                  .damping = Real(0.6)});
            const Body body = world.add(plan, {.position = {0, 10}, .angle = Real(0.3)});
            test::run(world, 7);
            EXPECT_LT(changeOfShape(world, body, plan), 0.02) << columns << " at " << rate;
        }
}

TEST(SoftShape, ComesBackFromUnderAHeavyCrate) {
    for (const double size : {0.2, 0.5, 1.0, 2.0}) {
        const auto side = static_cast<Real>(size);
        World world;
        world.add(shapes::floor({-50, 0}, {50, 0}));
        const Blueprint plan = shapes::jelly({.size = {side, side},
                                              .columns = 3,
                                              .rows = 3,
                                              .radius = side / 16,
                                              .stiffness = 500 / side});
        const Body body = world.add(plan, {.position = {0, 0.05 + size / 2}});
        const Body crate = world.add(shapes::box({.size = {2 * side, side}, .mass = 50}),
                                     {.position = {0, 0.1 + 1.5 * size}});
        test::run(world, 3);
        EXPECT_LT(world.centreOfMass(crate).y(), 0.05 + 1.4 * size) << size << ": it presses";
        for (const JointId id : body.joints()) {
            const JointInfo info = world.info(id);
            if (info.radius == 0) continue;
            EXPECT_GT(world.position(info.a).y(), 0.05) << size << ": the floor holds";
        }
        world.remove(crate.id());
        test::run(world, 5);
        EXPECT_LT(changeOfShape(world, body, plan), 0.02) << size;
    }
}

/// A crate of 10 to 100 times the mass falls on a jelly and presses it flat. Where the middle of a
/// jelly has gone through its rim, it takes up to 20 s to come back.
TEST(SoftShape, ComesBackAfterItWasFlat) {
    for (const int columns : {3, 4, 5})
        for (const Real stiffness : {Real(200), Real(1000)})
            for (const Real mass : {Real(10), Real(50), Real(100)})
                for (const int rate : {60, 500}) {
                    World world({.tickRate = rate});
                    world.add(shapes::floor({-20, 0}, {20, 0}));
                    const Blueprint plan = shapes::jelly({.columns = columns,
                                                          .rows = columns,
                                                          .stiffness = stiffness,
                                                          .damping = 2});
                    const Body body = world.add(plan, {.position = {0, 0.551}});
                    const Body crate = world.add(shapes::box({.size = {2, 1}, .mass = mass}),
                                                 {.position = {0, 1.7}});
                    const double energy = world.energy();
                    test::run(world, 5);
                    const auto what = testing::Message()
                                      << columns << " columns, " << stiffness << " N/m, " << mass
                                      << " kg, " << rate << " Hz";
                    EXPECT_LT(world.energy(), energy) << what;
                    world.remove(crate);
                    test::run(world, 20);
                    EXPECT_LT(changeOfShape(world, body, plan), 0.02) << what;
                }
}

// --- heaps ------------------------------------------------------------------------------------

struct Heap {
    World world;
    std::vector<Body> jellies, balls;
};

Blueprint smallJelly() {
    return shapes::jelly({.size = {Real(0.5), Real(0.5)}, .columns = 3, .rows = 3});
}
Blueprint capsule() {
    Blueprint plan;
    plan.particles = {{.position = {Real(-0.3), 0}}, {.position = {Real(0.3), 0}}};
    plan.joints = {{.a = 0, .b = 1, .radius = Real(0.06)}};
    return plan;
}

/// Jellies, balls, capsules and planks of random sizes fall into a pit.
void fill(Heap& heap, std::uint32_t seed) {
    test::Random random(seed);
    const auto real = [&](double low, double high) {
        return static_cast<Real>(random.uniform(low, high));
    };
    World& world = heap.world;
    world.add(shapes::floor({-3, 0}, {3, 0}));
    world.add(shapes::floor({-3, 8}, {-3, 0}));
    world.add(shapes::floor({3, 0}, {3, 8}));
    for (int i = 0; i < 40; ++i) {
        const Pose pose{.position = {random.uniform(-2.4, 2.4), 0.5 + 0.45 * i},
                        .angle = real(0, 6)};
        const auto kind = static_cast<int>(random.uniform(0, 4));
        if (kind == 0) heap.jellies.push_back(world.add(smallJelly(), pose));
        if (kind == 1)
            heap.balls.push_back(
                world.add(shapes::ball({.radius = real(0.05, 0.25), .mass = real(0.2, 3)}), pose));
        if (kind == 2) world.add(capsule(), pose);
        if (kind == 3)
            world.add(shapes::box({.size = {real(0.3, 0.8), real(0.1, 0.3)}, .mass = real(0.5, 4)}),
                      pose);
        test::run(world, 0.25);
    }
    test::run(world, 10);
}

/// Of the rim of a jelly of three by three, anticlockwise.
std::vector<Point> rimOf(const World& world, const Body& jelly) {
    std::vector<Point> rim;
    for (const std::size_t k : {0, 1, 2, 5, 8, 7, 6, 3}) rim.push_back(world.position(jelly[k]));
    return rim;
}
double areaOf(const std::vector<Point>& rim) {
    double twice = 0;
    for (std::size_t k = 0; k < rim.size(); ++k) twice += cross(rim[k], rim[(k + 1) % rim.size()]);
    return twice / 2;
}
bool surrounds(const std::vector<Point>& rim, const Point& place) {
    double turned = 0;
    for (std::size_t k = 0; k < rim.size(); ++k) {
        const Point from = rim[k] - place, to = rim[(k + 1) % rim.size()] - place;
        turned += std::atan2(cross(from, to), from.dot(to));
    }
    return std::abs(turned) > 3;
}

TEST(SoftShape, NobodyEndsInAJellyOfAHeap) {
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
        Heap heap;
        fill(heap, seed);
        for (const Body& jelly : heap.jellies) {
            const auto rim = rimOf(heap.world, jelly);
            EXPECT_GT(areaOf(rim), 0.1 * 0.5 * 0.5) << seed << ": crushed";
            for (const Body& ball : heap.balls)
                EXPECT_FALSE(surrounds(rim, heap.world.position(ball[0]))) << seed;
        }
    }
}

}  // namespace
}  // namespace sulfur
