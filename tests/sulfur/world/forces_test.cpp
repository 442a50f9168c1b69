// Moving and pushing a body as a whole.
#include "helpers.hpp"

namespace sulfur {
namespace {

using test::expectRefused;

/// Of a body, about a place that does not move.
struct Momenta {
    Point linear{0, 0};  // N s
    double angular = 0;  // N m s

    /// `hasDiscs`: particles with a radius turn by themselves.
    Momenta(const World& world, const Body& body, const Point& about = {0, 0}) {
        for (const ParticleId p : body.particles()) {
            const ParticleInfo info = world.info(p);
            const double m = static_cast<double>(info.mass), r = static_cast<double>(info.radius);
            const Point mv = m * info.velocity.cast<double>();
            linear += mv;
            angular += cross(Point(info.position - about), mv) + m * r * r / 2 * info.spin;
        }
    }
};

Blueprint beads() {
    Blueprint plan = shapes::rope({.links = 4, .stiffness = 500});
    for (auto& p : plan.particles) p.radius = Real(0.1);
    return plan;
}

std::vector<Blueprint> pushedPlans() {
    return {shapes::box({.mass = 3}),
            shapes::wheel(),
            shapes::jelly(),
            shapes::ball({.mass = 2}),
            beads(),
            shapes::polygon({.points = {{0, 0}, {2, 0}, {0, 1}}, .mass = 4})};
}

/// A world in which a body has taken part in a tick, or not yet.
struct Alone {
    explicit Alone(const Blueprint& plan, bool ticked, int rate = 500)
        : world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false}),
          body(world.add(plan, {.position = {1, 2}, .angle = 1})) {
        if (ticked) world.step();
    }
    World world;
    Body body;
};

TEST(Forces, AVelocityIsThatOfARigidBody) {
    for (const Blueprint& plan : pushedPlans())
        for (const bool ticked : {false, true}) {
            Alone s(plan, ticked);
            s.body.setVelocity({3, -1}, 2);
            const Point centre = s.body.centreOfMass();
            for (const ParticleId p : s.body.particles()) {
                const Point r = s.world.position(p) - centre;
                const Vec2 expected(static_cast<Real>(3 - 2 * r.y()),
                                    static_cast<Real>(-1 + 2 * r.x()));
                EXPECT_LT((s.world.velocity(p) - expected).norm(), 1e-5);
            }
            EXPECT_NEAR(s.body.angularVelocity(), 2, 1e-6);
            EXPECT_LT((s.body.meanVelocity() - Vec2(3, -1)).norm(), 1e-5);
            s.world.step();
            EXPECT_NEAR(s.body.angularVelocity(), 2, 1e-3);
            EXPECT_LT((s.body.meanVelocity() - Vec2(3, -1)).norm(), 1e-5);
        }
}

TEST(Forces, AnImpulseGivesBothMomenta) {
    for (const Blueprint& plan : pushedPlans())
        for (const bool ticked : {false, true}) {
            Alone s(plan, ticked);
            s.body.setVelocity({1, 1}, Real(0.5));
            s.world.step();
            const Momenta before(s.world, s.body);
            const Vec2 impulse(Real(0.3), Real(-0.7));
            const Point at = s.body.centreOfMass() + Point(0.3, 0.2);
            s.body.applyImpulse(impulse, at);
            const Point gained = impulse.cast<double>();
            const auto check = [&] {
                const Momenta after(s.world, s.body);
                EXPECT_LT((after.linear - before.linear - gained).norm(), 1e-5);
                EXPECT_NEAR(after.angular - before.angular, cross(at, gained), 1e-5);
            };
            check();
            s.world.step();
            check();
        }
}

/// Before the first tick, nobody has found what of it turns.
TEST(Forces, AnAngularImpulseOnANewDiscWaitsForTheTick) {
    Alone s(shapes::ball({.radius = Real(0.5), .mass = 2}), false);
    s.body.applyAngularImpulse(1);
    EXPECT_NEAR(s.body.angularVelocity(), 4, 1e-6);
    s.body.applyAngularImpulse(1);
    EXPECT_NEAR(s.body.angularVelocity(), 8, 1e-6);
    World other;
    other.restore(s.world.snapshot());
    EXPECT_EQ(other.hash(), s.world.hash());
    s.world.step();
    other.step();
    EXPECT_EQ(other.hash(), s.world.hash());
    EXPECT_NEAR(s.world.info(s.body.front()).spin, 8, 1e-6);
    // A rim pushed along its tangent.
    s.body.applyImpulse({0, 1}, s.body.centreOfMass() + Point(0.5, 0));
    EXPECT_NEAR(s.body.angularVelocity(), 8 + 0.5 / 0.25, 1e-5);
    EXPECT_NEAR(s.body.meanVelocity().y(), 0.5, 1e-6);
}

TEST(Forces, APinnedBodyTurnsAboutItsPin) {
    for (const bool ticked : {false, true}) {
        Alone s(shapes::box({.size = {2, 1}, .mass = 3}), ticked);
        s.world.setPinned(s.body.front(), true);
        if (ticked) s.world.step();
        const Point pin = s.world.position(s.body.front()), centre = s.body.centreOfMass();
        const double inertia =
            static_cast<double>(s.body.inertia()) + 3 * (centre - pin).squaredNorm();
        const Point at = centre + Point(0.4, -0.3);
        s.body.applyImpulse({2, 1}, at);
        s.world.step();
        double spin = cross(Point(at - pin), Point(2, 1)) / inertia;
        EXPECT_NEAR(s.body.angularVelocity(), spin, 1e-5);
        EXPECT_EQ(s.world.position(s.body.front()), pin);
        s.body.applyAngularImpulse(1);
        spin += 1 / inertia;
        s.world.step();
        EXPECT_NEAR(s.body.angularVelocity(), spin, 1e-5);
        const double h = static_cast<double>(s.world.tickDuration());
        for (int i = 0; i < 100; ++i) {
            s.body.applyTorque(4);
            s.world.step();
        }
        EXPECT_NEAR(s.body.angularVelocity(), spin + 100 * h * 4 / inertia, 1e-4);
    }
}

/// Of a soft body the pin bears its share of the push.
TEST(Forces, APinBearsItsShare) {
    Alone s(shapes::jelly({.columns = 2, .rows = 2, .mass = 4}), true);
    s.world.setPinned(s.body.front(), true);
    s.world.step();
    const double pinned = static_cast<double>(s.world.info(s.body.front()).mass);
    s.body.applyImpulse({8, 0}, s.body.centreOfMass());
    const Momenta after(s.world, s.body);
    EXPECT_NEAR(after.linear.x(), 8 * (1 - pinned / 4), 1e-5);
    EXPECT_EQ(s.world.velocity(s.body.front()), Vec2(0, 0));
}

TEST(Forces, ATorqueGivesTOverI) {
    for (const int rate : {60, 500})
        for (const Blueprint& plan : pushedPlans())
            for (const bool ticked : {false, true}) {
                Alone s(plan, ticked, rate);
                const double h = static_cast<double>(s.world.tickDuration());
                const double answer = 0.5 / static_cast<double>(s.body.inertia());
                const double start = s.body.angularVelocity();
                const int ticks = rate / 20;
                for (int i = 0; i < ticks; ++i) {
                    s.body.applyTorque(Real(0.5));
                    s.world.step();
                }
                // Velocities stand in the middle of a step; so does the first one of what is new.
                const double step = rate == 60 ? h / 8 : h;
                const double time = ticks * h - (ticked ? 0 : step / 2);
                // Soft bodies widen as they turn.
                const bool isRigid = s.world.statistics().clusters == 1;
                const double within = isRigid ? 1e-4 : 0.02;
                EXPECT_NEAR(s.body.angularVelocity() - start, answer * time, within * answer * time)
                    << plan.particles.size() << " particles, " << rate << " Hz";
                EXPECT_LT(s.body.meanVelocity().norm(), 1e-5);
                const double spin = s.body.angularVelocity();
                s.world.step();
                EXPECT_NEAR(s.body.angularVelocity(), spin, within * spin) << "only that tick";
            }
}

TEST(Forces, AForceGivesBothMomenta) {
    for (const int rate : {60, 500})
        for (const Blueprint& plan : pushedPlans()) {
            Alone s(plan, true, rate);
            const Momenta before(s.world, s.body);
            const Vec2 force(2, 3);
            const Point at = s.body.centreOfMass() + Point(-0.2, 0.1);
            s.body.applyForce(force, at);
            s.world.step();
            const Point gained = static_cast<double>(s.world.tickDuration()) * force.cast<double>();
            const Momenta after(s.world, s.body);
            EXPECT_LT((after.linear - before.linear - gained).norm(), 1e-5);
            // What it goes in the tick is of second order.
            EXPECT_NEAR(after.angular - before.angular, cross(at, gained), 2e-3 * gained.norm());
        }
}

TEST(Forces, ASoftBodyIsNotDeformedByThePush) {
    Alone s(shapes::jelly({.damping = 0}), true);
    s.body.applyForce({100, 50}, s.body.centreOfMass() + Point(0.5, 0.5));
    s.world.step();
    EXPECT_LT(test::largestStrain(s.world, s.body), 1e-4);
    EXPECT_GT(s.body.meanVelocity().norm(), 0.1);
    s.body.applyImpulse({1, 0}, s.body.centreOfMass() + Point(0, 0.5));
    s.world.step();
    EXPECT_LT(test::largestStrain(s.world, s.body), 1e-3);
}

TEST(Forces, ATorqueRollsABall) {
    World world;
    world.add(shapes::floor({-50, 0}, {50, 0}));
    const Body ball =
        world.add(shapes::ball({.material = {.staticFriction = 2, .kineticFriction = 2}}),
                  {.position = {0, 0.3}});
    test::run(world, 1);
    const double start = ball.centreOfMass().x();
    for (int i = 0; i < 500; ++i) {
        ball.applyTorque(Real(-0.2));
        world.step();
    }
    // T = 3/2 m r a without slip; one second.
    const double way = 0.2 / (1.5 * 0.25) / 2;
    EXPECT_NEAR(ball.centreOfMass().x() - start, way, 0.02 * way);
}

TEST(Forces, AKinematicBodyTurnsByItself) {
    for (const int rate : {60, 500}) {
        World world({.tickRate = rate});
        Blueprint plan = shapes::box({.size = {3, Real(0.5)}});
        plan.kind = BodyKind::kinematic;
        const Body body = world.add(plan, {.position = {1, 2}});
        body.setVelocity({Real(0.1), 0}, 3);
        EXPECT_EQ(body.angularVelocity(), 3);
        test::run(world, 200);
        const double t = 200 * rate * static_cast<double>(world.tickDuration());
        EXPECT_NEAR(std::remainder(body.angle() - 3 * t, 6.283185307179586), 0, 1e-6);
        EXPECT_LT((body.centreOfMass() - Point(1 + 0.1 * t, 2)).norm(), 1e-4);
        EXPECT_LT(test::largestStrain(world, body), 1e-6);
        // Until it is told otherwise.
        const double angle = body.angle();
        body.setVelocity({0, 0});
        test::run(world, 0.1);
        EXPECT_NEAR(body.angle(), angle, 1e-9);
        body.setVelocity({0, 0}, 1);
        test::run(world, 0.1);
        world.moveTo(body, {.position = {0, 0}, .angle = 1});
        test::run(world, 0.1);
        EXPECT_NEAR(body.angle(), 1, 1e-6);
        EXPECT_EQ(body.angularVelocity(), 0);
        body.setVelocity({1, 0}, 2);
        test::run(world, 0.5);
        EXPECT_NEAR(body.angle(), 2, 1e-6) << "after it was moved";
    }
}

/// A turning paddle throws what lies on it, and wakes it.
TEST(Forces, AKinematicBodyThatTurnsPushes) {
    World world;
    Blueprint plan = shapes::box({.size = {4, Real(0.3)}});
    plan.kind = BodyKind::kinematic;
    const Body paddle = world.add(plan);
    const Body crate = world.add(shapes::box(), {.position = {1.2, 0.66}});
    test::run(world, 3);
    ASSERT_TRUE(world.asleep(crate));
    paddle.setVelocity({0, 0}, 4);
    test::run(world, 0.1);
    EXPECT_FALSE(world.asleep(crate));
    EXPECT_GT(crate.meanVelocity().y(), 2);
}

TEST(Forces, WakeUnlessTheyAreNothing) {
    World world({.airFriction = 1});
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body box = world.add(shapes::box(), {.position = {0, 0.56}});
    const auto settle = [&] {
        test::run(world, 4);
        ASSERT_TRUE(world.asleep(box));
    };
    settle();
    const auto hash = world.hash();
    box.applyForce({0, 0}, {3, 3});
    box.applyImpulse({0, 0}, {3, 3});
    box.applyTorque(0);
    box.applyAngularImpulse(0);
    EXPECT_EQ(world.hash(), hash);
    const auto wakes = [&](auto&& call) {
        settle();
        call();
        EXPECT_FALSE(world.asleep(box));
    };
    wakes([&] { box.applyForce({0, 1}, {0, 0}); });
    wakes([&] { box.applyImpulse({0, 1}, {0, 0}); });
    wakes([&] { box.applyTorque(1); });
    wakes([&] { box.applyAngularImpulse(1); });
    wakes([&] { box.setVelocity({0, 0}, 1); });
}

TEST(Forces, DoNothingToWhatPhysicsDoesNotMove) {
    World world;
    const Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    Blueprint plan = shapes::box();
    plan.kind = BodyKind::kinematic;
    const Body lift = world.add(plan, {.position = {0, 3}});
    Blueprint point;
    point.particles = {{}};
    const Body lone = world.add(point);
    world.step();
    const auto hash = world.hash();
    for (const Body& body : {floor, lift}) {
        body.applyForce({1, 2}, {0, 0});
        body.applyImpulse({1, 2}, {0, 0});
        body.applyTorque(3);
        body.applyAngularImpulse(3);
    }
    lone.applyAngularImpulse(3);
    EXPECT_EQ(world.hash(), hash);
}

TEST(Forces, NothingGetsFasterThanTheLimit) {
    for (const bool ticked : {false, true}) {
        Alone s(shapes::ball({.radius = Real(0.01), .mass = Real(1e-3)}), ticked);
        const double most = 2000 / 0.01;
        s.body.applyAngularImpulse(Real(1e11));
        EXPECT_LE(s.body.angularVelocity(), most * 1.0001);
        for (int i = 0; i < 20; ++i) {
            s.body.applyTorque(Real(-1e12));
            s.world.step();
            EXPECT_LE(std::abs(s.body.angularVelocity()), 2 * most);
        }
        EXPECT_LT(s.body.angularVelocity(), -0.99 * most);
        s.body.applyImpulse({Real(1e6), 0}, s.body.centreOfMass());
        EXPECT_LE(s.body.meanVelocity().x(), Real(2000));
        EXPECT_EQ(s.world.validate(), "");
    }
    Alone box(shapes::box(), true);
    box.body.applyAngularImpulse(Real(1e9));
    box.world.step();
    EXPECT_LT(std::abs(box.body.angularVelocity()), 2000 / 0.5);
    EXPECT_EQ(box.world.validate(), "");
}

TEST(Forces, RefuseWhatIsOutOfRange) {
    World world;
    const Body body = world.add(shapes::box());
    const Body floor = world.add(shapes::floor({-9, -9}, {9, -9}));
    const Body gone = world.add(shapes::box());
    const Body ball = world.add(shapes::ball({.radius = 2}), {.position = {20, 0}});
    world.remove(gone);
    world.step();
    const Real nan = std::numeric_limits<Real>::quiet_NaN(), most = Real(2e12);
    for (const Vec2& bad : {Vec2(nan, 0), Vec2(0, infinite)}) {
        expectRefused(world, ErrorCode::notFinite, [&] { body.applyForce(bad, {0, 0}); });
        expectRefused(world, ErrorCode::notFinite, [&] { body.applyImpulse(bad, {0, 0}); });
        expectRefused(world, ErrorCode::notFinite, [&] { body.setVelocity(bad, 0); });
    }
    for (const Point& bad : {Point(NAN, 0), Point(0, INFINITY)}) {
        expectRefused(world, ErrorCode::notFinite, [&] { body.applyForce({1, 0}, bad); });
        expectRefused(world, ErrorCode::notFinite, [&] { body.applyImpulse({1, 0}, bad); });
    }
    for (const Real bad : {nan, infinite}) {
        expectRefused(world, ErrorCode::notFinite, [&] { body.applyTorque(bad); });
        expectRefused(world, ErrorCode::notFinite, [&] { body.applyAngularImpulse(bad); });
        expectRefused(world, ErrorCode::notFinite, [&] {
            body.setVelocity({0, 0}, static_cast<double>(bad));
        });
    }
    const auto outOfRange = [&](auto&& call) { expectRefused(world, ErrorCode::outOfRange, call); };
    outOfRange([&] { body.applyForce({most, 0}, {0, 0}); });
    outOfRange([&] { body.applyForce({1, 0}, {0, 2e9}); });
    outOfRange([&] { body.applyForce({Real(1e12), 0}, {0, 1e8}); });
    outOfRange([&] { body.applyImpulse({most, 0}, {0, 0}); });
    outOfRange([&] { body.applyImpulse({1, 0}, {2e9, 0}); });
    outOfRange([&] { body.applyTorque(most); });
    outOfRange([&] { body.applyAngularImpulse(-most); });
    outOfRange([&] { body.setVelocity({2001, 0}, 0); });
    outOfRange([&] { body.setVelocity({0, 0}, 2e6); });
    outOfRange([&] { body.setVelocity({1999, 0}, 100); });
    outOfRange([&] { ball.setVelocity({0, 0}, 1001); });
    EXPECT_NO_THROW(ball.setVelocity({0, 0}, 999));
    expectRefused(world, ErrorCode::degenerate, [&] { floor.setVelocity({1, 0}, 1); });
    const auto stale = [&](auto&& call) { expectRefused(world, ErrorCode::staleHandle, call); };
    stale([&] { gone.setVelocity({1, 0}, 1); });
    stale([&] { gone.applyForce({1, 0}, {0, 0}); });
    stale([&] { gone.applyImpulse({1, 0}, {0, 0}); });
    stale([&] { gone.applyTorque(1); });
    stale([&] { world.applyAngularImpulse({}, 1); });
}

TEST(Forces, TheSameCallsGiveTheSameBitsAndARestoreKeepsThem) {
    World world({.tickRate = 60}), other;
    std::vector<Body> bodies;
    for (const Blueprint& plan : pushedPlans())
        bodies.push_back(
            world.add(plan, {.position = {5.0 * static_cast<double>(bodies.size()), 0}}));
    for (int i = 0; i < 60; ++i) {
        for (const Body& body : bodies) {
            if (i % 7 == 0) body.applyAngularImpulse(Real(0.1));
            if (i % 5 == 0) body.applyImpulse({0, Real(0.3)}, body.centreOfMass() + Point(0.1, 0));
            body.applyTorque(Real(-0.2));
            body.applyForce({1, 0}, body.centreOfMass() + Point(0, 0.2));
        }
        other.restore(world.snapshot());
        EXPECT_EQ(other.hash(), world.hash());
        world.step();
        other.step();
        ASSERT_EQ(other.hash(), world.hash()) << i;
    }
}

/// Also in the tick after it has come to a pose, in which it would stop.
TEST(Forces, AKinematicBodyGoesOnAsItsVelocitySays) {
    World world;
    Blueprint plan = shapes::box();
    plan.kind = BodyKind::kinematic;
    const Body lift = world.add(plan);
    world.moveTo(lift, {.position = {1, 0}});
    world.step();
    world.setVelocity(lift, {1, 0});
    test::run(world, 1);
    EXPECT_NEAR(lift.centreOfMass()[0], 2, 1e-4);
}

}  // namespace
}  // namespace sulfur
