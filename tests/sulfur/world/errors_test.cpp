#include "helpers.hpp"

namespace sulfur {
namespace {

using test::expectRefused;

const Real nan = std::numeric_limits<Real>::quiet_NaN();

TEST(Errors, WorldSettings) {
    EXPECT_THROW(World({.tickRate = 59}), Error);
    EXPECT_THROW(World({.tickRate = 10001}), Error);
    EXPECT_THROW(World({.gravity = {nan, 0}}), Error);
    EXPECT_THROW(World({.airFriction = -1}), Error);
    EXPECT_THROW(World({.sweeps = 0}), Error);
    EXPECT_NO_THROW(World({.tickRate = 60}));
    EXPECT_NO_THROW(World({.tickRate = 10000}));
}

TEST(Errors, BadBlueprintLeavesTheWorldUnchanged) {
    World world;
    world.add(shapes::box());
    Blueprint plan = shapes::box();
    plan.particles[2].mass = nan;
    expectRefused(world, ErrorCode::notFinite, [&] { world.add(plan); });
    expectRefused(world, ErrorCode::notFinite, [&] {
        world.add(shapes::box(), {.position = {NAN, 0}});
    });
    expectRefused(world, ErrorCode::outOfRange, [&] {
        world.add(shapes::box(), {.position = {1e12, 0}});
    });
    EXPECT_EQ(world.bodies().size(), 1u);
}

TEST(Errors, TheSmallestMassIsAllowed) {
    World world;
    EXPECT_NO_THROW(world.add(shapes::ball({.mass = Real(1e-9)})));
    test::expectRefused(world, ErrorCode::outOfRange,
                        [&] { world.add(shapes::ball({.mass = Real(0.9e-9)})); });
}

TEST(Errors, StaleAndNullHandles) {
    World world;
    const Body body = world.add(shapes::box());
    const ParticleId particle = body[0];
    const JointId joint = body.joints()[0];
    world.remove(body);
    for (const ParticleId id : {particle, ParticleId{}, ParticleId{77, 1}}) {
        expectRefused(world, ErrorCode::staleHandle, [&] { world.setVelocity(id, {0, 0}); });
        expectRefused(world, ErrorCode::staleHandle, [&] { world.position(id); });
    }
    expectRefused(world, ErrorCode::staleHandle, [&] { world.setStiffness(joint, 1); });
    expectRefused(world, ErrorCode::staleHandle, [&] { world.remove(joint); });
    expectRefused(world, ErrorCode::staleHandle, [&] { world.remove(body); });
    expectRefused(world, ErrorCode::staleHandle, [&] { world.body(body.id()); });
    expectRefused(world, ErrorCode::staleHandle, [&] { world.setSensor(body, true); });
    expectRefused(world, ErrorCode::staleHandle, [&] { world.sensor(body); });
    expectRefused(world, ErrorCode::staleHandle, [&] { world.visitors(body); });
    expectRefused(world, ErrorCode::staleHandle, [&] { world.remove(AttachmentId{1, 1}); });
}

TEST(Errors, NumbersOutOfRange) {
    World world;
    const Body body = world.add(shapes::box());
    const Body ground = world.add(shapes::floor({-9, -9}, {9, -9}));
    const ParticleId p = body[0];
    const JointId j = body.joints()[0];
    expectRefused(world, ErrorCode::notFinite, [&] { world.applyForce(p, {nan, 0}); });
    expectRefused(world, ErrorCode::notFinite, [&] { world.applyImpulse(p, {infinite, 0}); });
    expectRefused(world, ErrorCode::outOfRange, [&] { world.setVelocity(p, {Real(1e9), 0}); });
    expectRefused(world, ErrorCode::outOfRange, [&] { world.setMass(p, -1); });
    expectRefused(world, ErrorCode::outOfRange, [&] { world.setMass(p, 0); });
    expectRefused(world, ErrorCode::outOfRange, [&] { world.setMass(p, Real(1e11)); });
    expectRefused(world, ErrorCode::outOfRange, [&] { world.setStiffness(j, -1); });
    expectRefused(world, ErrorCode::notFinite, [&] { world.setStiffness(j, nan); });
    expectRefused(world, ErrorCode::outOfRange, [&] { world.setDamping(j, -1); });
    expectRefused(world, ErrorCode::degenerate, [&] { world.setRestLength(j, 0); });
    expectRefused(world, ErrorCode::notFinite, [&] { world.setGravity({0, nan}); });
    expectRefused(world, ErrorCode::notFinite, [&] { world.castSegment({0, NAN}, {0, 0}); });
    expectRefused(world, ErrorCode::degenerate, [&] { world.setVelocity(ground, {1, 0}); });
    expectRefused(world, ErrorCode::degenerate, [&] { world.moveTo(body, {}); });
    expectRefused(world, ErrorCode::outOfRange,
                  [&] { world.setMaterial(body, {.restitution = 2}); });
}

TEST(Errors, PlacesLieBetweenTwoTicks) {
    World world;
    const Body ball = world.add(shapes::ball());
    world.step();
    const auto place = [&](double alpha) {
        return [&world, &ball, alpha] { world.interpolated(ball.front(), alpha); };
    };
    for (const double alpha : {std::nan(""), double(infinite), -double(infinite)})
        expectRefused(world, ErrorCode::notFinite, place(alpha));
    for (const double alpha : {7.0, -0.01, std::nextafter(1.0, 2.0), -1e-300})
        expectRefused(world, ErrorCode::outOfRange, place(alpha));
    for (const double alpha : {0.0, -0.0, 0.5, 1.0}) EXPECT_NO_THROW(place(alpha)());
}

TEST(Errors, ImpossibleConnections) {
    World world;
    const Body a = world.add(shapes::ball());
    const Body b = world.add(shapes::ball());  // the same place
    const Body ground = world.add(shapes::floor({-9, -9}, {9, -9}));
    expectRefused(world, ErrorCode::degenerate, [&] { world.connect(a.front(), a.front()); });
    expectRefused(world, ErrorCode::degenerate, [&] { world.connect(a.front(), b.front()); });
    expectRefused(world, ErrorCode::degenerate,
                  [&] { world.connect(ground.front(), ground.back()); });
    expectRefused(world, ErrorCode::degenerate, [&] { world.attach(a.front(), a, {0, 0}); });
    EXPECT_NO_THROW(world.connect(a.front(), b.front(), {.stiffness = 10}));
}

}  // namespace
}  // namespace sulfur
