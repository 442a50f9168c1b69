// Handles of mechanisms: who keeps, tells, copies and refuses them.
#include <array>
#include <cmath>
#include <vector>

#include "mechanism_ends.hpp"

namespace sulfur {
namespace {

using test::boxAt, test::fixedAt;

TEST(Mechanisms, GoWithWhatTheyHold) {
    World world;
    const Body frame = fixedAt(world, {0, 0}), other = fixedAt(world, {3, 0});
    const Body a = boxAt(world, {0.5, 0}), b = boxAt(world, {3, 0});
    const std::size_t bodies = world.bodies().size();
    const MechanismId first = world.hinge(frame, a, {0, 0}), second = world.hinge(other, b, {3, 0});
    const MechanismId gear = world.gear(first, second, 1);
    EXPECT_EQ(world.mechanisms(), (std::vector{first, second, gear}));
    EXPECT_FALSE(world.collision(frame, a));
    EXPECT_GT(world.bodies().size(), bodies);  // pins
    world.remove(a);
    EXPECT_FALSE(world.contains(first));
    EXPECT_FALSE(world.contains(gear));
    EXPECT_TRUE(world.contains(second));
    world.remove(second);
    EXPECT_TRUE(world.collision(other, b));
    EXPECT_EQ(world.bodies().size(), bodies - 1);
    EXPECT_TRUE(world.attachments().empty());
    EXPECT_EQ(world.validate(), "");
    world.step();
}

TEST(Mechanisms, KeepTheirBodiesApartUntilTheLastIsGone) {
    World world;
    const Body a = boxAt(world, {0, 0}), b = boxAt(world, {1, 0});
    const MechanismId first = world.hinge(a, b, {0.5, 0}),
                      second = world.distance(a, {0, 0}, b, {1, 0}, {.collide = false});
    world.remove(first);
    EXPECT_FALSE(world.collision(a, b));
    world.remove(second);
    EXPECT_TRUE(world.collision(a, b));
    // What the caller has forbidden stays so.
    world.setCollision(a, b, false);
    world.remove(world.hinge(a, b, {0.5, 0}));
    EXPECT_FALSE(world.collision(a, b));
}

TEST(Mechanisms, SnapshotsKnowThem) {
    World world;
    const Body frame = fixedAt(world, {0, 0}), arm = boxAt(world, {0.5, 0});
    const MechanismId hinge = world.hinge(frame, arm, {0, 0}, {.drive = {.lower = Real(-0.5)}});
    world.distance(frame, {0, 0}, boxAt(world, {0, -2}), {0, -2}, {.drive = {.stiffness = 100}});
    test::run(world, 0.3);
    World copy = world.clone();
    const Snapshot snapshot = world.snapshot();
    test::run(world, 1);
    test::run(copy, 1);
    EXPECT_EQ(copy.hash(), world.hash());
    EXPECT_EQ(copy.info(hinge).force, world.info(hinge).force);
    world.restore(snapshot);
    test::run(world, 1);
    EXPECT_EQ(copy.hash(), world.hash());
    EXPECT_EQ(world.validate(), "");
}

TEST(Mechanisms, CountFromTheValueThatTheyAreGiven) {
    World world({.gravity = {0, 0}});
    const Body frame = fixedAt(world, {0, 0}), door = boxAt(world, {0.5, 0});
    const Drive drive{.upper = 2};
    const MechanismId hinge = world.hinge(frame, door, {0, 0}, {.drive = drive, .value = 1.5});
    EXPECT_NEAR(world.info(hinge).value, 1.5, 1e-12);
    const Body cart = boxAt(world, {0, 5});
    const MechanismId rail = world.slider(frame, cart, {0, 5}, {1, 0}, {.value = -3});
    EXPECT_NEAR(world.info(rail).value, -3, 1e-12);
    const MechanismId weld =
        world.weld(cart, boxAt(world, {1, 5}), {0.5, 5}, {.stiffness = 1, .value = 0.25});
    EXPECT_NEAR(world.info(weld).value, 0.25, 1e-12);
    door.setVelocity({0, 5}, 10);
    for (int i = 0; i < 200; ++i) world.step();
    EXPECT_NEAR(door.angle(), 0.5, 1e-3) << "where the limit is";
    EXPECT_THROW(world.hinge(frame, cart, {0, 5}, {.value = 1e7}), Error);
}

TEST(Mechanisms, CountOnFromWhereADiscWasTurnedBeforeItsFirstTick) {
    for (const bool stepped : {false, true}) {
        World world({.gravity = {0, 0}});
        const Body disc = world.add(shapes::ball(), {.angle = -1});
        if (stepped) world.step();
        disc.setPose({.position = {0, 0}, .angle = 2});
        const MechanismId hinge = world.hinge(fixedAt(world, {0, 0}), disc, {0, 0});
        disc.setVelocity({0, 0}, 6);
        EXPECT_NEAR(world.info(hinge).value, 0, 1e-12);
        for (int i = 0; i < 50; ++i) world.step();
        EXPECT_NEAR(world.info(hinge).value, 0.6, 1e-6);
        EXPECT_NEAR(disc.angle(), 2.6, 1e-6);
    }
}

TEST(Mechanisms, TellHowTheyWereMade) {
    World world;
    const Body frame = fixedAt(world, {0, 0}), a = boxAt(world, {0, -2}), b = boxAt(world, {3, -2});
    const MechanismInfo hinge = world.info(world.hinge(a, b, {1.5, -1}, {.strength = 70}));
    EXPECT_TRUE(hinge.pin);
    EXPECT_FALSE(hinge.collide);
    EXPECT_TRUE(hinge.vetoes);
    EXPECT_EQ(hinge.strength, 70);
    EXPECT_EQ(world.particles(hinge.own[0]).size(), 1u);
    EXPECT_EQ(world.info(hinge.pins[1]).particle, world.particles(hinge.own[0])[0]);
    const MechanismId rail = world.slider(frame, a, {0, -2}, {0, 3}, {.turns = false});
    EXPECT_FALSE(world.info(rail).turns);
    EXPECT_NEAR(static_cast<double>(world.info(rail).axis.y()), 1, 1e-6);
    const MechanismId rope =
        world.pulley(a, {0, -2}, {0, 3}, b, {3, -2}, {3, 4}, frame, {.ratio = 2});
    EXPECT_EQ(world.info(rope).frame, frame);
    EXPECT_NEAR((world.info(rope).overB - Point(3, 4)).norm(), 0, 1e-6);
    const MechanismId turn = world.hinge(frame, b, {3, -2}, {.collide = true, .pin = false});
    EXPECT_FALSE(world.info(turn).pin);
    EXPECT_TRUE(world.info(turn).collide);
    const MechanismInfo gear = world.info(world.gear(turn, rail, 3));
    EXPECT_EQ(gear.first, turn);
    EXPECT_EQ(gear.second, rail);
    world.remove(frame);
    EXPECT_FALSE(world.contains(rope)) << "its frame is gone";
}

TEST(Mechanisms, RefuseWhatCannotBe) {
    World world;
    const Body frame = fixedAt(world, {0, 0}), other = fixedAt(world, {1, 0});
    const Body box = boxAt(world, {0.5, 0}),
               rod = world.add({.particles = {{.position = {4, 5}}, {.position = {6, 5}}},
                                .joints = {{.a = 0, .b = 1}}});
    const std::uint64_t hash = world.hash();
    const std::size_t bodies = world.bodies().size();
    const auto refused = [&](auto&& call, ErrorCode code, const char* says) {
        try {
            call();
            FAIL() << says;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), code) << e.what();
            EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
        }
    };
    refused([&] { world.hinge(frame, other, {0, 0}); }, ErrorCode::degenerate, "dynamic");
    refused([&] { world.hinge(box, box, {0, 0}); }, ErrorCode::degenerate, "two bodies");
    refused([&] { world.hinge(box, BodyId{}, {0, 0}); }, ErrorCode::staleHandle, "second body");
    refused([&] { world.hinge(BodyId{}, box, {0, 0}); }, ErrorCode::staleHandle, "first body");
    refused([&] { world.hinge(rod, box, {5, 7}); }, ErrorCode::degenerate, "first body");
    refused([&] { world.slider(frame, box, {0, 0}, {0, 0}); }, ErrorCode::degenerate, "axis");
    refused(
        [&] {
            world.hinge(frame, box, {0, 0}, {.drive = {.lower = 1, .upper = 0}});
        },
        ErrorCode::outOfRange, "lower");
    refused(
        [&] {
            world.hinge(frame, box, {0, 0}, {.drive = {.stiffness = -1}});
        },
        ErrorCode::outOfRange, "stiffness");
    refused([&] { world.setDrive(MechanismId{}, {}); }, ErrorCode::staleHandle, "mechanism");
    refused([&] { world.gear(MechanismId{}, MechanismId{}, 1); }, ErrorCode::staleHandle,
            "mechanism");
    refused(
        [&] {
            world.pulley(box, {0.5, 0}, {0, 3}, rod, {5, 5}, {1, 3}, BodyId{});
        },
        ErrorCode::staleHandle, "frame");
    const auto onRail = [&](const std::vector<JointId>& rail, Point at) {
        return [&world, rod, box, rail, at] { world.slider(rod, box, at, rail); };
    };
    const JointId link = rod.joints()[0], foreign = box.joints()[0];
    refused(onRail({}, {0.5, 0}), ErrorCode::degenerate, "the rail has no joint");
    refused(onRail({link, JointId{}}, {0.5, 0}), ErrorCode::staleHandle, "joint 1 of the rail");
    refused(onRail({link, foreign}, {0.5, 0}), ErrorCode::degenerate,
            "joint 1 of the rail is not of the first body");
    refused(onRail({link, link}, {0.5, 0}), ErrorCode::degenerate, "twice");
    refused(onRail({link}, {0.5, 0}), ErrorCode::degenerate, "m beside the rail");
    refused(
        [&] {
            world.slider(box, rod, {4, 5}, std::vector{foreign, box.joints()[2]});
        },
        ErrorCode::degenerate, "joint 1 of the rail does not begin where the one before ends");
    EXPECT_TRUE(world.collision(frame, box));
    EXPECT_EQ(world.hash(), hash);
    EXPECT_EQ(world.bodies().size(), bodies);
    EXPECT_EQ(world.mechanisms().size(), 0u);
}
}  // namespace
}  // namespace sulfur
