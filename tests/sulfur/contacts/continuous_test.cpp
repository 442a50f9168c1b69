#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr double ropeRadius = 0.015, rounding = 0.02;  // m, the latter of the crate's corners

/// The deepest overlap, m, of a rope with a fixed crate of 1 m about the origin, over whose edges
/// it slides for half a second between loads of 5 kg and `heavy` kg.
double overlapOfSlidingRope(int rate, double heavy) {
    World world({.tickRate = rate});
    Blueprint block = shapes::box({.mass = 10, .radius = static_cast<Real>(rounding)});
    block.kind = BodyKind::fixed;
    world.add(block);
    constexpr double side = 0.5 + ropeRadius + 0.005, low = -1.5;
    const std::array<Point, 4> corners{Point(-side, low), Point(-side, side), Point(side, side),
                                       Point(side, low)};
    Blueprint plan;
    plan.particles.push_back({.position = corners[0].cast<Real>()});
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const Point way = corners[i + 1] - corners[i];
        const auto links = std::lround(way.norm() / 0.05);
        for (long k = 1; k <= links; ++k)
            plan.particles.push_back({.position = (corners[i] + way * k / links).cast<Real>()});
    }
    for (ParticleSpec& p : plan.particles)
        p.mass = static_cast<Real>(0.5 / static_cast<double>(plan.particles.size()));
    for (std::uint32_t i = 0; i + 1 < plan.particles.size(); ++i)
        plan.joints.push_back({.a = i, .b = i + 1, .radius = static_cast<Real>(ropeRadius)});
    const Body rope = world.add(plan);
    for (const double sign : {-1.0, 1.0}) {
        const double mass = sign < 0 ? 5 : heavy;
        const Body load = world.add(
            shapes::box({.size = {Real(0.5), Real(0.5)}, .mass = static_cast<Real>(mass)}),
            {.position = Point(sign * side, low - 0.23)});
        world.attach(sign < 0 ? rope.front() : rope.back(), load, Vec2(0, Real(0.23)));
    }
    double nearest = 1;  // m, of the rope's axis to what is left of the crate without its rounding
    for (int tick = 0; tick < rate / 2; ++tick) {
        world.step();
        for (const JointId id : rope.joints()) {
            const JointInfo link = world.info(id);
            for (const double share : {0.0, 0.25, 0.5, 0.75}) {
                const Point a = world.position(link.a), b = world.position(link.b);
                const Point p = a + share * (b - a);
                const Point beside = p.cwiseAbs() - Point::Constant(0.5 - rounding);
                nearest = std::min(nearest, beside.cwiseMax(0.0).norm());
            }
        }
    }
    return rounding + ropeRadius - nearest;
}

/// A rope that was held back as a whole, because one link of it would have passed the edge, went
/// on as its centre of mass did, by up to 6 cm into the crate.
TEST(Continuous, ARopeThatIsHeldBackAtAnEdgeStaysOutOfTheCrate) {
    for (const int rate : {60, 500})
        for (double heavy = 90; heavy <= 110; heavy += 2.5)
            EXPECT_LT(overlapOfSlidingRope(rate, heavy), 0.01)
                << heavy << " kg at " << rate << " Hz";
}

/// What meets the corners of something thick, and none of its sides, is stopped too.
TEST(Continuous, CornersOfAJellyDoNotEndInABallThatTheyHitAt150MetresASecond) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> between(-1, 1);
    for (int shot = 0; shot < 40; ++shot) {
        World world({.gravity = {0, 0}});
        const Body ball = world.add(shapes::ball({.radius = Real(0.5), .mass = 5}));
        const Body jelly =
            world.add(shapes::jelly({.size = {Real(0.4), Real(0.4)}, .stiffness = 10000}),
                      {.position = {0.3 * between(random), 1.5}, .angle = 3 * between(random)});
        world.setVelocity(jelly, {0, -150});
        for (int tick = 0; tick < 8; ++tick) {
            world.step();
            for (const JointId id : jelly.joints()) {
                const JointInfo joint = world.info(id);
                if (joint.radius == 0) continue;
                const double away = (world.position(joint.a) - world.position(ball.front())).norm();
                ASSERT_GT(away, 0.4) << "shot " << shot << ", tick " << tick;
            }
        }
    }
}

}  // namespace
}  // namespace sulfur
