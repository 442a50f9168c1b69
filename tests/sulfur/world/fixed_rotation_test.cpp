// Bodies that do not turn.
#include "helpers.hpp"

namespace sulfur {
namespace {

TEST(FixedRotation, APushAtACornerTurnsNothing) {
    for (const Blueprint& plan : {shapes::box({.mass = 2}), test::disc()}) {
        World world({.gravity = {0, 0}, .sleeping = false});
        const Body body = world.add(plan, {.angle = 0.3});
        EXPECT_FALSE(body.fixedRotation());
        body.setFixedRotation(true);
        EXPECT_TRUE(body.fixedRotation());
        const Real mass = body.mass();
        for (int i = 0; i < 500; ++i) {
            body.applyForce({mass, 0}, {0, 0.5});
            body.applyTorque(1);
            world.step();
        }
        EXPECT_NEAR(body.meanVelocity().x(), 0.999, 1e-5);  // half a tick ago
        EXPECT_NEAR(body.meanVelocity().y(), 0, 1e-6);
        EXPECT_NEAR(body.angle(), 0.3, 1e-6);
        EXPECT_EQ(body.angularVelocity(), 0);
        EXPECT_TRUE(std::isfinite(world.energy()));
    }
}

TEST(FixedRotation, TakesTheSpinAwayAndGivesTurningBack) {
    for (const Blueprint& plan : {shapes::box(), test::disc()}) {
        World world({.gravity = {0, 0}, .sleeping = false});
        const Body body = world.add(plan);
        body.setVelocity({1, 0}, 3);
        test::run(world, 0.1);
        EXPECT_NEAR(body.angularVelocity(), 3, 1e-4);
        body.setFixedRotation(true);
        world.step();
        const double angle = body.angle();
        for (int i = 0; i < 50; ++i) {
            if (i == 25) body.setVelocity({1, 0}, 3);
            world.step();
        }
        EXPECT_EQ(body.angularVelocity(), 0);
        EXPECT_NEAR(body.angle(), angle, 1e-6);
        EXPECT_NEAR(body.meanVelocity().x(), 1, 1e-5);
        body.setPose({.position = {0, 0}, .angle = 1});
        world.step();
        EXPECT_NEAR(body.angle(), 1, 1e-6);
        body.setFixedRotation(false);
        body.applyAngularImpulse(body.inertia());
        test::run(world, 0.1);
        EXPECT_NEAR(body.angularVelocity(), 1, 1e-3);
    }
}

/// It stands on an edge, with half of it and more over the abyss, and bears a crate there.
TEST(FixedRotation, StandsOnAnEdge) {
    for (const bool on : {true, false}) {
        World world;
        world.add(shapes::floor({-5, 0}, {0, 0}));
        const Body body = world.add(shapes::box(), {.position = {0.3, 0.56}});
        const Body upper = world.add(shapes::box(), {.position = {0.4, 1.57}});
        body.setFixedRotation(on);
        test::run(world, 3);
        EXPECT_EQ(world.asleep(body), on);
        EXPECT_EQ(world.asleep(upper), on);
        if (!on) continue;
        EXPECT_NEAR(body.angle(), 0, 1e-9);
        EXPECT_NEAR(body.centreOfMass().y(), 0.55, 0.01);
        EXPECT_NEAR(upper.centreOfMass().y(), 1.55, 0.02);
        EXPECT_NEAR(upper.angle(), 0, 0.01);
    }
}

/// Down a slope of 45 degrees with kinetic friction 0.5: half of what a slide without would be.
TEST(FixedRotation, ADiscSlides) {
    World world({.sleeping = false});
    world.add(shapes::floor({-20, 20}, {20, -20}));
    const double up = 0.55 / std::sqrt(0.5);
    const Body body = world.add(test::disc(), {.position = {0, up + 0.01}});
    body.setFixedRotation(true);
    test::run(world, 0.2);
    const double before = test::speedOf(body);
    test::run(world, 1);
    EXPECT_NEAR(test::speedOf(body) - before, 9.81 * std::sqrt(0.5) / 2, 0.05);
    EXPECT_EQ(body.angularVelocity(), 0);
}

TEST(FixedRotation, HangsAskew) {
    World world({.airFriction = 2, .sleeping = false});
    const Body hook = world.add({.kind = BodyKind::fixed, .particles = {{.position = {0, 2}}}});
    const Body body = world.add(shapes::box(), {.position = {0, 0}});
    const Body other = world.add(
        shapes::rope({.from = {5, 0}, .to = {6, 0}, .links = 3, .radius = 0, .pinFirst = true}));
    const Body weight = world.add(shapes::box(), {.position = {6.5, -0.5}});
    world.connect(hook[0], body[0]);
    world.attach(other.back(), weight, {Real(-0.5), Real(0.5)});
    for (const Body& one : {body, weight}) one.setFixedRotation(true);
    const double length = (world.position(body[0]) - Point(0, 2)).norm();
    test::run(world, 8);
    for (const Body& one : {body, weight}) {
        EXPECT_NEAR(one.angle(), 0, 1e-9);
        EXPECT_LT(test::speedOf(one), 0.01);
    }
    EXPECT_NEAR((world.position(body[0]) - Point(0, 2)).norm(), length, 1e-3);
    EXPECT_NEAR(world.position(body[0]).x(), 0, 0.02);
    EXPECT_NEAR(weight.centreOfMass().x(), 5.5, 0.02);
}

/// What keeps it from turning acts on all of it: its joints bear what they would otherwise.
TEST(FixedRotation, StrainsNoJoint) {
    const auto forces = [](bool on) {
        World world({.gravity = {0, 0}});
        Blueprint plan = shapes::box();
        for (JointSpec& joint : plan.joints) joint.strength = 1000;
        const Body body = world.add(plan);
        body.setFixedRotation(on);
        world.applyForce(body[0], {10, 3});
        world.step();
        std::vector<double> pulls;
        for (const JointId j : body.joints())
            pulls.push_back(static_cast<double>(world.info(j).force));
        return pulls;
    };
    const auto turns = forces(false), stands = forces(true);
    double most = 0;
    for (std::size_t k = 0; k < turns.size(); ++k) {
        EXPECT_NEAR(stands[k], turns[k], 1e-3);
        most = std::max(most, std::abs(stands[k]));
    }
    EXPECT_GT(most, 1);
}

TEST(FixedRotation, IsKeptBySnapshotsAndByPieces) {
    World world({.sleeping = false}), other;
    const Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body wall = world.add(shapes::wall({.strength = 30}), {.position = {0, 5}, .angle = 0.3});
    const auto before = world.hash();
    wall.setFixedRotation(false);
    EXPECT_EQ(world.hash(), before);
    wall.setFixedRotation(true);
    EXPECT_NE(world.hash(), before);
    while (world.bodies().size() == 2 && world.time() < 3) world.step();  // it falls, and breaks
    ASSERT_GT(world.bodies().size(), 2u);
    other.restore(world.snapshot());
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(other.hash(), world.hash());
        world.step();
        other.step();
    }
    for (const BodyId id : other.bodies()) EXPECT_NE(other.fixedRotation(id), id == floor.id());
}

TEST(FixedRotation, RefusesBodiesThatAreGone) {
    World world;
    const Body gone = world.add(shapes::box());
    world.remove(gone);
    test::expectRefused(world, ErrorCode::staleHandle, [&] { gone.setFixedRotation(true); });
    test::expectRefused(world, ErrorCode::staleHandle, [&] { gone.fixedRotation(); });
}

}  // namespace
}  // namespace sulfur
