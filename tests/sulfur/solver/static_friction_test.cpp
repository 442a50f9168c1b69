// What rests on a slope holds up to the static angle, however it came to rest there.
#include <cmath>

#include "helpers.hpp"

namespace sulfur {
namespace {

// The kinetic limit is 0.7 of the static one, the slopes between them are at 0.95 of it.
const Material rough{.staticFriction = Real(0.6), .kineticFriction = Real(0.42)};
constexpr double standardGravity = 9.81;  // m/s^2
const double between = std::atan(0.95 * 0.6), above = std::atan(1.05 * 0.6);
// For what shakes when it is put down: the downhill corner of a polygon carries nearly all of it,
// the corners of what is soft are not loaded alike.
const double lower = std::atan(0.85 * 0.6);

/// A slope through the origin that rises to the right, with its surface through the origin.
class Slope {
public:
    Slope(double angle, int rate, Blueprint plan, double gap)
        : world({.tickRate = rate, .sleeping = false}),
          along(std::cos(angle), std::sin(angle)),
          up_(-along.y(), along.x()) {
        Blueprint ground = shapes::floor({-60, 0}, {60, 0});
        ground.material = rough;
        world.add(ground, {.position = -0.05 * up_, .angle = angle});
        double lowest = 0;
        for (const JointSpec& joint : plan.joints)
            for (const std::uint32_t end : {joint.a, joint.b})
                lowest = std::min(
                    lowest, static_cast<double>(plan.particles[end].position[1] - joint.radius));
        plan.material = rough;
        body = world.add(plan, {.position = (gap - lowest) * up_, .angle = angle});
    }
    /// How far the body goes in `seconds`, m, positive up the slope.
    double way(double seconds) {
        const Point start = world.centreOfMass(body);
        test::run(world, seconds);
        return (world.centreOfMass(body) - start).dot(along);
    }

    World world;
    Body body;
    Point along;

private:
    Point up_;
};

struct Thing {
    Blueprint plan;
    double steepest;  // rad, of a slope on which it is to hold
};

/// All of them are too low to topple on these slopes.
std::vector<Thing> things() {
    std::vector<Vec2> hexagon;
    for (int i = 0; i < 6; ++i) {
        const double angle = (i + 0.5) * 1.0471975512;
        hexagon.push_back(
            {static_cast<Real>(0.5 * std::sin(angle)), static_cast<Real>(0.3 * std::cos(angle))});
    }
    return {{shapes::box({.size = {1, Real(0.4)}}), between},
            {shapes::box({.size = {2, Real(0.1)}, .mass = 20}), between},
            {shapes::polygon({.points = hexagon}), lower}};
}

/// Laid down on a slope at once it would swing, and ask for twice its weight along it.
Thing softThing() {
    return {shapes::jelly({.size = {1, Real(0.4)}, .stiffness = 20000, .damping = 20}), lower};
}

/// Laid down from rest, the blow along the slope is tan(angle) of the blow across it, which is less
/// than the static coefficient: it sticks from the first tick on.
TEST(StaticFriction, WhatIsPutDownHolds) {
    for (const auto& [plan, steepest] : things())
        for (const int rate : {60, 240, 500, 2000})
            for (const double gap : {0.0, 0.0001, 0.001, 0.01}) {
                Slope slope(steepest, rate, plan, gap);
                slope.way(1);
                EXPECT_NEAR(slope.way(2), 0, 0.001)
                    << plan.name << ", " << rate << " Hz, put down from " << gap << " m";
            }
}

/// Shoved up the slope it is braked by g (sin + mu cos), stops after v^2 / 2 of that, and stays.
TEST(StaticFriction, WhatComesToRestGoingUpHolds) {
    for (const int rate : {120, 500, 2000})
        for (const double speed : {1.0, 4.0}) {
            Slope slope(between, rate, things().front().plan, 0);
            slope.world.setVelocity(slope.body, (speed * slope.along).cast<Real>());
            const double mu = static_cast<double>(rough.kineticFriction);
            const double braking = standardGravity * (std::sin(between) + mu * std::cos(between));
            const double seconds = speed / braking;
            const double way = slope.way(seconds);
            const auto what = testing::Message() << rate << " Hz, " << speed << " m/s";
            EXPECT_NEAR(way, speed * speed / 2 / braking, 0.03 * way) << what;
            slope.way(0.5);
            EXPECT_NEAR(slope.way(2), 0, 0.001) << what;
        }
}

/// What rests on the level still rests when the level slowly becomes a slope.
TEST(StaticFriction, WhatRestsHoldsWhenTheGroundIsTilted) {
    std::vector<Thing> all = things();
    all.push_back(softThing());
    for (const auto& [plan, steepest] : all)
        for (const int rate : {60, 500}) {
            Slope slope(0, rate, plan, 0.002);
            slope.way(2);
            constexpr int stages = 100;
            for (int i = 1; i <= stages; ++i) {
                const double angle = steepest * i / stages;
                slope.world.setGravity({static_cast<Real>(-standardGravity * std::sin(angle)),
                                        static_cast<Real>(-standardGravity * std::cos(angle))});
                slope.way(0.02);
            }
            slope.way(1);
            EXPECT_NEAR(slope.way(2), 0, 0.001) << plan.name << ", " << rate << " Hz";
        }
}

/// Beyond the static angle it goes, with the kinetic coefficient: g (sin - mu cos) t^2 / 2.
TEST(StaticFriction, WhatIsPutDownOnSteeperGroundSlides) {
    for (const int rate : {60, 240, 500, 2000})
        for (const double gap : {0.0, 0.001}) {
            Slope slope(above, rate, things().front().plan, gap);
            const double mu = static_cast<double>(rough.kineticFriction);
            const double expected =
                standardGravity * (std::sin(above) - mu * std::cos(above)) * 2 * 2 / 2;
            EXPECT_NEAR(slope.way(2), -expected, 0.03 * expected) << rate << " Hz, " << gap << " m";
        }
}

/// A stack of three that is put down on the slope goes down as little as a single one.
TEST(StaticFriction, AStackThatIsPutDownHolds) {
    for (const int rate : {120, 500}) {
        Slope slope(between, rate, things()[1].plan, 0.0005);
        const Point up(-slope.along.y(), slope.along.x());
        Blueprint plank = things()[1].plan;
        plank.material = rough;
        for (int i = 1; i < 3; ++i)
            slope.world.add(plank,
                            {.position = slope.world.centreOfMass(slope.body) + 0.1005 * i * up,
                             .angle = between});
        slope.way(1);
        EXPECT_NEAR(slope.way(2), 0, 0.001) << rate << " Hz";
    }
}

constexpr double pegRadius = 0.3, ropeRadius = 0.015;  // m
const Material even{.staticFriction = Real(0.3), .kineticFriction = Real(0.3)};

/// A rope over the upper half of a peg at the origin, which its links touch in their middles.
Blueprint ropeOverPeg(double frontLoad, double backLoad, double linkMass = 0.001) {
    constexpr double link = 0.05;  // m
    constexpr int half = 40;       // links
    const double around = std::hypot(pegRadius + ropeRadius, link / 2);
    const double turn = 2 * std::asin(link / 2 / around);
    const double quarter = std::floor(std::acos(-1) / 2 / turn) * turn;
    Blueprint rope;
    rope.material = even;
    for (int i = -half; i <= half; ++i) {
        const double angle = std::abs(i) * turn, on = std::min(angle, quarter);
        const double hangs = (angle - on) / turn * link;
        rope.particles.push_back(
            {.position = {std::copysign(around * std::sin(on), i), around * std::cos(on) - hangs},
             .mass = static_cast<Real>(linkMass)});
    }
    rope.particles.front().mass = static_cast<Real>(frontLoad);
    rope.particles.back().mass = static_cast<Real>(backLoad);
    for (std::uint32_t i = 0; i < 2 * half; ++i)
        rope.joints.push_back({.a = i, .b = i + 1, .radius = Real(ropeRadius)});
    return rope;
}

/// How far the front end of a rope with these loads goes in a second, m.
double wayOverDisc(double front, double back, double linkMass, int rate = 500) {
    World world({.tickRate = rate});
    Blueprint disc;
    disc.kind = BodyKind::fixed;
    disc.material = even;
    disc.particles.push_back({.position = {0, 0}, .radius = Real(pegRadius)});
    world.add(disc);
    const Body rope = world.add(ropeOverPeg(front, back, linkMass));
    const double start = world.position(rope.front())[1];
    test::run(world, 1);
    return start - world.position(rope.front())[1];
}

/// What is round and stands fast rubs at its surface, and bears exp(mu pi) = 2.57 times a load
/// (Euler). It rubbed at its centre, about which a link turns without a slip: the rope ran over it
/// as over a pulley, 0.9 m in the first second.
TEST(StaticFriction, ARopeIsHeldByADiscThatStandsFast) {
    EXPECT_NEAR(wayOverDisc(2, 1, 0.001), 0, 0.001);
    EXPECT_GT(wayOverDisc(3, 1, 0.001), 0.2);
}

/// Rows that began a step took a light link for free, and took nearly all of their impulses back:
/// the rope crept, by 14 cm in the second under twice the load.
TEST(StaticFriction, ALightRopeDoesNotCreepOverADisc) {
    for (const int rate : {60, 240, 500, 1000}) {
        for (const double ratio : {1.0, 1.5, 2.0})
            EXPECT_NEAR(wayOverDisc(ratio, 1, 0.001, rate), 0, 0.003) << ratio << ", " << rate;
        EXPECT_NEAR(wayOverDisc(22, 10, 0.01, rate), 0, 0.003) << rate;
        EXPECT_NEAR(wayOverDisc(15, 10, 0.001, rate), 0, 0.003) << rate;
    }
}

/// Atwood's machine. A contact between the rope and what is attached was no row of the rope, only
/// of what is attached, which could not have it: the rim ran 4 to 7 % too fast.
TEST(StaticFriction, ARopeTurnsAWheelOnAnAxle) {
    constexpr double heavy = 10, light = 8, disc = 4;  // kg
    for (const int rate : {60, 240, 500, 1000, 2000}) {
        World world({.tickRate = rate});
        Blueprint wheel, axle{.kind = BodyKind::fixed, .particles = {{}}};
        wheel.material = even;
        wheel.particles.push_back({.mass = Real(disc), .radius = Real(pegRadius)});
        const Body turning = world.add(wheel), held = world.add(axle);
        world.attach(turning.front(), held, {0, 0});
        const Body rope = world.add(ropeOverPeg(heavy, light, 0.005));
        const double start = world.position(rope.back()).y();
        test::run(world, 0.5);
        constexpr double around = pegRadius + ropeRadius, lever = pegRadius / around;
        const double expected = 0.5 * 0.5 * 0.5 * standardGravity * (heavy - light) /
                                (heavy + light + 0.4 + disc / 2 * lever * lever);  // m
        EXPECT_NEAR((world.position(rope.back()).y() - start) / expected, 1, 0.03) << rate;
        EXPECT_NEAR(turning.angle() * around / expected, 1, 0.03) << rate;
    }
}

/// A wheel that its caller turns takes a rope with it, however round its corners are: their surface
/// goes as fast as the wheel turns, not as their centres.
TEST(StaticFriction, ARopeIsTakenAlongByAWheelThatIsTurned) {
    constexpr int sides = 24;
    constexpr double spin = 0.5;  // rad/s
    for (const double corner : {0.01, 0.05, 0.1}) {
        World world;
        Blueprint plan;
        plan.kind = BodyKind::kinematic;
        plan.material = even;
        for (std::uint32_t i = 0; i < sides; ++i) {
            const double angle = -2 * std::acos(-1) * i / sides, size = pegRadius - corner;
            plan.particles.push_back(
                {.position = {size * std::cos(angle), size * std::sin(angle)}});
            plan.joints.push_back(
                {.a = i, .b = (i + 1) % sides, .radius = static_cast<Real>(corner)});
        }
        const Body wheel = world.add(plan);
        const Body rope = world.add(ropeOverPeg(1, 1));
        const double start = world.position(rope.front())[1];
        for (int tick = 1; tick <= 500; ++tick) {
            world.moveTo(wheel, {.position = {0, 0}, .angle = spin * tick / 500});
            world.step();
        }
        const double way = start - world.position(rope.front())[1];
        EXPECT_NEAR(way, spin * (pegRadius + ropeRadius), 0.01) << corner << " m";
    }
}

}  // namespace
}  // namespace sulfur
