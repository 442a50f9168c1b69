#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

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

/// A disc and a rectangle. How deep they are in each other, m.
double overlap(const World& world, const Body& disc, double radius, const Body& box,
               const Point& half) {
    const Point u = (world.position(box[1]) - world.position(box[0])).normalized();
    const Point from = world.position(disc.front()) - world.centreOfMass(box);
    const Point beside = Point(std::abs(from.dot(u)), std::abs(cross(u, from))) - half;
    const double outside = beside.cwiseMax(0.0).norm();
    return radius - (outside > 0 ? outside : beside.maxCoeff());
}

/// Long things that turn were held back as if the axis between them did not turn with them: into
/// others, by up to their whole thickness.
TEST(Continuous, WhatTurnsIsNotHeldBackIntoOthers) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        World world;
        test::Random random(seed);
        world.add(shapes::floor(Vec2(-9, 0), Vec2(9, 0), Real(0.5)));
        world.add(shapes::floor(Vec2(-8, 0), Vec2(-8, 60), Real(0.2)));
        world.add(shapes::floor(Vec2(8, 60), Vec2(8, 0), Real(0.2)));
        struct Member {
            Body body;
            Point half;  // m
        };
        std::vector<Member> boxes, discs;
        for (int column = 0; column < 10; ++column)
            for (int row = 0; row < 14; ++row) {
                const Point place(1.5 * (column - 4.5) + (row % 2 == 0 ? -0.1 : 0.1),
                                  1.65 * row + 6);
                const Point half(random.uniform(0.1, 0.45), random.uniform(0.5, 0.75));
                const double radius = random.uniform(0.25, 0.7);
                if ((column + row) % 3 == 0)
                    discs.push_back({world.add(shapes::ball({.radius = static_cast<Real>(radius)}),
                                               {.position = place}),
                                     Point(radius, radius)});
                else
                    boxes.push_back({world.add(shapes::box({.size = (2 * half).cast<Real>(),
                                                            .radius = Real(0.01)}),
                                               {.position = place}),
                                     half});
            }
        for (int tick = 0; tick < 1400; ++tick) {
            world.step();
            if (tick % 10 != 0) continue;
            for (const Member& disc : discs)
                for (const Member& box : boxes)
                    ASSERT_LT(overlap(world, disc.body, disc.half.x(), box.body, box.half), 0.04)
                        << "seed " << seed << ", tick " << tick;
        }
    }
}

}  // namespace
}  // namespace sulfur
