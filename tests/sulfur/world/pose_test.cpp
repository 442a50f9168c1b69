// Where a body is as a whole, and putting it elsewhere.
#include <numbers>

#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr double pi = std::numbers::pi;

/// rad, from one angle to another, the shorter way.
double angleBetween(double from, double to) {
    return std::remainder(to - from, 2 * pi);
}

void expectPose(const Pose& pose, const Pose& expected, double within) {
    EXPECT_LT((pose.position - expected.position).norm(), within);
    EXPECT_LT(std::abs(angleBetween(expected.angle, pose.angle)), within);
    EXPECT_LE(std::abs(pose.angle), pi);
}

Blueprint kinematic(Blueprint plan) {
    plan.kind = BodyKind::kinematic;
    return plan;
}

/// A particle that is not at the origin of its frame.
Blueprint particle(Real radius, bool pinned = false) {
    Blueprint plan;
    plan.particles = {
        {.position = {Real(0.3), Real(-0.2)}, .mass = 2, .radius = radius, .pinned = pinned}};
    return plan;
}

/// Of all kinds that differ in how they move.
std::vector<Blueprint> plans() {
    return {shapes::box(),
            shapes::box({.size = {2, Real(0.5)}, .solidInertia = false}),
            shapes::wheel(),
            shapes::ball(),
            particle(0),
            particle(Real(0.1)),
            particle(Real(0.1), true),
            shapes::jelly(),
            shapes::rope({.links = 5, .pinFirst = true}),
            shapes::floor({-1, 0}, {3, 1}),
            kinematic(shapes::box()),
            kinematic(shapes::ball())};
}

TEST(Pose, AddingGivesItBack) {
    test::Random random(1);
    World world;
    for (int i = 0; i < 50; ++i)
        for (const Blueprint& plan : plans()) {
            const Pose pose{{random.uniform(-50, 50), random.uniform(-50, 50)},
                            random.uniform(-20, 20)};
            const Body body = world.add(plan, pose);
            expectPose(body.pose(), pose, 1e-12);
            expectPose(body.interpolatedPose(0.3), pose, 1e-12);
            EXPECT_EQ(body.angle(), body.pose().angle);
        }
}

/// m/s and rad/s; a world below 480 Hz takes several steps in a tick.
void expectFlight(int rate, const Blueprint& plan) {
    const Vec2 velocity(3, 4);
    const double spin = 2.5;
    World world({.gravity = {0, -8}, .tickRate = rate});
    const Body body = world.add(plan, {.position = {1, 2}, .angle = 0.3});
    const Point centre = body.centreOfMass();
    const Point offset = centre - body.pose().position;
    body.setVelocity(velocity, spin);
    for (int tick = 1; tick <= 2 * rate; ++tick) {
        world.step();
        const double t = tick * static_cast<double>(world.tickDuration());
        const double angle = 0.3 + spin * t, c = std::cos(spin * t), s = std::sin(spin * t);
        const Point place = centre + t * velocity.cast<double>() + Point(0, -4 * t * t);
        const Point arm(c * offset[0] - s * offset[1], s * offset[0] + c * offset[1]);
        expectPose(body.pose(), {place - arm, angle}, 1e-5);
        EXPECT_NEAR(body.angularVelocity(), spin, 1e-12);
    }
}

TEST(Pose, FreeFlightIsThatOfMechanics) {
    for (const int rate : {60, 500})
        for (const Blueprint& plan :
             {shapes::box(), shapes::wheel(), shapes::ball(), particle(Real(0.1)),
              shapes::polygon({.points = {
                                   {0, 0},
                                   {2, 0},
                                   {0, 1},
                               }})})
            expectFlight(rate, plan);
}

TEST(Pose, AVelocityAloneStopsAllButTheSpinOfDiscs) {
    World world({.gravity = {0, 0}});
    for (const Blueprint& plan :
         {shapes::box(), kinematic(shapes::box()), shapes::jelly(), shapes::ball()}) {
        const Body body = world.add(plan, {.position = {0, 9.0 * double(world.bodies().size())}});
        body.setVelocity({0, 0}, 3);
        test::run(world, 0.1);
        body.setVelocity({1, 0});
        const double kept = plan.particles.size() == 1 ? 3 : 0;
        EXPECT_NEAR(body.angularVelocity(), kept, 1e-9) << plan.name;
        test::run(world, 0.1);
        EXPECT_NEAR(body.angularVelocity(), kept, 1e-3) << plan.name;
        EXPECT_NEAR(double(body.meanVelocity().x()), 1, 1e-6) << plan.name;
    }
}

TEST(Pose, AThousandTurnsAreCountedExactly) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const double spin = 60;
    const std::vector<Body> bodies{
        world.add(shapes::box(), {.angle = 1}),
        world.add(shapes::ball(), {.position = {9, 0}, .angle = 1}),
        world.add(kinematic(shapes::box()), {.position = {-9, 0}, .angle = 1}),
        world.add(kinematic(shapes::ball()), {.position = {0, 9}, .angle = 1})};
    for (const Body& body : bodies) body.setVelocity({0, 0}, spin);
    const long ticks = std::lround(1000 * 2 * pi / spin * world.settings().tickRate);
    for (long i = 0; i < ticks; ++i) world.step();
    const double turned =
        spin * static_cast<double>(ticks) * static_cast<double>(world.tickDuration());
    for (const Body& body : bodies) {
        EXPECT_NEAR(angleBetween(1 + turned, body.angle()), 0, 1e-8);
        EXPECT_NEAR(body.angularVelocity(), spin, 1e-12);
        EXPECT_LT(test::largestStrain(world, body), 1e-6);
    }
    EXPECT_LT((bodies[2].pose().position - Point(-9, 0)).norm(), 1e-6);
}

// --- bodies that are not rigid -------------------------------------------------------------

/// kg m^2: the sum that a fit makes as small as it can.
double misfit(const World& world, const Body& body, const Blueprint& plan, const Pose& pose) {
    const double c = std::cos(pose.angle), s = std::sin(pose.angle);
    double sum = 0;
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Point q = plan.particles[i].position.cast<double>();
        const Point place = pose.position + Point(c * q[0] - s * q[1], s * q[0] + c * q[1]);
        sum += static_cast<double>(plan.particles[i].mass) *
               (world.position(body[i]) - place).squaredNorm();
    }
    return sum;
}

TEST(Pose, OfASoftBodyIsTheBestFit) {
    test::Random random(2);
    Blueprint plan = shapes::jelly({.columns = 3, .rows = 4});
    for (auto& p : plan.particles) p.mass = static_cast<Real>(random.uniform(0.2, 3));
    for (int i = 0; i < 20; ++i) {
        World world;
        const Body body = world.add(plan, {{random.uniform(-9, 9), 3}, random.uniform(-3, 3)});
        for (const ParticleId p : body.particles())
            world.setPosition(
                p, world.position(p) + Point(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)));
        const Pose pose = body.pose();
        const double best = misfit(world, body, plan, pose);
        for (const double by : {-1e-3, 1e-3}) {
            EXPECT_GT(misfit(world, body, plan, {pose.position, pose.angle + by}), best);
            EXPECT_GT(misfit(world, body, plan, {pose.position + Point(by, 0), pose.angle}), best);
            EXPECT_GT(misfit(world, body, plan, {pose.position + Point(0, by), pose.angle}), best);
        }
    }
}

TEST(Pose, StretchingDoesNotTurn) {
    World world;
    const Blueprint plan = shapes::jelly();
    const Body body = world.add(plan);
    const double c = std::cos(0.8), s = std::sin(0.8);
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Point q = plan.particles[i].position.cast<double>();
        const Point stretched(1.6 * q[0] + 0.3 * q[1], 0.3 * q[0] + 0.7 * q[1]);
        world.setPosition(body[i], Point(c * stretched[0] - s * stretched[1],
                                         s * stretched[0] + c * stretched[1]));
    }
    EXPECT_NEAR(body.angle(), 0.8, 1e-6);
}

TEST(Pose, WhatIsTurnedInsideOutKeepsTheAngleThatItWasPlacedWith) {
    World world;
    const Blueprint plan = shapes::box({.solidInertia = false});
    const Body body = world.add(plan, {.angle = 0.7});
    const auto mirror = [&] {
        for (std::size_t i = 0; i < body.size(); ++i) {
            const Vec2 q = plan.particles[i].position;
            world.setPosition(body[i], Point(-q[0], q[1]));
        }
    };
    mirror();
    EXPECT_NEAR(body.angle(), 0.7, 1e-12);
    body.setPose({.angle = -2});
    EXPECT_NEAR(body.angle(), -2, 1e-12);
}

/// Two triangles that a weak joint holds together, and a disc at another one.
Blueprint fragile() {
    Blueprint plan;
    plan.particles = {{.position = {-2, 0}},
                      {.position = {-1, 1}},
                      {.position = {-1, -1}},
                      {.position = {2, 0}},
                      {.position = {1, 1}},
                      {.position = {1, -1}},
                      {.position = {-2, -2}, .radius = Real(0.1)}};
    const auto side = [](std::uint32_t a, std::uint32_t b) {
        return JointSpec{.a = a, .b = b, .radius = Real(0.05)};
    };
    plan.joints = {side(0, 1), side(1, 2), side(2, 0), side(3, 4), side(4, 5), side(5, 3)};
    for (const auto& [a, b] : {std::pair(1u, 4u), {2u, 5u}, {1u, 5u}, {0u, 6u}, {2u, 6u}})
        plan.joints.push_back({.a = a, .b = b, .strength = 5});
    return plan;
}

TEST(Pose, PiecesKeepTheFrameOfTheirBody) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body body = world.add(fragile(), {.position = {3, 4}, .angle = 2});
    body.setVelocity({0, 0}, 0.5);
    test::run(world, 1);
    ASSERT_EQ(world.bodies().size(), 1u);
    const double before = body.angle();
    body.setVelocity({0, 0}, 3);
    std::vector<Body> pieces;
    for (int i = 0; i < 10 && pieces.size() < 2; ++i) {
        world.step();
        for (const BodySplit& split : world.events().bodiesSplit)
            pieces.push_back(world.body(split.piece));
    }
    ASSERT_EQ(pieces.size(), 2u);
    pieces.push_back(body);
    for (const Body& piece : pieces) {
        EXPECT_NEAR(angleBetween(before, piece.angle()), 0, 0.1) << piece.size();
        EXPECT_LT((piece.pose().position - body.pose().position).norm(), 0.05) << piece.size();
    }
    std::vector<double> angles;
    for (const Body& piece : pieces) angles.push_back(piece.angle());
    test::run(world, 0.2);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double turns =
            static_cast<double>(100 * world.tickDuration()) * pieces[i].angularVelocity();
        EXPECT_NEAR(angleBetween(angles[i] + turns, pieces[i].angle()), 0, 1e-5);
    }
}

TEST(Pose, ADiscThatIsPinnedKeepsHowItIsTurned) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body disc = world.add(shapes::ball(), {.angle = 0.4});
    disc.setVelocity({0, 0}, 2);
    test::run(world, 1);
    const double angle = disc.angle();
    EXPECT_NEAR(angle, 2.4, 1e-6);
    world.setPinned(disc.front(), true);
    test::run(world, 0.1);
    EXPECT_NEAR(disc.angle(), angle, 1e-12);
    EXPECT_EQ(disc.angularVelocity(), 0);
    world.setPinned(disc.front(), false);
    EXPECT_NEAR(disc.angle(), angle, 1e-12);
    disc.setVelocity({0, 0}, -1);
    test::run(world, 0.5);
    EXPECT_NEAR(disc.angle(), angle - 0.5, 1e-6);
    // It is found anew, and others go, in the same tick.
    world.setMass(disc.front(), 3);
    const Body other = world.add(shapes::rope({.from = {9, 0}, .to = {9, 1}, .links = 2}));
    world.remove(other.joints().front());
    EXPECT_NEAR(disc.angle(), angle - 0.5, 1e-6);
}

// --- drawing -------------------------------------------------------------------------------

TEST(Pose, IsInterpolatedBetweenTicks) {
    for (const int rate : {60, 500}) {
        World world({.tickRate = rate});
        std::vector<Body> bodies;
        for (const Blueprint& plan : {shapes::box(), shapes::ball(), shapes::jelly(),
                                      kinematic(shapes::box()), kinematic(shapes::ball())})
            bodies.push_back(
                world.add(plan, {.position = {4.0 * static_cast<double>(bodies.size()), 0}}));
        for (const Body& body : bodies) body.setVelocity({2, 3}, 4);
        for (int i = 0; i < 20; ++i) {
            std::vector<Pose> before;
            for (const Body& body : bodies) before.push_back(body.pose());
            world.step();
            for (std::size_t k = 0; k < bodies.size(); ++k) {
                const Pose now = bodies[k].pose();
                expectPose(bodies[k].interpolatedPose(0), before[k], 1e-6);
                expectPose(bodies[k].interpolatedPose(1), now, 1e-15);
                const double turn = angleBetween(before[k].angle, now.angle);
                EXPECT_GT(turn, 3.0 / rate);
                EXPECT_NEAR(bodies[k].interpolatedPose(0.25).angle, before[k].angle + turn / 4,
                            1e-6);
            }
        }
        for (const Body& body : bodies) {
            body.setPose({.position = {50, 50}, .angle = 1});
            expectPose(body.interpolatedPose(0.5), {{50, 50}, 1}, 1e-9);
        }
    }
}

TEST(Pose, LookingChangesNothingAndASnapshotKeepsAll) {
    World world({.tickRate = 60}), other;
    std::vector<Body> bodies;
    for (const Blueprint& plan : plans())
        bodies.push_back(world.add(
            plan, {.position = {5.0 * static_cast<double>(bodies.size()), 0}, .angle = 1}));
    for (const Body& body : bodies)
        if (world.kind(body) != BodyKind::fixed) body.setVelocity({1, 1}, 3);
    for (int i = 0; i < 30; ++i) {
        const auto hash = world.hash();
        other.restore(world.snapshot());
        EXPECT_EQ(other.hash(), hash);
        for (const Body& body : bodies) {
            const Body twin = other.body(body.id());
            EXPECT_EQ(body.pose().position, twin.pose().position);
            EXPECT_EQ(body.angle(), twin.angle());
            EXPECT_EQ(body.interpolatedPose(0.3).angle, twin.interpolatedPose(0.3).angle);
            EXPECT_EQ(body.angularVelocity(), twin.angularVelocity());
            EXPECT_EQ(body.bounds().low, twin.bounds().low);
            EXPECT_EQ(body.inertia(), twin.inertia());
        }
        EXPECT_EQ(world.hash(), hash);
        world.step();
        other.step();
        EXPECT_EQ(world.hash(), other.hash());
    }
}

// --- bounds and inertia --------------------------------------------------------------------

TEST(Pose, BoundsAreThoseOfCapsulesAndDiscs) {
    World world;
    const Body ball = world.add(shapes::ball({.radius = 2}), {.position = {3, 4}});
    EXPECT_EQ(ball.bounds().low, Point(1, 2));
    EXPECT_EQ(ball.bounds().high, Point(5, 6));
    const Body box =
        world.add(shapes::box({.size = {2, 2}, .radius = Real(0.25)}), {.angle = pi / 4});
    const double reach = 0.75 * std::sqrt(2.0) + 0.25;
    EXPECT_LT((box.bounds().low - Point(-reach, -reach)).norm(), 1e-6);
    EXPECT_LT((box.bounds().high - Point(reach, reach)).norm(), 1e-6);
    world.connect(ball.front(), box.front(), {.radius = 3});
    world.step();
    EXPECT_LT((box.bounds().high - box.bounds().low).norm(), 4.1) << "joints between bodies";
}

TEST(Pose, InertiaIsThatOfTheSolid) {
    World world;
    const Body box = world.add(shapes::box({.size = {2, 1}, .mass = 6}), {.position = {9, 9}});
    EXPECT_NEAR(box.inertia(), 6.0 * 5 / 12, 1e-5);
    const Body wheel = world.add(shapes::wheel({.radius = 2, .mass = 3}));
    EXPECT_NEAR(wheel.inertia(), 6, 1e-4);
    const Body ball = world.add(shapes::ball({.radius = 2, .mass = 3}));
    EXPECT_NEAR(ball.inertia(), 6, 1e-5);
    const Body point = world.add(particle(0));
    EXPECT_EQ(point.inertia(), 0);
    EXPECT_EQ(point.angularVelocity(), 0);
    // Pinned particles count with their own masses.
    world.setPinned(box.front(), true);
    EXPECT_EQ(box.mass(), 6);
    EXPECT_NEAR(box.inertia(), 6.0 * 5 / 12, 1e-5);
}

/// What will turn by itself is known before the first tick.
TEST(Pose, InertiaIsTheSameBeforeTheFirstTick) {
    Blueprint hub = shapes::wheel();
    hub.particles.back().radius = Real(0.2);
    Blueprint beads = shapes::rope({.links = 4, .stiffness = 500});
    for (auto& p : beads.particles) p.radius = Real(0.1);
    for (const Blueprint& plan : {hub, beads, fragile()}) {
        World world({.gravity = {0, 0}});
        const Body body = world.add(plan);
        const Real before = body.inertia();
        world.step();
        EXPECT_EQ(body.inertia(), before);
    }
}

// --- putting it elsewhere ------------------------------------------------------------------

TEST(SetPose, GivesThePose) {
    test::Random random(3);
    World world;
    for (const Blueprint& plan : plans()) {
        const Body body = world.add(plan, {.position = {1, 30}, .angle = 2});
        if (world.kind(body) != BodyKind::fixed) body.setVelocity({1, 2}, 3);
        for (int i = 0; i < 10; ++i) {
            const Pose pose{{random.uniform(-50, 50), random.uniform(50, 80)},
                            random.uniform(-9, 9)};
            body.setPose(pose);
            expectPose(body.pose(), pose, 1e-12);
            if (i % 2 == 0) world.step();
        }
        world.remove(body);
    }
}

/// Relative to its frame.
std::vector<Point> shapeOf(const World& world, const Body& body) {
    const Pose pose = body.pose();
    const double c = std::cos(pose.angle), s = std::sin(pose.angle);
    std::vector<Point> shape;
    for (const ParticleId p : body.particles()) {
        const Point r = world.position(p) - pose.position;
        shape.emplace_back(c * r[0] + s * r[1], c * r[1] - s * r[0]);
    }
    return shape;
}

TEST(SetPose, KeepsShapeMomentaAndEnergy) {
    Blueprint beads = shapes::rope({.links = 4, .stiffness = 500});
    for (auto& p : beads.particles) p.radius = Real(0.1);
    for (const Blueprint& plan :
         {shapes::box(), shapes::wheel(), shapes::jelly(), shapes::ball(), beads, fragile()}) {
        World world({.gravity = {0, 0}});
        const Body body = world.add(plan, {.position = {1, 2}, .angle = 1});
        body.setVelocity({3, -2}, Real(0.7));
        if (plan.particles.size() > 2) world.applyImpulse(body[1], {Real(0.2), Real(0.1)});
        test::run(world, 0.3);
        const auto shape = shapeOf(world, body);
        const Vec2 velocity = body.meanVelocity();
        const double spin = body.angularVelocity(), energy = world.energy();
        const double angular = spin * static_cast<double>(body.inertia());
        body.setPose({.position = {-40, 7}, .angle = -2});
        const auto check = [&] {
            EXPECT_LT((body.meanVelocity() - velocity).norm(), 1e-5);
            EXPECT_NEAR(body.angularVelocity() * static_cast<double>(body.inertia()), angular,
                        1e-5);
            EXPECT_NEAR(world.energy(), energy, 1e-4 * energy);
        };
        check();
        EXPECT_NEAR(body.angularVelocity(), spin, 1e-12);
        const auto after = shapeOf(world, body);
        for (std::size_t i = 0; i < shape.size(); ++i)
            EXPECT_LT((after[i] - shape[i]).norm(), 1e-12);
        world.step();
        check();
    }
}

TEST(SetPose, BringsARigidBodyBackFromAfarExactly) {
    World world({.gravity = {0, 0}});
    const Body body = world.add(shapes::wheel(), {.position = {1, 2}, .angle = 1});
    body.setVelocity({0, 0}, 1);
    world.step();
    const auto shape = shapeOf(world, body);
    for (int i = 0; i < 20; ++i) {
        body.setPose({.position = {3e8, -2e8}, .angle = 0.1 * i});
        world.step();
        body.setPose({.position = {1, 2}, .angle = 0.1 * i});
        world.step();
    }
    const auto after = shapeOf(world, body);
    for (std::size_t i = 0; i < shape.size(); ++i) EXPECT_LT((after[i] - shape[i]).norm(), 1e-12);
    EXPECT_NEAR(body.angularVelocity(), 1, 1e-9);
}

TEST(SetPose, DoesNotGoTheWayBetween) {
    for (const Blueprint& plan : {shapes::box(), shapes::ball(), shapes::jelly()}) {
        World world({.gravity = {0, 0}});
        world.add(shapes::floor({500, -100}, {500, 100}));
        Blueprint gate = shapes::box({.size = {10, 10}});
        gate.kind = BodyKind::fixed;
        gate.sensor = true;
        const Body sensor = world.add(gate, {.position = {250, 0}});
        const Body obstacle = world.add(shapes::box({.size = {2, 2}}), {.position = {700, 0}});
        const Body body = world.add(plan);
        body.setVelocity({100, 0});
        test::run(world, 0.1);
        body.setPose({.position = {1000, 0}, .angle = 1});
        for (int i = 0; i < 10; ++i) {
            world.step();
            EXPECT_TRUE(world.events().contactsBegun.empty());
            EXPECT_TRUE(world.events().sensorsEntered.empty());
            EXPECT_EQ(world.statistics().heldBack, 0u);
        }
        EXPECT_NEAR(body.centreOfMass().x(), 1002, 1e-3);
        EXPECT_EQ(obstacle.centreOfMass(), Point(700, 0));
        EXPECT_TRUE(world.visitors(sensor).empty());
    }
}

TEST(SetPose, WhatItIsPutIntoIsLedApart) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body one = world.add(shapes::box()), other = world.add(shapes::box());
    other.setPose({.position = {30, 0}});
    test::run(world, 0.1);
    other.setPose({.position = {0.5, 0.1}});
    test::run(world, 3);
    EXPECT_GT((one.centreOfMass() - other.centreOfMass()).norm(), 0.98);
    EXPECT_LT(static_cast<double>(other.meanVelocity().norm()), 0.6);
}

TEST(SetPose, WakesItAndWhoeverLeansOnIt) {
    World world({.airFriction = 1});
    const Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body lower = world.add(shapes::box(), {.position = {0, 0.56}});
    const Body upper = world.add(shapes::box(), {.position = {0, 1.57}});
    const auto settle = [&] {
        test::run(world, 6);
        ASSERT_TRUE(world.asleep(lower));
        ASSERT_TRUE(world.asleep(upper));
    };
    settle();
    lower.setPose({.position = {4, 0.56}});
    EXPECT_FALSE(world.asleep(lower));
    EXPECT_FALSE(world.asleep(upper));
    settle();
    EXPECT_LT(upper.centreOfMass().y(), 0.6);
    floor.setPose({.position = {0, -3}});
    EXPECT_FALSE(world.asleep(lower));
    settle();
    EXPECT_NEAR(lower.centreOfMass().y(), -2.45, 0.01);
    const Body pusher = world.add(kinematic(shapes::box()), {.position = {0, 20}});
    settle();
    pusher.setPose({.position = {0.5, -2.4}});
    EXPECT_FALSE(world.asleep(upper));
    EXPECT_TRUE(world.asleep(lower));
    test::run(world, 3);
    EXPECT_GT(std::abs(upper.centreOfMass().x() - 0.5), 0.98);
}

/// Where it is seen by queries at once, also by those of others.
TEST(SetPose, QueriesSeeItWhereItIs) {
    World world;
    const Body box = world.add(shapes::box());
    world.step();
    ASSERT_EQ(world.bodiesAt({0, 0}).size(), 1u);
    box.setPose({.position = {7, 8}});
    EXPECT_TRUE(world.bodiesAt({0, 0}).empty());
    ASSERT_EQ(world.bodiesAt({7, 8}).size(), 1u);
    EXPECT_TRUE(world.castSegment({0, 8}, {20, 8}).has_value());
}

TEST(SetPose, WhatHoldsOnToItGoesOnHolding) {
    World world({.gravity = {0, 0}, .airFriction = 2});
    const Body box = world.add(shapes::box({.mass = 5}));
    const Body rope = world.add(
        shapes::rope({.from = {0, Real(0.5)}, .to = {0, Real(2.5)}, .links = 8, .radius = 0}));
    world.attach(rope.front(), box, {0, Real(0.5)});
    const Body ball = world.add(shapes::ball(), {.position = {3, 0}});
    const GrabId grab = world.grab(ball, {0, 0}, {3, 0});
    test::run(world, 0.1);
    box.setPose({.position = {-1, 0}});
    ball.setPose({.position = {4, 1}});
    EXPECT_EQ(world.attachments().size(), 1u);
    EXPECT_TRUE(world.contains(grab));
    const auto gap = [&] {
        return (world.position(rope.front()) - box.centreOfMass() - Point(0, 0.5)).norm();
    };
    EXPECT_NEAR(gap(), 1, 1e-3);
    test::run(world, 2);
    EXPECT_NEAR((world.position(rope.front()) - box.centreOfMass()).norm(), 0.5, 1e-3);
    EXPECT_LT((ball.centreOfMass() - Point(3, 0)).norm(), 1e-2);
    EXPECT_LT(test::largestStrain(world, rope), 1e-3);
}

TEST(SetPose, ARopeAndWhatIsPinnedComeAlong) {
    World world;
    const Body rope = world.add(shapes::rope({.from = {0, 0}, .to = {2, 0}, .pinFirst = true}));
    test::run(world, 0.4);
    const double spin = rope.angularVelocity();
    rope.setPose({.position = {30, 9}, .angle = -1});
    EXPECT_NEAR(rope.angularVelocity(), spin, 1e-9);
    const Point pin = world.position(rope.front());
    test::run(world, 1);
    EXPECT_EQ(world.position(rope.front()), pin);
    EXPECT_GT(pin.x(), 25);
    EXPECT_LT(test::largestStrain(world, rope), 1e-3);
    const Body pendulum = world.add(shapes::box(), {.position = {0, 9}});
    world.setPinned(pendulum.front(), true);
    test::run(world, 0.3);
    const double swing = pendulum.angularVelocity();
    pendulum.setPose({.position = {0, 5}, .angle = 3});
    EXPECT_NEAR(pendulum.angularVelocity(), swing, 1e-9);
    world.step();
    EXPECT_NEAR(pendulum.angularVelocity(), swing, 0.1);
}

TEST(SetPose, AKinematicBodyForgetsWhereItWasToGo) {
    World world;
    const Body lift = world.add(kinematic(shapes::box()));
    world.moveTo(lift, {.position = {1, 0}});
    lift.setPose({.position = {5, 5}});
    test::run(world, 0.1);
    expectPose(lift.pose(), {{5, 5}, 0}, 1e-9);
    lift.setVelocity({1, 0}, 2);
    test::run(world, 0.5);
    lift.setPose({.position = {-5, 0}, .angle = 0});
    test::run(world, 0.5);
    expectPose(lift.pose(), {{-4.5, 0}, 1}, 1e-6);
}

TEST(SetPose, ThousandsOfTimesLeaveTheBodyAsItWas) {
    test::Random random(5);
    World world({.gravity = {0, 0}});
    const Body body = world.add(shapes::box());
    body.setVelocity({0, 0}, 1);
    world.step();
    const auto shape = shapeOf(world, body);
    for (int i = 0; i < 5000; ++i)
        body.setPose({{random.uniform(-9, 9), 0}, random.uniform(-9, 9)});
    EXPECT_EQ(world.validate(), "");
    const auto after = shapeOf(world, body);
    for (std::size_t i = 0; i < shape.size(); ++i) EXPECT_LT((after[i] - shape[i]).norm(), 1e-12);
    EXPECT_NEAR(body.angularVelocity(), 1, 1e-9);
}

TEST(SetPose, RefusesWhatItCannotDo) {
    using test::expectRefused;
    World world;
    const Body body = world.add(shapes::box());
    const Body gone = world.add(shapes::box());
    world.remove(gone);
    world.step();
    const auto refuse = [&](ErrorCode code, const Body& which, const Pose& pose) {
        expectRefused(world, code, [&] { which.setPose(pose); });
    };
    refuse(ErrorCode::notFinite, body, {{NAN, 0}, 0});
    refuse(ErrorCode::notFinite, body, {{0, INFINITY}, 0});
    refuse(ErrorCode::notFinite, body, {{0, 0}, NAN});
    refuse(ErrorCode::outOfRange, body, {{0, 6e8}, 0});
    refuse(ErrorCode::outOfRange, body, {{0, 0}, 2e6});
    refuse(ErrorCode::staleHandle, gone, {});
    expectRefused(world, ErrorCode::staleHandle, [&] { world.setPose({}, {}); });
    expectRefused(world, ErrorCode::staleHandle, [&] { gone.pose(); });
    expectRefused(world, ErrorCode::staleHandle, [&] { gone.interpolatedPose(1); });
    expectRefused(world, ErrorCode::staleHandle, [&] { gone.angle(); });
    expectRefused(world, ErrorCode::staleHandle, [&] { gone.angularVelocity(); });
    expectRefused(world, ErrorCode::staleHandle, [&] { gone.inertia(); });
    expectRefused(world, ErrorCode::staleHandle, [&] { gone.bounds(); });
    expectRefused(world, ErrorCode::outOfRange, [&] { body.interpolatedPose(1.1); });
    expectRefused(world, ErrorCode::notFinite, [&] { body.interpolatedPose(NAN); });
    // It is torn so far apart that it does not fit at the edge of the world.
    const Body torn = world.add(shapes::rope({.links = 2, .stiffness = 1}));
    world.setPosition(torn[0], {-9e8, 0});
    world.setPosition(torn[2], {9e8, 0});
    refuse(ErrorCode::outOfRange, torn, {{4e8, 4e8}, 0});
}

}  // namespace
}  // namespace sulfur
