#include "helpers.hpp"

namespace sulfur {
namespace {

WorldSettings weightless() {
    return {.gravity = {0, 0}};
}

TEST(Fields, UniformIsASecondGravity) {
    World plain, world(weightless());
    world.add(UniformField{.acceleration = plain.gravity()});
    const Body a = plain.add(shapes::box({.mass = 3})), b = world.add(shapes::box({.mass = 3}));
    test::run(plain, 1);
    test::run(world, 1);
    EXPECT_NEAR(world.centreOfMass(b).y(), -9.81 / 2, 1e-3);
    EXPECT_NEAR(world.centreOfMass(b).y(), plain.centreOfMass(a).y(), 1e-4);
}

TEST(Fields, LightAndHeavyAnswerAlike) {
    World world(weightless());
    world.add(RadialField{.centre = {0, 5}, .strength = 20});
    const Body light = world.add(shapes::ball({.mass = Real(0.01)}), {.position = {3, 5}});
    const Body heavy = world.add(shapes::ball({.mass = 1000}), {.position = {-3, 5}});
    test::run(world, 1);
    EXPECT_NEAR(world.position(light[0]).x(), -world.position(heavy[0]).x(), 1e-5);
    EXPECT_LT(world.position(light[0]).x(), 2);
}

TEST(Fields, ActOnlyInTheirZoneAndOnTheirMask) {
    World world(weightless());
    world.add(UniformField{.zone = BoxZone{{-1, -1}, {1, 1}}, .acceleration = {1, 0}});
    world.add(UniformField{.zone = CircleZone{{10, 0}, 2}, .acceleration = {0, 1}, .mask = 4});
    const auto still = [&](Point place, std::uint32_t category) {
        Blueprint ball = shapes::ball();
        ball.filter.category = category;
        const Body body = world.add(ball, {.position = place});
        world.step();
        const bool result = world.velocity(body[0]).isZero(0);
        world.remove(body);
        return result;
    };
    EXPECT_FALSE(still({0.9, -0.9}, 1));
    EXPECT_TRUE(still({1.1, 0}, 1));
    EXPECT_FALSE(still({11.3, 1.3}, 4));
    EXPECT_FALSE(still({11.3, 1.3}, 6));
    EXPECT_TRUE(still({11.3, 1.3}, 1));
    EXPECT_TRUE(still({11.5, 1.5}, 4));
}

TEST(Fields, RadialFollowsItsLaw) {
    const auto acceleration = [](const RadialField& field, double distance) {
        World world(weightless());
        world.add(field);
        const Body ball = world.add(shapes::ball(), {.position = {distance, 0}});
        const Real before = 0;
        world.setVelocity(ball[0], {before, 0});
        world.step();  // the first kick is half a tick's
        return -static_cast<double>(world.velocity(ball[0]).x()) /
               (static_cast<double>(world.tickDuration()) / 2);
    };
    for (const int falloff : {0, 1, 2, 3, 4}) {
        const RadialField field{.strength = 8, .falloff = falloff, .core = Real(0.5), .reach = 4};
        EXPECT_NEAR(acceleration(field, 1), 8, 1e-3);
        EXPECT_NEAR(acceleration(field, 3) / (8 / std::pow(3.0, falloff)), 1, 1e-4);
        const double atCore = 8 / std::pow(0.5, falloff);
        EXPECT_NEAR(acceleration(field, 0.25) / (atCore / 2), 1, 1e-4);
        EXPECT_EQ(acceleration(field, 4.1), 0);
        EXPECT_EQ(acceleration(field, 0), 0);
    }
    EXPECT_NEAR(acceleration({.strength = -8}, 2), -2, 1e-3);
    EXPECT_LE(acceleration({.strength = Real(1e12), .falloff = 4}, 0.2), 1.001e6);
}

TEST(Fields, AnOrbitCloses) {
    // Gravity's law: a circle of radius 2 with g = 10 / 2^2 takes 2 pi sqrt(2 / 2.5) s.
    World world(weightless());
    world.add(RadialField{.strength = 10});
    const Body ball = world.add(shapes::ball(), {.position = {2, 0}});
    world.setVelocity(ball[0], {0, std::sqrt(Real(5))});
    test::run(world, 2 * 3.14159265358979 * std::sqrt(0.8));
    EXPECT_NEAR((world.position(ball[0]) - Point(2, 0)).norm(), 0, 0.02);
}

TEST(Fields, WindCarriesAlongWithItsDrag) {
    World world(weightless());
    world.add(WindField{.velocity = {6, 0}, .drag = 2});
    const Body ball = world.add(shapes::ball());
    test::run(world, 0.5);
    EXPECT_NEAR(world.velocity(ball[0]).x(), 6 * (1 - std::exp(-2 * 0.5)), 0.02);
    test::run(world, 10);
    EXPECT_NEAR(world.velocity(ball[0]).x(), 6, 1e-3);
}

TEST(Fields, NoWindIsTooStrong) {
    // Springs at their stability limit, air friction, and drag as strong as allowed, several times.
    for (const Real drag : {Real(50), Real(500)}) {
        for (const int winds : {1, 5}) {
            World world({.airFriction = 500});
            for (int i = 0; i < winds; ++i) world.add(WindField{.velocity = {3, 0}, .drag = drag});
            const Body jelly = world.add(shapes::jelly({.stiffness = 4000, .damping = Real(0.5)}));
            world.setVelocity(jelly[3], {50, -30});
            double fastest = 0;
            for (int i = 0; i < 2000; ++i) {
                world.step();
                if (i < 100) continue;
                for (const auto p : jelly.particles())
                    fastest = std::max(fastest, static_cast<double>(world.velocity(p).norm()));
            }
            EXPECT_LT(fastest, 3.1) << drag << " x " << winds;
            EXPECT_LT((world.position(jelly[0]) - world.position(jelly[15])).norm(), 2);
            EXPECT_EQ(world.validate(), "");
        }
    }
}

TEST(Fields, WakeWhatTheyActUponWhenChangedAndLetItSleepAgain) {
    World world;
    world.add(shapes::floor({-20, 0}, {20, 0}));
    const Body near = world.add(shapes::jelly({.damping = 4}), {.position = {0, 0.6}});
    const Body far = world.add(shapes::jelly({.damping = 4}), {.position = {10, 0.6}});
    const auto sleeps = [&](BodyId body) {
        for (int i = 0; i < 5000 && !world.asleep(body); ++i) world.step();
        return world.asleep(body);
    };
    ASSERT_TRUE(sleeps(near) && sleeps(far));
    const Zone here = BoxZone{{-2, -2}, {2, 2}};
    const FieldId id = world.add(UniformField{.zone = here, .acceleration = {1, 0}});
    EXPECT_FALSE(world.asleep(near));
    EXPECT_TRUE(world.asleep(far));
    EXPECT_TRUE(sleeps(near));  // friction holds it against the field
    world.set(id, UniformField{.zone = here, .acceleration = {2, 0}});
    EXPECT_FALSE(world.asleep(near));
    EXPECT_TRUE(sleeps(near));
    world.remove(id);
    EXPECT_FALSE(world.asleep(near));
    EXPECT_TRUE(world.asleep(far));
}

TEST(Fields, AreListedChangedAndRemoved) {
    World world;
    const FieldId a = world.add(UniformField{.acceleration = {1, 2}});
    const FieldId b = world.add(RadialField{});
    const FieldId c = world.add(WindField{.drag = 7});
    EXPECT_EQ(world.fields(), (std::vector{a, b, c}));
    world.set(b, WindField{.drag = 3});
    EXPECT_EQ(std::get<WindField>(world.field(b)).drag, 3);
    world.remove(a);
    EXPECT_EQ(world.fields(), (std::vector{b, c}));
    EXPECT_EQ(std::get<WindField>(world.field(c)).drag, 7);
    EXPECT_FALSE(world.contains(a));
    EXPECT_THROW(world.field(a), Error);
    EXPECT_THROW(world.set(a, RadialField{}), Error);
    EXPECT_THROW(world.remove(a), Error);
    EXPECT_THROW(world.remove(FieldId{}), Error);
}

TEST(Fields, NonsenseIsRefused) {
    World world;
    const FieldId id = world.add(RadialField{});
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const std::pair<Field, ErrorCode> cases[] = {
        {UniformField{.acceleration = {nan, 0}}, ErrorCode::notFinite},
        {UniformField{.acceleration = {Real(2e6), 0}}, ErrorCode::outOfRange},
        {UniformField{.zone = BoxZone{{0, 0}, {1, 0}}}, ErrorCode::degenerate},
        {UniformField{.zone = CircleZone{{0, 0}, 0}}, ErrorCode::outOfRange},
        {UniformField{.zone = CircleZone{{std::nan(""), 0}, 1}}, ErrorCode::notFinite},
        {RadialField{.falloff = 5}, ErrorCode::outOfRange},
        {RadialField{.core = 0}, ErrorCode::outOfRange},
        {RadialField{.reach = 0}, ErrorCode::outOfRange},
        {RadialField{.strength = infinite}, ErrorCode::notFinite},
        {WindField{.drag = 501}, ErrorCode::outOfRange},
        {WindField{.drag = -1}, ErrorCode::outOfRange},
        {WindField{.velocity = {0, 3000}}, ErrorCode::outOfRange},
    };
    for (const auto& [field, code] : cases) {
        test::expectRefused(world, code, [&, &wrong = field] { world.add(wrong); });
        test::expectRefused(world, code, [&, &wrong = field] { world.set(id, wrong); });
    }
}

TEST(Fields, BelongToTheState) {
    World world;
    const auto before = world.hash();
    world.add(UniformField{.zone = BoxZone{{0, 0}, {4, 4}}, .acceleration = {3, 1}});
    const auto one = world.hash();
    EXPECT_NE(one, before);
    const FieldId id = world.add(WindField{.zone = CircleZone{{1, 1}, 3}, .velocity = {2, 0}});
    world.add(RadialField{.centre = {2, 2}, .strength = -4, .falloff = 1});
    const auto three = world.hash();
    EXPECT_NE(three, one);
    world.add(shapes::jelly(), {.position = {2, 2}});
    const Snapshot snapshot = world.snapshot();
    World other;
    other.restore(snapshot);
    EXPECT_EQ(other.fields(), world.fields());
    EXPECT_EQ(std::get<WindField>(other.field(id)).velocity, Vec2(2, 0));
    test::run(world, 1);
    test::run(other, 1);
    EXPECT_EQ(world.hash(), other.hash());
    EXPECT_EQ(world.snapshot(), other.snapshot());
}

}  // namespace
}  // namespace sulfur
