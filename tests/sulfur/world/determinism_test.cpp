#include "helpers.hpp"

namespace sulfur {
namespace {

void build(World& world) {
    world.add(shapes::ground({.points = {{-6, 9}, {-6, 0}, {0, -1}, {6, 0}, {6, 9}}}));
    for (int i = 0; i < 20; ++i) {
        const Pose pose{{-4.5 + 1.3 * (i % 7), 1 + 1.4 * (i / 7)}, 0.37 * i};
        if (i % 2 == 0)
            world.add(shapes::box({.size = {Real(0.9), Real(0.7)}, .strength = 2000}), pose);
        else
            world.add(shapes::blob({.radius = Real(0.45)}), pose);
    }
    world.add(shapes::rope(
        {.from = {-4, 8}, .to = {4, 8}, .slack = Real(0), .pinFirst = true, .pinLast = true}));
    const Body load = world.add(shapes::box({.mass = 50}), {.position = {3, 10}});
    const Body tether = world.add(
        shapes::rope({.from = {0, Real(10.5)}, .to = {Real(2.5), Real(10.5)}, .pinFirst = true}));
    world.attach(tether.back(), load, {Real(-0.5), Real(0.5)});
    world.add(shapes::jelly({.stiffness = Real(1e6), .damping = 5}), {.position = {-3, 10}});
    world.add(shapes::cloth({.columns = 8, .rows = 6}), {.position = {-12, 4}});
}

TEST(Determinism, SameScenesGiveSameHashes) {
    World a, b;
    build(a);
    build(b);
    for (int i = 0; i < 300; ++i) {
        a.step();
        b.step();
        ASSERT_EQ(a.hash(), b.hash()) << i;
    }
}

/// The promise across compilers, optimisation levels and sanitizers: this number is the same in
/// every build. When a change of the physics is meant, the new number is printed by the failure.
TEST(Determinism, GoldenHash) {
    World world;
    build(world);
    test::run(world, 1);
#ifdef SULFUR_REAL_DOUBLE
    EXPECT_EQ(world.hash(), 11918120721301507804u);
#else
    EXPECT_EQ(world.hash(), 5641917245865028683u);
#endif
}

TEST(Determinism, ProfilingDoesNotMatter) {
    World a, b;
    build(a);
    build(b);
    b.setProfiling(true);
    test::run(a, 0.5);
    test::run(b, 0.5);
    EXPECT_EQ(a.hash(), b.hash());
    double total = 0;
    for (const double s : b.statistics().seconds) total += s;
    EXPECT_GT(total, 0);
}

}  // namespace
}  // namespace sulfur
