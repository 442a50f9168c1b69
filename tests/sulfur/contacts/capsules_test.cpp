// A body of one capsule is rigid, and round at both ends.
#include <algorithm>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr double radius = 0.3;  // m, of capsules and discs

Blueprint capsule(double half) {
    return shapes::rope({.from = Vec2(static_cast<Real>(-half), 0),
                         .to = Vec2(static_cast<Real>(half), 0),
                         .links = 1,
                         .mass = 1,
                         .radius = static_cast<Real>(radius)});
}

double distance(const Point& p, const Point& a, const Point& b) {
    const Point along = b - a;
    const double share = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - a - share * along).norm();
}
/// m, of two lines that do not cross.
double distance(const World& world, const Body& one, const Body& other) {
    const Point a = world.position(one.front()), b = world.position(one.back()),
                c = world.position(other.front()), d = world.position(other.back());
    return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

TEST(Capsules, ALoneOneIsARigidComponent) {
    World world;
    const Body rod = world.add(capsule(0.4));
    world.step();
    EXPECT_EQ(world.statistics().clusters, 1u);
    EXPECT_EQ(world.statistics().trees, 0u);
    EXPECT_EQ(world.statistics().rigidJoints, 0u);
    world.setPinned(rod.front(), true);
    world.step();
    EXPECT_EQ(world.statistics().clusters, 0u);
    world.setPinned(rod.front(), false);
    world.connect(world.add(capsule(0.4), {.position = {2, 0}}).front(), rod.back());
    world.step();
    EXPECT_EQ(world.statistics().clusters, 2u);
}

TEST(Capsules, ThatFallOnEachOtherDoNotOverlap) {
    World world;
    world.add(shapes::floor(Vec2(-20, 0), Vec2(20, 0)));
    test::Random random(5);
    std::vector<Body> heap;
    for (int i = 0; i < 12; ++i)
        heap.push_back(
            world.add(capsule(0.4), {.position = {random.uniform(-0.3, 0.3), 1 + 1.5 * i},
                                     .angle = random.uniform(0, 6.3)}));
    for (int tick = 0; tick < 1500; ++tick) {
        world.step();
        for (std::size_t i = 0; i < heap.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                ASSERT_GT(distance(world, heap[i], heap[j]), 2 * radius - 0.01)
                    << i << " and " << j << " in tick " << tick;
    }
}

/// Who had come from above the line of a capsule was held above it, also beyond its end.
TEST(Capsules, ADiscRollsRoundTheEndOfAFixedOne) {
    for (const double speed : {-0.1, -0.3, -1.0}) {
        World world({.gravity = {-10, 0}, .sleeping = false});
        world.add(shapes::floor(Vec2(-2, 0), Vec2(0, 0), static_cast<Real>(radius)));
        const Body disc = world.add(shapes::ball({.radius = static_cast<Real>(radius)}),
                                    {.position = {2 * radius - 0.0001, 0.02}});
        world.setVelocity(disc, {0, static_cast<Real>(speed)});
        world.step();
        const double energy = world.energy();
        for (int tick = 0; tick < 2000; ++tick) {
            world.step();
            const Point place = world.position(disc.front());
            ASSERT_GT(distance(place, {-2, 0}, {0, 0}), 2 * radius - 0.001) << speed;
            ASSERT_LT(world.energy(), energy + 1e-4) << speed;
        }
        EXPECT_LT(world.position(disc.front()).y(), -0.25) << speed;
    }
}

/// One end strikes a floor at 300 m/s before the other. Whoever is met first is struck first: blows
/// on both ends and on the middle, in any other order, threw it back at up to 90 m/s.
/// What comes and goes between two bodies that something else ties already collides as long as it
/// is there.
TEST(Capsules, BetweenTiedBodiesCollideWhileTheyAreThere) {
    World world({.gravity = Vec2(0, 0)});
    const Body left = world.add(capsule(0.4), {.position = {-2, 0}}),
               right = world.add(capsule(0.4), {.position = {2, 0}});
    world.connect(left.back(), right.front());
    const auto throwOver = [&] {
        const Body ball = world.add(shapes::ball({.radius = Real(0.1)}), {.position = {0, 1}});
        world.setVelocity(ball, {0, -2});
        test::run(world, 1);
        const double y = world.centreOfMass(ball)[1];
        world.remove(ball);
        return y;
    };
    EXPECT_LT(throwOver(), -0.9);
    const JointId bar = world.connect(left.back(), right.front(), {.radius = Real(0.05)});
    EXPECT_GT(throwOver(), -0.5);
    world.remove(bar);
    EXPECT_LT(throwOver(), -0.8);
}

TEST(Capsules, ThatSlamDownDoNotComeBack) {
    for (const int rate : {500, 1000, 2000, 4000}) {
        World world({.tickRate = rate});
        constexpr double half = 0.25, thick = 0.02;
        for (int i = -10; i < 10; ++i)
            world.add(shapes::floor(Vec2(Real(0.5) * Real(i), -Real(thick)),
                                    Vec2(Real(0.5) * Real(i + 1), -Real(thick)), Real(thick)));
        const Body rod = world.add(shapes::rope({.from = Vec2(0, -Real(half)),
                                                 .to = Vec2(0, Real(half)),
                                                 .links = 1,
                                                 .mass = 1,
                                                 .radius = Real(thick)}),
                                   {.position = {0, 1}, .angle = 1.2});
        world.setVelocity(rod, {0, -300});
        test::run(world, 0.01);
        for (const ParticleId end : rod.particles())
            EXPECT_LT(world.velocity(end).norm(), 20) << rate << " Hz";
    }
}

}  // namespace
}  // namespace sulfur
