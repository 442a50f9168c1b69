// What is driven pushes no faster than it goes.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "battery/random/momenta.hpp"
#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr double squeezed = 1.25;  // the share that a squeeze between others may add to a speed

/// The largest speed of the centre of any body that moves by itself.
double fastest(const World& world) {
    double most = 0;
    for (const BodyId id : world.bodies())
        if (world.kind(id) == BodyKind::dynamic)
            most = std::max(most, static_cast<double>(world.meanVelocity(id).norm()));
    return most;
}

/// Squares in a ring, in which a rod turns about its middle.
class Mixer {
public:
    Mixer(int rate, Real restitution) : world({.gravity = {0, 0}, .tickRate = rate}) {
        const Material material{.restitution = restitution};
        shapes::GroundOptions ring{.closed = true, .radius = Real(0.1), .material = material};
        for (int i = 0; i < 64; ++i) {
            const double angle = i * 2 * std::numbers::pi / 64;
            ring.points.push_back({static_cast<Real>(wall * std::cos(angle)),
                                   static_cast<Real>(wall * std::sin(angle))});
        }
        world.add(shapes::ground(ring));
        Blueprint plan = shapes::box({.size = {20, Real(0.4)}, .material = material});
        plan.kind = BodyKind::kinematic;
        rod_ = world.add(plan);
        fill(material);
    }
    void step() {
        angle_ += omega / world.settings().tickRate;
        world.moveTo(rod_, {.position = {0, 0}, .angle = angle_});
        world.step();
    }
    /// The largest distance of a centre from the middle.
    double farthest() const {
        double most = 0;
        for (const BodyId id : world.bodies())
            if (world.kind(id) == BodyKind::dynamic)
                most = std::max(most, world.centreOfMass(id).norm());
        return most;
    }

    static constexpr double omega = 10, wall = 12;  // rad/s, m
    static constexpr double tip = omega * 10;       // m/s
    World world;

private:
    /// 400 squares of 0.4 m on a lattice of 0.85 m, apart from the rod.
    void fill(const Material& material) {
        int count = 0;
        for (int row = 1; row <= 14; ++row)
            for (int column = -14; column <= 14; ++column)
                for (const int side : {-1, 1}) {
                    const Point place(0.85 * 0.9 * column, side * (0.2 + 0.85 * 0.9 * row));
                    if (place.norm() > wall - 0.6 || count == 400) continue;
                    world.add(shapes::box({.size = {Real(0.4), Real(0.4)}, .material = material}),
                              {.position = place});
                    ++count;
                }
        EXPECT_EQ(count, 400);
    }
    Body rod_;
    double angle_ = 0;
};

/// How fast a rod throws at most, as a share of its tip's speed: along its normal 1 + e, and along
/// itself what slides out as a bead on a wire. That obeys r'' = w^2 r - 2 mu w r', because the rod
/// presses with 2 m w r', and so comes to r' = (sqrt(1 + mu^2) - mu) w r.
double slidesOut() {
    const double mu = static_cast<double>(Material{}.kineticFriction);
    return std::sqrt(1 + mu * mu) - mu;
}
double throwsAt(Real restitution) {
    return std::hypot(1 + static_cast<double>(restitution), slidesOut());
}

/// Its inner edge leaves last, when its middle is a little beyond the tip.
TEST(KinematicCrowd, WhatSlidesOutAlongARodLeavesFasterThanItsTip) {
    for (const int rate : {500, 2000}) {
        World world({.gravity = {0, 0}, .tickRate = rate});
        Blueprint plan = shapes::box({.size = {20, Real(0.4)}});
        plan.kind = BodyKind::kinematic;
        const Body rod = world.add(plan);
        const Body bead =
            world.add(shapes::box({.size = {Real(0.4), Real(0.4)}}), {.position = {1, 0.4}});
        double angle = 0;
        while (world.centreOfMass(bead).norm() < 15 && angle < 10) {
            angle += Mixer::omega / rate;
            world.moveTo(rod, {.position = {0, 0}, .angle = angle});
            world.step();
        }
        EXPECT_NEAR(static_cast<double>(world.meanVelocity(bead).norm()),
                    std::hypot(1, slidesOut()) * Mixer::tip, 0.05 * Mixer::tip)
            << rate << " Hz";
    }
}

void expectNobodyFasterThanTheRodThrows(int rate, Real restitution) {
    Mixer mixer(rate, restitution);
    double most = 0;
    for (int i = 0; i < rate; ++i) {
        mixer.step();
        most = std::max(most, fastest(mixer.world));
    }
    const auto what = testing::Message() << rate << " Hz, e = " << restitution;
    EXPECT_LT(most, squeezed * throwsAt(restitution) * Mixer::tip) << what;
    EXPECT_LT(mixer.farthest(), Mixer::wall) << what;
    EXPECT_EQ(mixer.world.validate(), "") << what;
}

TEST(KinematicCrowd, NobodyIsFasterThanTheRodThrows) {
    for (const Real restitution : {Real(0), Real(0.5)})
        for (const int rate : {60, 120, 500}) expectNobodyFasterThanTheRodThrows(rate, restitution);
}

/// A piston goes at crates before a wall, until there is less room than they need, and back. What
/// is pressed may give way into what presses it; it takes no speed from that.
void expectThatThePressedGainNothing(int rate, double speed, int crates) {
    World world({.gravity = {0, 0}, .tickRate = rate});
    world.add(shapes::ground({.points = {{0, -3}, {0, 3}, {-9, 3}, {-9, -3}}, .closed = true}));
    Blueprint plan = shapes::box({.size = {1, 2}});
    plan.kind = BodyKind::kinematic;
    const Body piston = world.add(plan, {.position = {-7, 0}});
    for (int i = 0; i < crates; ++i)
        world.add(shapes::box({.size = {Real(0.5), Real(0.5)}}),
                  {.position = {-0.4 - 0.52 * i, 0.02 * i}});
    // The room that is left for them at last: four fifths of what they need.
    const double end = -0.05 - 0.4 * crates - 0.5;
    double x = -7, most = 0;
    bool back = false;
    while (x > -7.5) {
        x += (back ? -speed : speed) / rate;
        back = back || x >= end;
        world.moveTo(piston, {.position = {std::min(x, end), 0}});
        world.step();
        most = std::max(most, fastest(world));
    }
    EXPECT_LT(most, squeezed * speed)
        << rate << " Hz, " << speed << " m/s, " << crates << " crates";
}

TEST(KinematicCrowd, WhatIsPressedAgainstAWallGainsNothing) {
    for (const double speed : {1.0, 10.0, 50.0}) {
        for (const int rate : {60, 240, 500, 2000}) expectThatThePressedGainNothing(rate, speed, 1);
        for (const int rate : {60, 240, 500}) expectThatThePressedGainNothing(rate, speed, 3);
    }
    for (const double speed : {10.0, 50.0}) expectThatThePressedGainNothing(2000, speed, 3);
}

/// Blows go to and fro between the piston and the wall, until a crate that they turn is thrown.
TEST(KinematicCrowd, DISABLED_WhatIsPressedSlowlyAt2000HzGainsNothing) {
    expectThatThePressedGainNothing(2000, 1, 3);
}

/// The ideal case: a paddle meets a ball at rest, which leaves at (1 + e) times its speed.
TEST(KinematicCrowd, APaddleThrowsABallAtOnePlusETimesItsSpeed) {
    for (const int rate : {60, 500, 2000})
        for (const double e : {0.0, 0.5, 1.0}) {
            World world({.gravity = {0, 0}, .tickRate = rate});
            Blueprint plan = shapes::box({.size = {1, 4}});
            plan.kind = BodyKind::kinematic;
            const Body paddle = world.add(plan, {.position = {-1, 0}});
            const Body ball =
                world.add(shapes::ball({.material = {.restitution = static_cast<Real>(e)}}));
            for (int i = 1; i <= rate / 10; ++i) {
                world.moveTo(paddle, {.position = {-1 + 20.0 * i / rate, 0}});
                world.step();
            }
            EXPECT_NEAR(static_cast<double>(world.meanVelocity(ball)[0]), 20 * (1 + e), 0.2)
                << rate << " Hz, e = " << e;
        }
}

}  // namespace
}  // namespace sulfur
