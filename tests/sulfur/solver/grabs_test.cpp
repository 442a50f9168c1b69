#include "helpers.hpp"

namespace sulfur {
namespace {

TEST(Grab, SwingsWithItsFrequencyAndDamping) {
    for (const Real mass : {Real(0.01), Real(1), Real(5000)}) {
        World world({.gravity = {0, 0}});
        const Body ball = world.add(shapes::ball({.mass = mass}));
        world.grab(ball[0], {1, 0}, {.frequency = 2, .dampingRatio = 0});
        int crossings = 0;
        bool before = false;
        for (int i = 0; i < 1000; ++i) {
            world.step();
            const bool beyond = world.position(ball[0]).x() > 1;
            crossings += beyond != before;
            before = beyond;
        }
        EXPECT_EQ(crossings, 8) << mass;  // 2 s of 2 Hz
    }
}

TEST(Grab, BringsABodyToItsTargetAndKeepsItThere) {
    World world({.airFriction = 1});
    const Body box = world.add(shapes::box({.mass = 20}));
    const GrabId id = world.grab(box, {0, Real(0.4)}, {2, 3});
    test::run(world, 8);
    // It hangs g / (2 pi f)^2 = 1 cm below.
    const GrabInfo info = world.info(id);
    EXPECT_EQ(info.body, box.id());
    EXPECT_NEAR((info.point - Point(2, 3)).norm(), 0.01, 0.01);
    EXPECT_NEAR(info.force.y(), 20 * 9.81, 20);
    EXPECT_NEAR(world.centreOfMass(box).y(), 3 - 0.4, 0.05);
    world.release(id);
    test::run(world, 0.5);
    EXPECT_LT(world.centreOfMass(box).y(), 1.7);
}

TEST(Grab, CarriesARopeByItsEnd) {
    World world;
    const Body rope = world.add(shapes::rope({.from = {0, 0}, .to = {0, -2}, .mass = 2}));
    const GrabId id = world.grab(rope.front(), {0, 0});
    for (int i = 0; i < 1000; ++i) {
        world.setTarget(id, {0.002 * i, 0});
        world.step();
    }
    test::run(world, 3);
    EXPECT_NEAR((world.position(rope.front()) - Point(2, 0)).norm(), 0, 0.15);
}

TEST(Grab, IsStableWithAnyStiffnessAndMass) {
    for (const Real frequency : {Real(0.1), Real(30), Real(1000)}) {
        for (const Real ratio : {Real(0), Real(1), Real(100)}) {
            for (const Real mass : {Real(1e-6), Real(1e6)}) {
                World world;
                const Body jelly = world.add(shapes::jelly({.mass = mass}));
                const Body box = world.add(shapes::box({.mass = mass}), {.position = {9, 0}});
                const GrabOptions options{frequency, ratio, infinite};
                world.grab(jelly[0], {0, 3}, options);
                world.grab(box, {Real(0.3), Real(0.3)}, {9, 3}, options);
                test::run(world, 3);
                EXPECT_EQ(world.validate(), "");
                EXPECT_LT((world.centreOfMass(box) - Point(9, 3)).norm(), 60)
                    << frequency << ' ' << ratio << ' ' << mass;
            }
        }
    }
}

TEST(Grab, PullsNoHarderThanAllowed) {
    World world({.gravity = {0, 0}});
    const Body ball = world.add(shapes::ball({.mass = 2}));
    const GrabId id = world.grab(ball[0], {1000, 0}, {.frequency = 100, .maxForce = Real(6)});
    test::run(world, 1);
    EXPECT_NEAR(world.velocity(ball[0]).x(), 3, 0.02);
    EXPECT_NEAR(world.info(id).force.norm(), 6, 0.01);
    // However far the target, nothing is faster than what the world allows.
    const Body other = world.add(shapes::ball(), {.position = {0, 5}});
    world.grab(other[0], {1e9, 1e9}, {.frequency = 1000, .maxForce = infinite});
    test::run(world, 1);
    EXPECT_EQ(world.validate(), "");
}

TEST(Grab, WakesWhatItHoldsAndLetsItSleep) {
    World world;
    world.add(shapes::floor({-9, 0}, {9, 0}));
    const Body near = world.add(shapes::jelly({.damping = 4}), {.position = {0, 0.6}});
    const auto sleeps = [&] {
        for (int i = 0; i < 5000 && !world.asleep(near); ++i) world.step();
        return world.asleep(near);
    };
    ASSERT_TRUE(sleeps());
    const GrabId id = world.grab(near[0], world.position(near[0]));
    EXPECT_FALSE(world.asleep(near));
    ASSERT_TRUE(sleeps());
    world.setTarget(id, {1, 2});
    EXPECT_FALSE(world.asleep(near));
    world.release(id);
    ASSERT_TRUE(sleeps());
}

TEST(Grab, EndsWithWhatItHolds) {
    World world;
    const Body a = world.add(shapes::box()), b = world.add(shapes::box(), {.position = {5, 0}});
    const GrabId first = world.grab(a, {0, 0}, {0, 1});
    const GrabId second = world.grab(b[0], {5, 1});
    EXPECT_EQ(world.grabs(), (std::vector{first, second}));
    world.remove(a);
    EXPECT_FALSE(world.contains(first));
    EXPECT_EQ(world.grabs(), std::vector{second});
    EXPECT_THROW(world.setTarget(first, {0, 0}), Error);
    world.step();
    EXPECT_EQ(world.grabs(), std::vector{second});
    EXPECT_EQ(world.info(second).body, b.id());
    world.release(second);
    EXPECT_THROW(world.release(second), Error);
}

TEST(Grab, NonsenseIsRefused) {
    World world;
    const Body box = world.add(shapes::box());
    const Body floor = world.add(shapes::floor({-9, -5}, {9, -5}));
    const GrabId id = world.grab(box[0], {0, 1});
    using Code = ErrorCode;
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const auto refused = [&](Code code, const GrabOptions& options) {
        test::expectRefused(world, code, [&] { world.grab(box[0], {0, 1}, options); });
    };
    refused(Code::outOfRange, {.frequency = 0});
    refused(Code::outOfRange, {.frequency = 2000});
    refused(Code::notFinite, {.frequency = nan});
    refused(Code::outOfRange, {.dampingRatio = -1});
    refused(Code::outOfRange, {.maxForce = Real(0)});
    test::expectRefused(world, Code::notFinite, [&] { world.setTarget(id, {std::nan(""), 0}); });
    test::expectRefused(world, Code::degenerate, [&] { world.grab(floor[0], {0, 0}); });
    test::expectRefused(world, Code::outOfRange, [&] { world.grab(box, {500, 500}, {0, 0}); });
    test::expectRefused(world, Code::staleHandle, [&] { world.grab(BodyId{}, {0, 0}, {0, 0}); });
    test::expectRefused(world, Code::staleHandle, [&] { world.release({}); });
}

TEST(Grab, BelongsToTheState) {
    World world;
    const Body rope = world.add(shapes::rope());
    const auto before = world.hash();
    const GrabId id = world.grab(rope.back(), {1, 1});
    EXPECT_NE(world.hash(), before);
    test::run(world, 0.3);
    const Snapshot snapshot = world.snapshot();
    World other;
    other.restore(snapshot);
    EXPECT_TRUE(other.contains(id));
    test::run(world, 1);
    test::run(other, 1);
    EXPECT_EQ(world.hash(), other.hash());
}

TEST(Grab, InADamagedSnapshotIsRefusedOrHarmless) {
    World world;
    const Body box = world.add(shapes::box());
    world.grab(box, {Real(0.1), 0}, {1, 1});
    world.add(WindField{.zone = CircleZone{{0, 0}, 2}});
    const Snapshot good = world.snapshot();
    // The end of a snapshot is about fields and grabs.
    int refused = 0;
    for (std::size_t back = 1; back <= 210; ++back) {
        Snapshot bad = good;
        bad[bad.size() - back] ^= std::byte{0x41};
        World other;
        try {
            other.restore(bad);
        } catch (const Error& error) {
            EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(ErrorCode::badSnapshot));
            ++refused;
        }
        EXPECT_EQ(other.validate(), "") << back;
    }
    EXPECT_GT(refused, 30);
}

}  // namespace
}  // namespace sulfur
